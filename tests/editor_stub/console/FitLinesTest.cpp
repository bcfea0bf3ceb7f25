#include "console/FitLines.h"

#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <sstream>
#include <vector>

namespace limn::test
{

namespace
{

std::vector<std::string> WordsOf(const std::string& text)
{
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

} // namespace

TEST(FitLines, LeavesLinesThatFitAsTheyAre)
{
    const std::string text = "a  b   c\n\n   \nthe last line has no end";
    EXPECT_EQ(text, FitLines(text, 24));
    EXPECT_EQ("", FitLines("", 24));
    EXPECT_EQ("\n\n", FitLines("\n\n", 24));
}

TEST(FitLines, GoesOnTwoColumnsRightOfTheBeginning)
{
    EXPECT_EQ("  one two\n"
              "    three\n"
              "    four\n"
              "next\n",
              FitLines("  one two three four\nnext\n", 10));
}

TEST(FitLines, GoesOnBelowTheSecondColumn)
{
    EXPECT_EQ("driver    the software\n"
              "          device of\n"
              "          Mesa\n",
              FitLines("driver    the software device of Mesa\n", 22));
}

TEST(FitLines, GoesOnNearTheBeginningWhereTheSecondColumnIsFarRight)
{
    EXPECT_EQ("a_long_first_column\n"
              "  one two three\n",
              FitLines("a_long_first_column  one two three\n", 26));
    EXPECT_EQ("a_long_first_column  one\n"
              "  two three four five six\n"
              "  seven\n",
              FitLines("a_long_first_column  one two three four five six seven\n", 26));
}

TEST(FitLines, MovesTheColumnsOfAWholeTableTogether)
{
    EXPECT_EQ("  m_A    1  px  set  Wide\n"
              "  m_Box  {r: 1, g: 1}\n"
              "         default 3  Tall\n"
              "other\n",
              FitLines("  m_A    1             px         set  Wide\n"
                       "  m_Box  {r: 1, g: 1}  default 3       Tall\n"
                       "other\n",
                       26));
}

TEST(FitLines, DoesNotBreakACellThatFitsIntoALine)
{
    EXPECT_EQ("name  one two\n"
              "      three four\n",
              FitLines("name  one two  three four\n", 18));
}

TEST(FitLines, KeepsLongWordsWhole)
{
    EXPECT_EQ("see\n"
              "  /a/very/long/path/of/a/file\n"
              "  for it\n",
              FitLines("see /a/very/long/path/of/a/file for it\n", 12));
}

TEST(FitLines, KeepsAllWordsInOrderInLinesThatFit)
{
    std::mt19937 random(7);
    const auto upTo = [&random](unsigned most)
    {
        return static_cast<std::size_t>(random() % (most + 1));
    };
    for (int round = 0; round < 2000; ++round)
    {
        std::string text;
        for (std::size_t i = upTo(40); i > 0; --i)
        {
            text += std::string(upTo(2) == 0 ? upTo(12) : 1, ' ') + std::string(upTo(9), 'x') +
                    (upTo(7) == 0 ? "\n" : "ö");
        }
        const std::size_t width = 1 + upTo(50);
        const std::string fitted = FitLines(text, width);
        EXPECT_EQ(WordsOf(text), WordsOf(fitted)) << text;
        std::istringstream lines(fitted);
        for (std::string line; std::getline(lines, line);)
        {
            EXPECT_TRUE(ColumnsOf(line) <= width || WordsOf(line).size() <= 1)
                << width << ": " << line;
        }
    }
}

TEST(FitLines, CountsCharactersAndNoColours)
{
    EXPECT_EQ("ö → ü ä ö\n", FitLines("ö → ü ä ö\n", 9));
    const std::string colored = "\033[31merror\033[0m: no\n";
    EXPECT_EQ(colored, FitLines(colored, 9));
    EXPECT_EQ("\033[31merror\033[0m:\n  no\n", FitLines(colored, 8));
}

TEST(CutLine, EndsInThreeDotsWhereItIsCut)
{
    EXPECT_EQ("öäüß", CutLine("öäüß", 4));
    EXPECT_EQ("öä…", CutLine("öäüß", 3));
    EXPECT_EQ("…", CutLine("öäüß", 1));
}

} // namespace limn::test

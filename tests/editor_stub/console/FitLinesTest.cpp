#include "console/FitLines.h"

#include <gtest/gtest.h>

namespace limn::test
{

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

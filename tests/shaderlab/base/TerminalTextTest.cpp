#include <limn/base/Diagnostic.h>
#include <limn/base/TerminalText.h>

#include <gtest/gtest.h>

namespace limn
{
namespace
{

TEST(OneLine, KeepsWhatATerminalCanShow)
{
    EXPECT_EQ(OneLine("Möbel 'a\\b' \"→ 😀\""), "Möbel 'a\\b' \"→ 😀\"");
    EXPECT_EQ(OneLine(""), "");
}

TEST(OneLine, EscapesCommandsToTheTerminalAndLineBreaks)
{
    EXPECT_EQ(OneLine("a\nb\r\tc"), "a\\nb\\r\\tc");
    EXPECT_EQ(OneLine("\x1B[2J\x7F"), "\\x1B[2J\\u007F") << "a character that JSON leaves alone";
    EXPECT_EQ(OneLine(std::string_view("a\0b", 3)), "a\\x00b");
    EXPECT_EQ(OneLine("\xC2\x9B|"), "\\u009B|") << "CSI as one character";
    EXPECT_EQ(OneLine("\xE2\x80\xAE|\xE2\x80\xA8|\xE2\x81\xA6"), "\\u202E|\\u2028|\\u2066");
}

TEST(OneLine, EscapesMarksOfDirectionAndWhatIsNowhereToBeSeen)
{
    EXPECT_EQ(OneLine("\xE2\x80\x8F|\xE2\x80\x8E|\xD8\x9C"), "\\u200F|\\u200E|\\u061C");
    EXPECT_EQ(OneLine("\xE2\x80\x8B|\xE2\x81\xA0|\xEF\xBB\xBF"), "\\u200B|\\u2060|\\uFEFF");
    EXPECT_EQ(OneLine("\xE2\x80\x8D"), "\xE2\x80\x8D") << "which joins the parts of an emoji";
}

TEST(OneLine, EscapesBytesThatAreNoUtf8)
{
    EXPECT_EQ(OneLine("\xC3(\x80\xE2\x82"), "\\xC3(\\x80\\xE2\\x82");
    EXPECT_EQ(OneLine("\xED\xA0\x80"), "\\xED\\xA0\\x80") << "half a surrogate pair";
    EXPECT_EQ(OneLine("\xC0\xAF"), "\\xC0\\xAF") << "a '/' in two bytes";
}

TEST(SeveralLines, KeepsLineBreaksAndTabs)
{
    EXPECT_EQ(SeveralLines("a\n\tb\x1B[m\r"), "a\n\tb\\x1B[m\\r");
}

TEST(Shortened, KeepsBothEndsAndWholeCharacters)
{
    EXPECT_EQ(Shortened("12345678", 8), "12345678");
    EXPECT_EQ(Shortened("123456789", 8), "123456…89");
    // A cut between characters of two bytes, and one inside of them.
    EXPECT_EQ(Shortened("äöüäöüä", 8), "äöü…ä");
    EXPECT_EQ(Shortened("1äöüäöü", 8), "1äö…ü");
    EXPECT_EQ(Shortened(std::string(1000, '\x80'), 8).size(), 11u);
}

TEST(Sentence, ShortensLongWordsOnly)
{
    const std::string words(300, ' ');
    EXPECT_EQ(Sentence(words + "'a' is unknown"), words + "'a' is unknown");
    EXPECT_EQ(Sentence("'" + std::string(100000, 'x') + "' is no number"),
              "'" + std::string(191, 'x') + "…" + std::string(63, 'x') + "' is no number");
}

TEST(Diagnostic, CannotBeForgedByANameInAFile)
{
    const std::string name = "x\n/etc/passwd:1:1: error: \x1B[31mhello";
    EXPECT_EQ(ToString({Severity::Error, name, {1, 2}, "unknown '" + name + "'"}),
              "x\\n/etc/passwd:1:1: error: \\x1B[31mhello:1:2: error: unknown "
              "'x\\n/etc/passwd:1:1: error: \\x1B[31mhello'");
}

} // namespace
} // namespace limn

#include <limn/base/Diagnostic.h>

#include <gtest/gtest.h>

#include <string>

namespace limn
{
namespace
{

TEST(Diagnostic, IsWrittenAsFileLineColumnSeverityMessage)
{
    EXPECT_EQ(ToString({Severity::Warning, "a.shader", {3, 7}, "x: y"}),
              "a.shader:3:7: warning: x: y");
    EXPECT_EQ(ToString({Severity::Note, "a.shader", {3, 7}, "x"}), "a.shader:3:7: note: x");
}

TEST(Diagnostic, LeavesOutAPlaceOfZero)
{
    EXPECT_EQ(ToString({Severity::Error, "a.shader", {3, 0}, "x"}), "a.shader:3: error: x");
    EXPECT_EQ(ToString({Severity::Error, "a.shader", {}, "x"}), "a.shader: error: x");
}

TEST(ToStringWithSource, ShowsTheLineAndACaretUnderTheColumn)
{
    const std::string text = "Shader \"x\"\r\n{\r\n\tCull\t\xC3\xA4 Bak\r\n}";
    EXPECT_EQ(ToStringWithSource({Severity::Error, "a", {3, 10}, "x"}, text),
              "a:3:10: error: x\n\tCull\t\xC3\xA4 Bak\n\t    \t  ^");
    EXPECT_EQ(ToStringWithSource({Severity::Error, "a", {1, 1}, "x"}, "\xEF\xBB\xBFSh"),
              "a:1:1: error: x\nSh\n^");
}

TEST(ToStringWithSource, LeavesOutALineThatIsNotThere)
{
    EXPECT_EQ(ToStringWithSource({Severity::Note, "a", {}, "x"}, "abc"), "a: note: x");
    EXPECT_EQ(ToStringWithSource({Severity::Note, "a", {5, 1}, "x"}, "abc\n"), "a:5:1: note: x");
    EXPECT_EQ(ToStringWithSource({Severity::Note, "a", {1, 0}, "x"}, "abc"), "a:1: note: x\nabc");
}

TEST(ToStringWithSource, ShowsTheNeighbourhoodOfAColumnInALongLine)
{
    const std::string text = std::string(300, 'a') + "!" + std::string(300, 'b');
    EXPECT_EQ(ToStringWithSource({Severity::Error, "f", {1, 301}, "x"}, text),
              "f:1:301: error: x\n..." + std::string(80, 'a') + "!" + std::string(79, 'b') +
                  "...\n" + std::string(83, ' ') + "^");
}

TEST(ToStringWithSource, ShowsBytesThatCannotBePrintedAsReplacementCharacters)
{
    const std::string replaced = "\xEF\xBF\xBD"; // U+FFFD
    const auto shown = [](std::string_view line, int column)
    {
        const std::string all = ToStringWithSource({Severity::Error, "f", {1, column}, "x"}, line);
        return all.substr(all.find('\n') + 1);
    };
    // Escape, a zero byte, a lone lead byte, one inside no character, DEL.
    const std::string_view binary("a\x1B[\0\xC3(\x80\x7F!", 9);
    EXPECT_EQ(shown(binary, 9), "a" + replaced + "[" + replaced + replaced + "(" + replaced +
                                    replaced + "!\n        ^");
    // U+009B starts terminal commands as Escape [ does; it, a surrogate, an overlong '/', a
    // character cut off.
    EXPECT_EQ(shown("\xC2\x9B|\xED\xA0\x80|\xC0\xAF|\xE2\x82", 4),
              replaced + replaced + "|" + replaced + replaced + replaced + "|" + replaced +
                  replaced + "|" + replaced + replaced + "\n   ^");
    // Printable ones of two, three and four bytes are a column wide.
    EXPECT_EQ(shown("\xC2\xA0\xE2\x82\xAC\xF0\x9F\x98\x80!", 10),
              "\xC2\xA0\xE2\x82\xAC\xF0\x9F\x98\x80!\n   ^");
    // A long line of bytes that never start a character still has an end.
    EXPECT_EQ(shown(std::string(10000, '\x80'), 0).size(), 163 * 3u + 3);
}

TEST(NearestName, TakesNoVeryLongNameForATypo)
{
    EXPECT_EQ(NearestName(std::string(65, 'a'), {std::string_view("aaaa")}), "");
    EXPECT_EQ(UnknownName(std::string(70, 'a'), {"b"}),
              "'" + std::string(48, 'a') + "…" + std::string(16, 'a') + "' (known: b)");
}

TEST(AssetError, ShowsEveryDiagnosticOnALineOfItsOwn)
{
    const AssetError error({{Severity::Error, "a", {1, 2}, "x"}, {Severity::Error, "b", {}, "y"}});
    EXPECT_STREQ(error.what(), "a:1:2: error: x\nb: error: y");
    EXPECT_EQ(error.diagnostics().size(), 2u);
}

TEST(EditDistance, CountsLettersThatAreMissingChangedOrSwapped)
{
    EXPECT_EQ(EditDistance("", "abc"), 3u);
    EXPECT_EQ(EditDistance("abc", ""), 3u);
    EXPECT_EQ(EditDistance("c", "abc"), 2u);
    EXPECT_EQ(EditDistance("kitten", "sitting"), 3u);
    EXPECT_EQ(EditDistance("ab", "ba"), 1u);
}

TEST(NearestName, FindsTheNameWithTheFewestChangesInAnyCase)
{
    EXPECT_EQ(NearestName("ZWrit", {"ZTest", "ZWrite", "Cull"}), "ZWrite");
    EXPECT_EQ(NearestName("CULL", {"Cull"}), "Cull");
    EXPECT_EQ(NearestName("outlneWidht", {"outlineWidth"}),
              "outlineWidth"); // one left out, two swapped
}

TEST(NearestName, FindsNothingBeyondAThirdOfTheLength)
{
    EXPECT_EQ(NearestName("abcdef", {"abcxyz"}), ""); // three changes, two allowed
    EXPECT_EQ(NearestName("abcdef", {"abcdxy"}), "abcdxy");
    EXPECT_EQ(NearestName("ab", {"ax"}), "ax"); // one change is always allowed
    EXPECT_EQ(NearestName("a", {}), "");
}

TEST(NearestName, FindsTheOnlyNameThatGoesOn)
{
    EXPECT_EQ("StrokeOutlineFeature", NearestName("Stroke", {"StrokeOutlineFeature", "Bloom"}));
    EXPECT_EQ("", NearestName("Stroke", {"StrokeOutlineFeature", "StrokesOfAPainter"}));
    EXPECT_EQ("", NearestName("Str", {"StrokeOutlineFeature"})) << "too few letters";
}

TEST(UnknownName, AsksOnlyWhereSomethingIsNear)
{
    EXPECT_EQ(UnknownName("Culll", {"Cull", "Blend"}), "'Culll'; did you mean 'Cull'?");
    EXPECT_EQ(UnknownName("Foobar", {"Cull"}), "'Foobar' (known: Cull)");
}

} // namespace
} // namespace limn

#include <limn/shaderlab/Diagnostic.h>

#include <gtest/gtest.h>

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

TEST(AssetError, ShowsEveryDiagnosticOnALineOfItsOwn)
{
    const AssetError error({{Severity::Error, "a", {1, 2}, "x"}, {Severity::Error, "b", {}, "y"}});
    EXPECT_STREQ(error.what(), "a:1:2: error: x\nb: error: y");
    EXPECT_EQ(error.diagnostics().size(), 2u);
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

TEST(UnknownName, AsksOnlyWhereSomethingIsNear)
{
    EXPECT_EQ(UnknownName("Culll", {"Cull", "Blend"}),
              "'Culll'; did you mean 'Cull'? (known: Cull, Blend)");
    EXPECT_EQ(UnknownName("Foobar", {"Cull"}), "'Foobar' (known: Cull)");
}

} // namespace
} // namespace limn

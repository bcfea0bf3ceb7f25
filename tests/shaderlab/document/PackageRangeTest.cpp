#include <limn/shaderlab/PackageRange.h>

#include <gtest/gtest.h>

namespace limn
{

TEST(PackageRange, PlainVersionMeansThisOrLater)
{
    EXPECT_TRUE(isInPackageRange("14.0.0", "12"));
    EXPECT_TRUE(isInPackageRange("14.0.0", "14.0"));
    EXPECT_FALSE(isInPackageRange("14.0.0", "14.0.1"));
}

TEST(PackageRange, BracketsIncludeTheirEndAndParenthesesDoNot)
{
    EXPECT_TRUE(isInPackageRange("14.0.0", "[14.0]"));
    EXPECT_FALSE(isInPackageRange("14.0.1", "[14.0]"));
    EXPECT_TRUE(isInPackageRange("14.0.0", "[12,14]"));
    EXPECT_FALSE(isInPackageRange("14.0.0", "[12,14)"));
    EXPECT_FALSE(isInPackageRange("14.0.0", "(14,15)"));
    EXPECT_TRUE(isInPackageRange("14.0.1", "(14,15)"));
}

TEST(PackageRange, SemicolonJoinsSets)
{
    EXPECT_TRUE(isInPackageRange("14.0.0", "[10,11];[13,15]"));
    EXPECT_FALSE(isInPackageRange("12.0.0", "[10,11];[13,15]"));
}

TEST(PackageRange, PreviewSortsBeforeTheRelease)
{
    EXPECT_FALSE(isInPackageRange("2.0.0-preview.3", "2.0"));
    EXPECT_TRUE(isInPackageRange("2.0.0", "2.0.0-preview.3"));
}

TEST(PackageRange, EmptyRangeHoldsForAllAndUnreadableRangeForNone)
{
    EXPECT_TRUE(isInPackageRange("14.0.0", ""));
    EXPECT_FALSE(isInPackageRange("14.0.0", "x"));
}

TEST(PackageRange, CountsPreReleasesByTheirNumber)
{
    EXPECT_TRUE(isInPackageRange("2.0.0-preview.10", "2.0.0-preview.9"));
    EXPECT_FALSE(isInPackageRange("2.0.0-preview.9", "2.0.0-preview.10"));
    EXPECT_TRUE(isInPackageRange("2022.3.0b10", "2022.3.0b9"));
    EXPECT_TRUE(isInPackageRange("2022.3.0f1", "2022.3.0b10"));
}

} // namespace limn

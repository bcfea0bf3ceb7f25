#include "port/csharp/CSharpTokens.h"

#include <gtest/gtest.h>

namespace limn::test
{

TEST(CSharpConditions, VersionsOfUnityAreThoseUpToTheTarget)
{
    const CSharpTarget unity2022;
    for (const char* symbol :
         {"UNITY_2022_3_OR_NEWER", "UNITY_2022_1_OR_NEWER", "UNITY_2019_4_OR_NEWER",
          "UNITY_5_3_OR_NEWER", "UNITY_2022_3", "UNITY_2022", "UNITY_STANDALONE"})
    {
        EXPECT_TRUE(IsDefinedFor(symbol, unity2022)) << symbol;
    }
    for (const char* symbol :
         {"UNITY_2023_1_OR_NEWER", "UNITY_6000_0_OR_NEWER", "UNITY_2021_3", "UNITY_2021",
          "UNITY_2022_2", "UNITY_6000", "UNITY_EDITOR", "UNITY_EDITOR_WIN", "UNITY_ANDROID"})
    {
        EXPECT_FALSE(IsDefinedFor(symbol, unity2022)) << symbol;
    }
    EXPECT_TRUE(IsDefinedFor("UNITY_6000_0_OR_NEWER", {6000, 0, false}));
    EXPECT_FALSE(IsDefinedFor("UNITY_6000_2_OR_NEWER", {6000, 0, false}));
    EXPECT_FALSE(IsDefinedFor("UNITY_EDITOR", {6000, 0, true}));
}

TEST(CSharpConditions, VersionsOfUrpAreUnderstoodByWhateverName)
{
    const CSharpTarget unity2022;
    for (const char* symbol :
         {"URP_12_OR_NEWER", "URP_14_0_0_OR_NEWER", "UNIVERSAL_RP_10_OR_NEWER", "URP_7_1_OR_HIGHER",
          "USING_URP", "UNITY_PIPELINE_URP", "URP_COMPATIBILITY_MODE"})
    {
        EXPECT_TRUE(IsDefinedFor(symbol, unity2022)) << symbol;
    }
    for (const char* symbol : {"URP_15_OR_NEWER", "URP_17_0_OR_NEWER", "URP_12", "WITH_FOG"})
    {
        EXPECT_FALSE(IsDefinedFor(symbol, unity2022)) << symbol;
    }
    EXPECT_TRUE(IsDefinedFor("URP_17_0_OR_NEWER", {6000, 0, false}));
    EXPECT_FALSE(IsDefinedFor("URP_COMPATIBILITY_MODE", {6000, 0, false}));
    EXPECT_TRUE(IsDefinedFor("WITH_FOG", {2022, 3, true}));
}

} // namespace limn::test

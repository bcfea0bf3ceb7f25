#include "Mentions.h"
#include "ShaderTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> TextsOf(const ShaderLabPass& pass)
{
    std::vector<std::string> texts;
    for (const LegacyCommand& command : pass.legacyCommands)
    {
        texts.push_back(command.text);
    }
    return texts;
}

/// The legacy commands of a pass in canonical text; fails the test on an error.
std::vector<std::string> Legacy(const std::string& commands)
{
    const ShaderLabParseResult result = ParseShaderLab(test::WrapPass(commands), "t.shader");
    EXPECT_FALSE(result.hasErrors()) << testing::PrintToString(test::Messages(result.diagnostics));
    return TextsOf(result.document.subShaders.at(0).passes.at(0));
}

TEST(ShaderLabLegacy, KeepsSwitchesAndColors)
{
    EXPECT_THAT(Legacy("lighting false SeparateSpecular ON ColorMaterial ambientanddiffuse Color "
                       "[_Color] Color (1,.5,0.,[ _A ]) Lighting [_L]"),
                ElementsAre("Lighting Off", "SeparateSpecular On",
                            "ColorMaterial AmbientAndDiffuse", "Color [_Color]",
                            "Color (1, 0.5, 0, [_A])", "Lighting [_L]"));
}

TEST(ShaderLabLegacy, KeepsBlocks)
{
    EXPECT_THAT(
        Legacy("Material { Diffuse [_Color] EMISSION (0,0,0,0) shininess [_S] }\n"
               "Fog { mode exp2 Color (1,1,1) Density .25 Range 0, [_Far] } Fog {}\n"
               "BindChannels { Bind \"Vertex\", vertex Bind \"texcoord\", texcoord1 }"),
        ElementsAre("Material { Diffuse [_Color] Emission (0, 0, 0, 0) Shininess [_S] }",
                    "Fog { Mode Exp2 Color (1, 1, 1) Density 0.25 Range 0, [_Far] }", "Fog { }",
                    "BindChannels { Bind \"Vertex\", vertex Bind \"texcoord\", texcoord1 }"));
}

TEST(ShaderLabLegacy, KeepsAlphaTests)
{
    EXPECT_THAT(
        Legacy("AlphaTest Off AlphaTest False AlphaTest greater [_Cutoff] AlphaTest True .5 "
               "AlphaTest [_Op] 1"),
        ElementsAre("AlphaTest Off", "AlphaTest Off", "AlphaTest Greater [_Cutoff]",
                    "AlphaTest On 0.5", "AlphaTest [_Op] 1"));
}

TEST(ShaderLabLegacy, KeepsTextureCombiners)
{
    EXPECT_THAT(
        Legacy(
            "SetTexture [_A] SetTexture [_B] { } SetTexture [_C] { constantColor (1,1,1,[_B]) "
            "Matrix [unity_LightmapMatrix] combine texture*primary DOUBLE, constant }\n"
            "SetTexture [_D] { combine one - texture alpha lerp (previous alpha) constant quad }"
            "SetTexture [_E] { combine previous * texture +- primary, one-texture dot3 primary }"),
        ElementsAre("SetTexture [_A]", "SetTexture [_B] { }",
                    "SetTexture [_C] { ConstantColor (1, 1, 1, [_B]) Matrix [unity_LightmapMatrix] "
                    "Combine Texture * Primary Double, Constant }",
                    "SetTexture [_D] { Combine One - Texture Alpha Lerp (Previous Alpha) Constant "
                    "Quad }",
                    "SetTexture [_E] { Combine Previous * Texture +- Primary, One - Texture Dot3 "
                    "Primary }"));
}

TEST(ShaderLabLegacy, HandsCommandsOfOuterScopesToThePassesBehindThem)
{
    const ShaderLabParseResult result = ParseShaderLab(
        "Shader \"T\" { Category { Lighting Off SubShader { Pass { } Fog { Mode Off } Pass { "
        "Lighting On } } } }",
        "t.shader");
    const auto& passes = result.document.subShaders.at(0).passes;
    EXPECT_THAT(TextsOf(passes.at(0)), ElementsAre("Lighting Off"));
    EXPECT_THAT(TextsOf(passes.at(1)),
                ElementsAre("Lighting Off", "Fog { Mode Off }", "Lighting On"));
}

TEST(ShaderLabLegacy, IsNotedAsIgnoredBesideAProgramAndAsNotSynthesisedWithoutOne)
{
    EXPECT_THAT(
        test::ParseMessages("Shader \"T\" { SubShader {\nPass { Lighting Off Fog { Mode Off "
                            "} HLSLPROGRAM ENDHLSL }\nPass { Color (1,1,1,1) Color (0,0,0,0) "
                            "} Pass { } } }"),
        ElementsAre(test::Mentions("2:8: note: Lighting, Fog", "ignored", "has a program"),
                    test::Mentions("3:8: note: Color", "fixed-function", "HLSLPROGRAM")));
}

TEST(ShaderLabLegacy, IsNotedOnceForAllPassesThatACommandHoldsFor)
{
    EXPECT_THAT(
        test::ParseMessages("Shader \"T\" { SubShader { Lighting Off Pass { } Pass { } } }"),
        ElementsAre(test::Mentions("1:26: note: Lighting", "fixed-function")));
}

TEST(ShaderLabLegacy, ReportsMistakesAndGoesOn)
{
    EXPECT_THAT(
        test::ParseMessages("Shader \"T\" { SubShader { Pass {\nFog { Mod Off }\nSetTexture { "
                            "}\nSetTexture [_A] { Combine texure }\nColor (1,\nZWrite Off } } }"),
        ElementsAre(test::Mentions("2:1: note: Fog, SetTexture", "no program"),
                    test::Mentions("2:7: error: Fog", "command 'Mod'", "'Mode'"),
                    test::Mentions("3:12: error: SetTexture", "missing before '{'", "[_Property]"),
                    test::Mentions("4:27: error: Combine", "value 'texure'", "'Texture'"),
                    "6:1: error: Color: a number is missing before 'ZWrite'"));
}

TEST(ShaderLabLegacy, IsNoPartOfAPassThatHasNone)
{
    EXPECT_THAT(Legacy("Cull Off"), IsEmpty());
}

} // namespace
} // namespace limn

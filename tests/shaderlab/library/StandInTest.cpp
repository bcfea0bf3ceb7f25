#include "Mentions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/shaderlab/ShaderCompiler.h>
#include <limn/shaderlab/ShaderLabParser.h>

// What the ShaderLibrary does less of than Unity's says so where it is used.

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

/// What is noted of a shader whose fragment function gives the float3 `result`.
std::vector<std::string> NotesOf(const std::string& result,
                                 const std::vector<std::string>& keywords = {})
{
    const std::string text =
        "Shader \"Test\" { SubShader { Pass { HLSLPROGRAM\n"
        "#pragma vertex Vert\n#pragma fragment Frag\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl\"\n"
        "float4 Vert(float4 p : POSITION) : SV_POSITION { return p; }\n"
        "float4 Frag(float4 p : SV_POSITION) : SV_Target { return float4(" +
        result + ", 1); }\nENDHLSL } } }";
    const ShaderLabParseResult parsed = ParseShaderLab(text, "lit.shader");
    const auto compiled =
        ShaderCompiler().Compile(*parsed.document.subShaders.at(0).passes.at(0).program, keywords);
    std::vector<std::string> notes;
    for (const Diagnostic& diagnostic : compiled->diagnostics)
    {
        notes.push_back(ToString(diagnostic));
    }
    return notes;
}

const auto k_LightMaps = test::Mentions("lit.shader: note: it uses", "light maps", "white");
const auto k_Cookies = test::Mentions("lit.shader: note: it uses", "light cookies", "white");

TEST(StandIn, IsNotedWhereItIsUsed)
{
    EXPECT_THAT(NotesOf("SampleLightmap(p.xy, p.xyz)"), ElementsAre(k_LightMaps));
    EXPECT_THAT(NotesOf("SampleMainLightCookie(p.xyz)"), ElementsAre(k_Cookies));
}

TEST(StandIn, IsNotedOnceHoweverOftenItIsUsed)
{
    EXPECT_THAT(NotesOf("SampleLightmap(p.xy, p.xyz) + SampleLightmap(p.yx, p.yx, p.zyx)"),
                ElementsAre(k_LightMaps));
}

TEST(StandIn, IsNotNotedWhereItIsOnlyThere)
{
    EXPECT_THAT(NotesOf("GetMainLight().color"), IsEmpty());
    EXPECT_THAT(NotesOf("GetMainLight(p, p.xyz, p).color"), IsEmpty());
    EXPECT_THAT(NotesOf("SampleSH(p.xyz)"), IsEmpty());
}

TEST(StandIn, IsNotNotedWhereTheSkyIsReflected)
{
    EXPECT_THAT(NotesOf("GlossyEnvironmentReflection(p.xyz, 0.5, 1)"), IsEmpty());
}

TEST(StandIn, IsNotedWhereAKeywordBringsItIn)
{
    EXPECT_THAT(NotesOf("GetMainLight(p, p.xyz, p).color", {"_LIGHT_COOKIES"}),
                ElementsAre(k_Cookies));
    EXPECT_THAT(NotesOf("SAMPLE_GI(p.xy, p.xyz, p.xyz)"), IsEmpty());
    EXPECT_THAT(
        NotesOf("SAMPLE_GI(p.xy, p.xyz, p.xyz)", {"LIGHTMAP_ON"}),
        ElementsAre(test::Mentions("lit.shader: note: it uses", "light maps", "ambient light")));
}

} // namespace
} // namespace limn

#include "ShaderTestSupport.h"

namespace limn
{
namespace
{

using test::ParseGood;
using test::ParsePass;

TEST(ShaderLabParser, ReadsTheStructureOfAFile)
{
    const ShaderLabDocument document = ParseGood(R"(
Shader "Folder/Name"
{
    Properties { _A ("A", Float) = 1 }
    SubShader
    {
        Tags { "Queue" = "Transparent+1" "RenderType"="Opaque" }
        LOD 300
        Pass { Name "First" }
        Pass { Tags { "LightMode" = "UniversalForward" } }
    }
    SubShader { }
    Fallback "Other/Shader"
    CustomEditor "My.Editor"
    CustomEditorForRenderPipeline "E" "Asset"
    Dependency "BaseMapShader" = "Hidden/Base"
}
)");
    EXPECT_EQ(document.name, "Folder/Name");
    EXPECT_EQ(document.location, (SourceLocation{2, 1}));
    ASSERT_EQ(document.subShaders.size(), 2u);
    const ShaderLabSubShader& first = document.subShaders[0];
    EXPECT_EQ(*first.tags.Find("queue"), "Transparent+1");
    EXPECT_EQ(*first.tags.Find("RenderType"), "Opaque");
    EXPECT_EQ(first.tags.Find("LightMode"), nullptr);
    EXPECT_EQ(first.lod, 300);
    ASSERT_EQ(first.passes.size(), 2u);
    EXPECT_EQ(first.passes[0].name, "First");
    EXPECT_EQ(first.passes[0].location, (SourceLocation{9, 9}));
    EXPECT_EQ(first.passes[0].lightMode(), "SRPDefaultUnlit");
    EXPECT_EQ(first.passes[1].lightMode(), "UniversalForward");
    EXPECT_EQ(document.fallback, "Other/Shader");
    EXPECT_EQ(document.customEditor, "My.Editor");
    EXPECT_EQ(document.pipelineEditors.at(0).pipelineAsset, "Asset");
    EXPECT_EQ(document.dependencies.at(0).shader, "Hidden/Base");
}

TEST(ShaderLabParser, IgnoresTheCaseOfKeywords)
{
    const ShaderLabDocument document =
        ParseGood("SHADER \"x\" { properties { _A (\"a\", RANGE(0,1)) = .5 } Subshader { TAGS { "
                  "\"a\" = \"b\" } pass { NAME \"n\" CULL fRONT } } FallBack OFF }");
    EXPECT_EQ(document.properties.at(0).type, ShaderPropertyType::Range);
    EXPECT_EQ(document.subShaders.at(0).passes.at(0).name, "n");
    EXPECT_EQ(document.subShaders.at(0).passes.at(0).state.cull.value, CullMode::Front);
}

TEST(ShaderLabParser, ReadsFilesWithByteOrderMarksAndWindowsLineEnds)
{
    const std::string mark = "\xEF\xBB\xBF";
    const ShaderLabDocument document = ParseGood(
        mark + mark + "Shader \"x\"\r\n{\r\n  SubShader { Pass { ZWrite Off } }\r\n}\r\n");
    EXPECT_EQ(document.location, (SourceLocation{1, 1}));
    EXPECT_EQ(document.subShaders.at(0).location, (SourceLocation{3, 3}));
    EXPECT_FALSE(document.subShaders.at(0).passes.at(0).state.zWrite.value);
}

TEST(ShaderLabParser, SkipsCommentsInAnyLanguageAndNestedOnes)
{
    const ShaderLabPass pass =
        ParsePass("Cull Off // 剔除 } \n /* a /* 描边 */ ZWrite Off */ ZTest Less");
    EXPECT_EQ(pass.state.cull.value, CullMode::Off);
    EXPECT_TRUE(pass.state.zWrite.value);
    EXPECT_EQ(pass.state.zTest.value, CompareFunction::Less);
}

TEST(ShaderLabParser, ClosesACommentThatOpensTwiceAndClosesOnce)
{
    EXPECT_EQ(ParsePass("/* a /* b */ Cull Off").state.cull.value, CullMode::Off);
}

TEST(ShaderLabParser, AcceptsACommentBehindTheShader)
{
    EXPECT_EQ(ParseGood("Shader \"x\" { } /*ASEBEGIN } { ASEEND*/ //CHKSM").name, "x");
}

TEST(ShaderLabParser, AddsTagBlocksTogetherAndLetsTheLaterValueWin)
{
    const ShaderLabPass pass =
        ParsePass("Tags { \"A\" = \"1\" \"B\" = \"2\" } Tags { \"a\" = \"3\" }");
    ASSERT_EQ(pass.tags.items.size(), 2u);
    EXPECT_EQ(*pass.tags.Find("A"), "3");
    EXPECT_EQ(*pass.tags.Find("B"), "2");
}

TEST(ShaderLabParser, GivesTheStateBeforeAPassInASubShaderToThatPassAndLaterOnes)
{
    const ShaderLabDocument document = ParseGood(R"(Shader "x" { SubShader {
        ZWrite Off
        Pass { }
        Cull Front
        Pass { ZWrite On }
        Pass { }
    } SubShader { Pass { } } })");
    const auto& passes = document.subShaders.at(0).passes;
    EXPECT_FALSE(passes.at(0).state.zWrite.value);
    EXPECT_EQ(passes.at(0).state.cull.value, CullMode::Back);
    EXPECT_TRUE(passes.at(1).state.zWrite.value);
    EXPECT_EQ(passes.at(1).state.cull.value, CullMode::Front);
    EXPECT_FALSE(passes.at(2).state.zWrite.value);
    EXPECT_EQ(passes.at(2).state.cull.value, CullMode::Front);
    EXPECT_EQ(document.subShaders.at(1).passes.at(0).state, RenderState{});
}

TEST(ShaderLabParser, GivesTheStateAndTagsOfACategoryToItsSubShaders)
{
    const ShaderLabDocument document = ParseGood(R"(Shader "x" {
        Category { Tags { "Queue" = "Overlay" } Blend One One SubShader { Pass { } } }
        SubShader { Pass { } } })");
    EXPECT_EQ(*document.subShaders.at(0).tags.Find("Queue"), "Overlay");
    EXPECT_TRUE(document.subShaders.at(0).passes.at(0).state.targets[0].enabled);
    EXPECT_EQ(document.subShaders.at(1).tags.Find("Queue"), nullptr);
    EXPECT_EQ(document.subShaders.at(1).passes.at(0).state, RenderState{});
}

TEST(ShaderLabParser, IgnoresLegacyCommands)
{
    const ShaderLabPass pass = ParsePass(
        "Lighting Off Fog { Mode Off } AlphaTest Greater [_Cutoff] AlphaTest Off "
        "SeparateSpecular On ColorMaterial Emission Color (1, .5, 0, [_A]) Color [_Color] "
        "Material { Diffuse (1,1,1,1) Shininess [_S] } BindChannels { Bind \"Vertex\", vertex } "
        "SetTexture [_MainTex] { combine texture * primary double, texture } SetTexture [_B] "
        "ZWrite Off");
    EXPECT_FALSE(pass.state.zWrite.value);
    EXPECT_FALSE(pass.program.has_value());
}

TEST(ShaderLabParser, TakesTheLastFallback)
{
    EXPECT_EQ(ParseGood("Shader \"x\" { Fallback \"a\" Fallback \"b\", 1 }").fallback, "b");
    EXPECT_EQ(ParseGood("Shader \"x\" { Fallback \"a\" Fallback False }").fallback, "");
}

} // namespace
} // namespace limn

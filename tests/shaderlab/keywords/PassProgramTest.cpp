#include "ShaderTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using testing::ElementsAre;

std::vector<std::string> ChunkTexts(const ShaderLabPass& pass)
{
    std::vector<std::string> texts;
    for (const SourceChunk& chunk : pass.program.value().chunks)
    {
        texts.push_back(chunk.text);
    }
    return texts;
}

TEST(PassProgram, HoldsTheTextBetweenItsKeywords)
{
    const ShaderLabDocument document = test::ParseGood(
        "Shader \"x\" { SubShader {\nPass {\n  HLSLPROGRAM // c\n  float x; } \"\n  ENDHLSL "
        "ZWrite Off } } }");
    const ShaderLabPass& pass = document.subShaders.at(0).passes.at(0);
    EXPECT_FALSE(pass.state.zWrite.value);
    const PassProgram& program = pass.program.value();
    EXPECT_EQ(program.file, "t.shader");
    EXPECT_EQ(program.location, (SourceLocation{3, 3}));
    EXPECT_EQ(program.language, ProgramLanguage::Hlsl);
    EXPECT_EQ(program.chunks, (std::vector<SourceChunk>{{" // c\n  float x; } \"\n  ", 3}}));
}

TEST(PassProgram, DoesNotEndAtItsClosingKeywordInAComment)
{
    EXPECT_EQ(test::ProgramOf(" a // ENDHLSL\n b ").chunks.at(0).text, " a // ENDHLSL\n b ");
    EXPECT_EQ(test::ProgramOf(" xENDHLSL ").chunks.at(0).text, " xENDHLSL ");
}

TEST(PassProgram, StartsWithTheIncludeBlocksBeforeItAndBehindItInWhatSurroundsIt)
{
    const ShaderLabDocument document = test::ParseGood(R"(Shader "x" {
        HLSLINCLUDE A ENDHLSL
        CGINCLUDE C ENDCG
        SubShader {
            HLSLINCLUDE B ENDHLSL
            Pass { HLSLPROGRAM 1 ENDHLSL }
            Pass { CGPROGRAM 2 ENDCG }
            HLSLINCLUDE D ENDHLSL
            Pass { HLSLPROGRAM 3 ENDHLSL }
        }
        SubShader { Pass { HLSLPROGRAM 4 ENDHLSL } }
        HLSLINCLUDE E ENDHLSL })");
    const auto& passes = document.subShaders.at(0).passes;
    EXPECT_THAT(ChunkTexts(passes.at(0)), ElementsAre(" A ", " B ", " D ", " E ", " 1 "));
    EXPECT_THAT(ChunkTexts(passes.at(1)), ElementsAre(" C ", " 2 "));
    EXPECT_EQ(passes.at(1).program->language, ProgramLanguage::Cg);
    EXPECT_THAT(ChunkTexts(passes.at(2)), ElementsAre(" A ", " B ", " D ", " E ", " 3 "));
    EXPECT_THAT(ChunkTexts(document.subShaders.at(1).passes.at(0)),
                ElementsAre(" A ", " B ", " D ", " E ", " 4 "));
    EXPECT_EQ(passes.at(0).program->chunks.at(0).firstLine, 2);
    EXPECT_EQ(passes.at(0).program->chunks.at(1).firstLine, 5);
}

TEST(PassProgram, IsNotGivenTheLaterIncludeBlocksOfAnotherSubShader)
{
    const ShaderLabDocument document = test::ParseGood(R"(Shader "x" {
        SubShader { Pass { HLSLPROGRAM 1 ENDHLSL HLSLINCLUDE A ENDHLSL }
                    Pass { HLSLINCLUDE B ENDHLSL HLSLPROGRAM 2 ENDHLSL } }
        SubShader { HLSLINCLUDE C ENDHLSL Pass { HLSLPROGRAM 3 ENDHLSL } } })");
    const auto& passes = document.subShaders.at(0).passes;
    EXPECT_THAT(ChunkTexts(passes.at(0)), ElementsAre(" A ", " 1 "));
    EXPECT_THAT(ChunkTexts(passes.at(1)), ElementsAre(" A ", " B ", " 2 "));
    EXPECT_THAT(ChunkTexts(document.subShaders.at(1).passes.at(0)),
                ElementsAre(" A ", " B ", " C ", " 3 "));
}

TEST(PassProgram, TakesEntryPointsFromAnIncludeBlockBehindIt)
{
    const ShaderLabDocument document = test::ParseGood(
        "Shader \"x\" { SubShader { Pass { Tags { \"LightMode\" = \"ShadowCaster\" } CGPROGRAM\n"
        "#pragma vertex B\nENDCG } CGINCLUDE\n#pragma vertex A\n#pragma fragment F\nENDCG } }");
    const PassProgram& program = document.subShaders.at(0).passes.at(0).program.value();
    EXPECT_EQ(program.vertex.name, "B");
    EXPECT_EQ(program.fragment.name, "F");
    EXPECT_EQ(program.lightMode, "ShadowCaster");
}

TEST(PassProgram, TakesEntryPointsAndTargetFromPragmas)
{
    const PassProgram program = test::ProgramOf("\n  #pragma vertex Vert // v\n"
                                                "#  pragma   fragment Frag extra\n"
                                                "#pragma target 4.5 _A\n// #pragma vertex Other\n"
                                                "/*\n#pragma fragment Other\n*/\n");
    EXPECT_EQ(program.vertex, (EntryPoint{"Vert", {2, 3}}));
    EXPECT_EQ(program.fragment, (EntryPoint{"Frag", {3, 1}}));
    EXPECT_EQ(program.target, 45);
    EXPECT_EQ(test::ProgramOf("\n").target, 25);
    EXPECT_EQ(test::ProgramOf("\n").vertex, EntryPoint{});
}

TEST(PassProgram, LetsItsOwnPragmasWinOverThoseOfIncludeBlocks)
{
    const ShaderLabDocument document = test::ParseGood(
        "Shader \"x\" { CGINCLUDE\n#pragma vertex A\n#pragma fragment F\nENDCG SubShader { Pass { "
        "CGPROGRAM\n#pragma vertex B\nENDCG } } }");
    const PassProgram& program = document.subShaders.at(0).passes.at(0).program.value();
    EXPECT_EQ(program.vertex.name, "B");
    EXPECT_EQ(program.fragment.name, "F");
}

TEST(PassProgram, CollectsKeywordSets)
{
    const PassProgram program = test::ProgramOf(
        "\n#pragma multi_compile _ FOO BAR\n#pragma shader_feature_local_fragment _ON\n"
        "#pragma multi_compile_vertex __ \\\n  LONG\n#pragma shader_feature A B\n"
        "#pragma multi_compile_fog\n");
    ASSERT_EQ(program.keywordSets.size(), 5u);
    const KeywordSet& first = program.keywordSets[0];
    EXPECT_THAT(first.keywords, ElementsAre("", "FOO", "BAR"));
    EXPECT_EQ(first.location, (SourceLocation{2, 1}));
    EXPECT_FALSE(first.isFeature);
    EXPECT_FALSE(first.isLocal);
    EXPECT_EQ(first.stages, ShaderStage::Both);
    const KeywordSet& second = program.keywordSets[1];
    EXPECT_THAT(second.keywords, ElementsAre("", "_ON"));
    EXPECT_TRUE(second.isFeature);
    EXPECT_TRUE(second.isLocal);
    EXPECT_EQ(second.stages, ShaderStage::Fragment);
    EXPECT_THAT(program.keywordSets[2].keywords, ElementsAre("", "LONG"));
    EXPECT_EQ(program.keywordSets[2].stages, ShaderStage::Vertex);
    EXPECT_THAT(program.keywordSets[3].keywords, ElementsAre("A", "B"));
    EXPECT_THAT(program.keywordSets[4].keywords,
                ElementsAre("", "FOG_LINEAR", "FOG_EXP", "FOG_EXP2"));
}

TEST(PassProgram, KeepsOtherPragmasAsText)
{
    const PassProgram program = test::ProgramOf("\n#pragma instancing_options renderinglayer x\n"
                                                "#pragma enable_cbuffer#define X 1\n");
    ASSERT_EQ(program.pragmas.size(), 2u);
    EXPECT_EQ(program.pragmas[0],
              (ProgramPragma{{2, 1}, "instancing_options", "renderinglayer x"}));
    EXPECT_EQ(program.pragmas[1].name, "enable_cbuffer");
}

} // namespace
} // namespace limn

#include "Mentions.h"
#include "TemporaryFolder.h"
#include "commands/CommandRun.h"
#include "volume/Problems.h"

#include <explain/InspectReport.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string k_Head = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
const std::string k_Behaviour = k_Head + "--- !u!114 &11400000\nMonoBehaviour:\n";

/// A Unity project's Assets folder.
class InspectAsset : public testing::Test
{
protected:
    std::string Text(const std::string& name, const std::string& text) const
    {
        const CommandRun run =
            RunCommand({"inspect", folder.Write("Assets/" + name, text).string()});
        EXPECT_EQ(0, run.exitCode) << run.err;
        return run.out;
    }

    nlohmann::json AsJson(const std::string& name) const
    {
        return nlohmann::json::parse(
            RunCommand({"inspect", (folder / ("Assets/" + name)).string(), "--json"}).out);
    }

    TemporaryFolder folder;
};

const std::string k_Pipeline = k_Behaviour + "  m_Script: {fileID: 11500000, guid: bf}\n"
                                             "  m_Name: High\n"
                                             "  k_AssetVersion: 11\n"
                                             "  m_RendererDataList:\n"
                                             "  - {fileID: 11400000, guid: ab, type: 2}\n"
                                             "  - {fileID: 11400000, guid: cd, type: 2}\n"
                                             "  m_DefaultRendererIndex: 1\n"
                                             "  m_UseSRPBatcher: 1\n"
                                             "  m_SupportsHDR: 1\n"
                                             "  m_MSAA: 4\n"
                                             "  m_ShadowDistance: 50\n"
                                             "  m_Cascade3Split: {x: 0.1, y: 0.3}\n"
                                             "  m_PrefilterXRKeywords: 0\n"
                                             "  m_ShadowCascades: 1\n";

const std::string k_Material = k_Head + "--- !u!21 &2100000\n"
                                        "Material:\n"
                                        "  m_Name: Glass\n"
                                        "  m_Shader: {fileID: 4800000, guid: aa, type: 3}\n"
                                        "  m_ValidKeywords:\n"
                                        "  - _ON\n"
                                        "  - _NORMALMAP\n"
                                        "  m_InvalidKeywords: []\n"
                                        "  m_CustomRenderQueue: 3000\n"
                                        "  stringTagMap:\n"
                                        "    RenderType: Transparent\n"
                                        "  m_SavedProperties:\n"
                                        "    m_TexEnvs:\n"
                                        "    - _Map:\n"
                                        "        m_Texture: {fileID: 2800000, guid: bb, type: 3}\n"
                                        "        m_Scale: {x: 6, y: 6}\n"
                                        "        m_Offset: {x: 0, y: 0}\n"
                                        "    m_Floats:\n"
                                        "    - _Mode: 2\n"
                                        "    m_Colors:\n"
                                        "    - _Tint: {r: 1, g: 0.5, b: 0, a: 1}\n";

} // namespace

TEST_F(InspectAsset, OfAPipelineSaysWhatLimnDrawsWithAndWhatItLeavesOut)
{
    folder.Write("Assets/Settings/Mobile.asset.meta", "guid: cd\n");
    const std::string text = Text("High.asset", k_Pipeline);
    EXPECT_THAT(text, testing::StartsWith("pipeline 'High': UniversalRenderPipelineAsset\n"
                                          "    k_AssetVersion"));
    EXPECT_THAT(text,
                ContainsRegex("\n      0 +guid ab \\(the project has no .meta file with it\\)\n"
                              "      1 +Assets/Settings/Mobile.asset +of cameras that"));
    const std::size_t drawn = text.find("    Drawn with");
    const std::size_t left = text.find("    Left out");
    ASSERT_LT(drawn, left);
    ASSERT_NE(std::string::npos, left);
    EXPECT_THAT(text.substr(drawn, left - drawn),
                ContainsRegex("m_SupportsHDR +1\n +m_MSAA +4\n +m_ShadowDistance +50\n"
                              " +m_Cascade3Split +.x: 0.1, y: 0.3.\n$"));
    EXPECT_THAT(text.substr(left), ContainsRegex("\n +m_UseSRPBatcher +1\n$"));

    const nlohmann::json json = AsJson("High.asset");
    EXPECT_EQ("pipeline", json["kind"]);
    EXPECT_EQ("High", json["pipeline"]["name"]);
    EXPECT_EQ("k_AssetVersion", json["pipeline"]["values"][0]["name"]);
    EXPECT_EQ(11, json["pipeline"]["values"][0]["value"]);
    EXPECT_FALSE(json["pipeline"]["values"][0].contains("default"));
}

TEST_F(InspectAsset, OfARendererShowsItsMasksAndItsFeatures)
{
    const std::string text = Text(
        "R.asset", k_Head + "--- !u!114 &5\nMonoBehaviour:\n"
                            "  m_Script: {guid: 6b3d386ba5cd94485973aee1479b272e}\n"
                            "  m_Name: Mask\n"
                            "  settings: {Event: 450}\n"
                            "--- !u!114 &11400000\nMonoBehaviour:\n"
                            "  m_Name: Forward\n"
                            "  m_RendererFeatures: [{fileID: 5}]\n"
                            "  m_OpaqueLayerMask: {serializedVersion: 2, m_Bits: 55}\n"
                            "  m_RenderingMode: 1\n"
                            "  m_DefaultStencilState: {overrideStencilState: 0, passOperation: 2}\n"
                            "  postProcessData: {fileID: 0}\n");
    EXPECT_THAT(text, testing::StartsWith("renderer 'Forward': UniversalRendererData\n"));
    EXPECT_THAT(text, ContainsRegex("m_OpaqueLayerMask +55 "));
    EXPECT_THAT(text, ContainsRegex("m_RenderingMode +1 .*forward"));
    EXPECT_THAT(text, ContainsRegex("m_DefaultStencilState +0 "));
    EXPECT_THAT(text, ContainsRegex("postProcessData +none +no post-processing"));
    EXPECT_THAT(text, HasSubstr("feature 'Mask': RenderObjects\n"));
    EXPECT_THAT(text, ContainsRegex("Event +BeforeRenderingTransparents +default "
                                    "AfterRenderingOpaques +set"));
}

TEST_F(InspectAsset, OfAMaterialSaysWhichShaderKeywordsAndPropertiesItHas)
{
    folder.Write("Assets/glass.shader.meta", "guid: aa\n");
    folder.Write("Assets/glass.shader",
                 "Shader \"Mine/Glass\" { Properties { _Tint (\"T\", Color) = "
                 "(1,1,1,1)\n _Map (\"M\", 2D) = \"white\" {} } SubShader { "
                 "Pass { } } }");
    folder.Write("Assets/wood.tif.meta", "guid: bb\n");
    const std::string text = Text("Glass.mat", k_Material);
    EXPECT_THAT(text, testing::StartsWith("material 'Glass': Material\n"));
    EXPECT_THAT(text, ContainsRegex("m_Shader +Mine/Glass +Assets/glass.shader\n"));
    EXPECT_THAT(text, ContainsRegex("keywords +._ON, _NORMALMAP.\n"));
    EXPECT_THAT(text, Not(HasSubstr("m_InvalidKeywords")));
    EXPECT_THAT(text, ContainsRegex("m_CustomRenderQueue +3000 "));
    EXPECT_THAT(text, ContainsRegex("stringTagMap +.RenderType: Transparent. "));
    EXPECT_THAT(text, ContainsRegex("Textures\n +_Map +Assets/wood.tif, scale .x: 6, y: 6., offset "
                                    ".x: 0, y: 0.\n"));
    EXPECT_THAT(text, ContainsRegex("_Mode +2 +unknown to limn's shader\n"));
    EXPECT_THAT(text, ContainsRegex("_Tint +.r: 1, g: 0.5, b: 0, a: 1.\n"));
    EXPECT_EQ("material", AsJson("Glass.mat")["kind"]);
}

TEST_F(InspectAsset, OfAMaterialWithUrpsLitSaysThatLimnHasOneOfItsOwn)
{
    const std::string text = Text("Lit.mat", k_Head + "--- !u!21 &2100000\nMaterial:\n  m_Name: A\n"
                                                      "  m_Shader: {fileID: 4800000, guid: "
                                                      "933532a4fcc9baf4fa0491de14d08ed7, type: 3}\n"
                                                      "  m_ShaderKeywords: _EMISSION _ON\n");
    EXPECT_THAT(text, ContainsRegex("m_Shader +Universal Render Pipeline/Lit +limn's own"));
    EXPECT_THAT(text, ContainsRegex("keywords +._EMISSION _ON.\n"));
    const std::string unknown =
        Text("Complex.mat", k_Head + "--- !u!21 &2100000\nMaterial:\n  m_Name: A\n"
                                     "  m_Shader: {fileID: 4800000, guid: "
                                     "ee7e4c9a5f6364b688a332c67fc32cca, type: 3}\n");
    EXPECT_THAT(unknown, ContainsRegex("Complex Lit +limn has none"));
}

TEST_F(InspectAsset, OfAnyOtherKindSaysWhatItIs)
{
    const auto path = folder.Write("Assets/G.asset", k_Behaviour + "  m_Name: GlobalSettings\n");
    const CommandRun run = RunCommand({"inspect", path.string()});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err,
                Mentions("no volume profile", "Unity asset", "MonoBehaviour 'GlobalSettings'"));
}

} // namespace limn::test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limn/core/CoreUtils.h>

#include "Mentions.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;

/// A shader whose result tells which keyword is on: _Off, _On or _Loud.
std::shared_ptr<const Shader> KeywordShader(const std::string& properties,
                                            const std::string& directive = "shader_feature")
{
    return test::ShaderOf("Shader \"Test/Keywords\" { Properties { " + properties +
                          " } SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" }\n"
                          "HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
                          "#pragma " +
                          directive +
                          " _ TINT_ON TINT_LOUD\n"
                          "#if TINT_ON\nfloat _On;\n#define RESULT _On\n"
                          "#elif TINT_LOUD\nfloat _Loud;\n#define RESULT _Loud\n"
                          "#else\nfloat _Off;\n#define RESULT _Off\n#endif\n"
                          "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
                          "float4 F() : SV_Target { return RESULT; }\nENDHLSL } } }");
}

/// The only uniform of the variant that a material draws with.
std::string Drawn(const std::shared_ptr<const Material>& material)
{
    test::OneDraw draw;
    draw.Resolve(material);
    return draw.draw().program->layout.buffers.at(0).members.at(0).name;
}

TEST(MaterialKeywords, BeginWithTheDefaultsOfToggleAndKeywordEnum)
{
    const auto on =
        std::make_shared<Material>(KeywordShader("[Toggle(TINT_ON)] _Tint (\"\", Float) = 1"));
    EXPECT_THAT(on->shaderKeywords(), ElementsAre("TINT_ON"));
    EXPECT_EQ(Drawn(on), "_On");
    const auto off =
        std::make_shared<Material>(KeywordShader("[Toggle(TINT_ON)] _Tint (\"\", Float) = 0"));
    EXPECT_EQ(Drawn(off), "_Off");
    const auto loud = std::make_shared<Material>(
        KeywordShader("[KeywordEnum(Quiet, Loud)] TINT (\"\", Float) = 1"));
    EXPECT_TRUE(loud->IsKeywordEnabled("TINT_LOUD"));
    EXPECT_EQ(Drawn(loud), "_Loud");
}

TEST(MaterialKeywords, ChooseTheVariantThatIsDrawn)
{
    const auto material = std::make_shared<Material>(KeywordShader(""));
    EXPECT_EQ(Drawn(material), "_Off");
    material->EnableKeyword("TINT_LOUD");
    EXPECT_EQ(Drawn(material), "_Loud");
    material->DisableKeyword("TINT_LOUD");
    material->EnableKeyword("UNKNOWN");
    EXPECT_EQ(Drawn(material), "_Off");
    EXPECT_TRUE(material->IsKeywordEnabled("UNKNOWN"));
}

TEST(MaterialKeywords, AreValuesWhereTheShaderBranchesOnThem)
{
    const auto material = std::make_shared<Material>(test::ShaderOf(
        "Shader \"Test/Branches\" { SubShader { Pass {\nHLSLPROGRAM\n#pragma vertex V\n"
        "#pragma fragment F\n#pragma dynamic_branch _ WET MOSS\n"
        "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
        "float4 F() : SV_Target { if (WET) { return MOSS; } return 2; }\nENDHLSL } } }"));
    test::OneDraw draw;
    draw.Resolve(material);
    const auto pass = draw.draw().program;
    const auto values = [&]
    {
        draw.Resolve(material);
        return std::pair(draw.Ints("WET", 1).at(0), draw.Ints("MOSS", 1).at(0));
    };
    EXPECT_EQ(values(), std::pair(0, 0));
    material->EnableKeyword("MOSS");
    EXPECT_EQ(values(), std::pair(0, 1));
    material->EnableKeyword("WET"); // no set of one at a time, as in Unity
    EXPECT_EQ(values(), std::pair(1, 1));
    material->DisableKeyword("MOSS");
    EXPECT_EQ(values(), std::pair(1, 0));
    // No property can take their place.
    material->SetFloat(ShaderPropertyId("WET"), 7.0f);
    EXPECT_EQ(values(), std::pair(1, 0));
    EXPECT_EQ(draw.draw().program, pass);
}

TEST(MaterialTexture, HasScaleOffsetAndSizeFed)
{
    const auto material = std::make_shared<Material>(test::ShaderWithProgram(
        "_Map (\"\", 2D) = \"white\" {}",
        "Texture2D _Map; float4 _Map_ST; float4 _Map_TexelSize; float4 _Map_HDR;",
        "_Map.Load(0) + _Map_ST + _Map_TexelSize + _Map_HDR"));
    const ShaderPropertyId map("_Map");
    material->SetTexture(map, test::Target("map", 8, 4));
    test::OneDraw draw;
    draw.Resolve(material);
    EXPECT_THAT(draw.Floats("_Map_ST", 4), ElementsAre(1.0f, 1.0f, 0.0f, 0.0f));
    EXPECT_THAT(draw.Floats("_Map_TexelSize", 4), ElementsAre(0.125f, 0.25f, 8.0f, 4.0f));
    EXPECT_THAT(draw.Floats("_Map_HDR", 4), ElementsAre(1.0f, 1.0f, 0.0f, 0.0f));
    material->SetTextureScale(map, {2.0f, 3.0f});
    material->SetTextureOffset(map, {0.5f, 0.25f});
    draw.Resolve(material);
    EXPECT_THAT(draw.Floats("_Map_ST", 4), ElementsAre(2.0f, 3.0f, 0.5f, 0.25f));
}

/// What a command buffer's draws come to, by the result of KeywordShader.
class GlobalKeywords : public testing::Test
{
protected:
    GlobalKeywords() { m_Cmd.SetRenderTarget(RTHandle(test::Target("Picture", 4, 4))); }

    void Draw(const std::shared_ptr<const Material>& material)
    {
        m_Cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3);
    }
    std::vector<std::string> Results()
    {
        m_Context.ExecuteCommandBuffer(m_Cmd);
        std::vector<std::string> results;
        for (const test::SeenDraw& draw : test::DrawsOf(m_Context.TakeCommands()))
        {
            results.push_back(draw.program->layout.buffers.at(0).members.at(0).name);
        }
        return results;
    }

    CommandBuffer m_Cmd;
    RenderReport m_Report;
    ScriptableRenderContext m_Context{m_Report};
};

TEST_F(GlobalKeywords, ChooseTheVariantOfTheDrawsThatFollow)
{
    const auto material = std::make_shared<Material>(KeywordShader(""));
    const auto other = std::make_shared<Material>(KeywordShader(""));
    Draw(material);
    m_Cmd.EnableShaderKeyword("TINT_ON");
    Draw(material);
    Draw(other);
    m_Cmd.DisableShaderKeyword("TINT_ON");
    Draw(material);
    m_Cmd.EnableKeyword(GlobalKeyword::Create("TINT_LOUD"));
    Draw(material);
    CoreUtils::SetKeyword(m_Cmd, "UNKNOWN", true);
    Draw(material);
    EXPECT_THAT(Results(), ElementsAre("_Off", "_On", "_On", "_Off", "_Loud", "_Loud"));
    EXPECT_THAT(material->shaderKeywords(), testing::IsEmpty());
}

TEST_F(GlobalKeywords, AreNotThoseThatACommandSwitchesForOneMaterial)
{
    const auto material = std::make_shared<Material>(KeywordShader(""));
    const auto other = std::make_shared<Material>(KeywordShader(""));
    const LocalKeyword keyword(*material->shader(), "TINT_ON");
    Draw(material);
    m_Cmd.EnableKeyword(material, keyword);
    Draw(material);
    Draw(other);
    m_Cmd.SetKeyword(material, keyword, false);
    Draw(material);
    EXPECT_THAT(Results(), ElementsAre("_Off", "_On", "_Off", "_Off"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Cmd.EnableKeyword(nullptr, keyword); }),
                test::Mentions("SetKeyword", "'TINT_ON'", "material", "null"));
}

TEST_F(GlobalKeywords, AddToThoseOfTheMaterial)
{
    const auto material = std::make_shared<Material>(KeywordShader(""));
    CoreUtils::SetKeyword(*material, "TINT_LOUD", true);
    Draw(material);
    m_Cmd.EnableShaderKeyword("TINT_ON"); // comes first in the set
    Draw(material);
    EXPECT_THAT(Results(), ElementsAre("_Loud", "_On"));
}

TEST_F(GlobalKeywords, AreNotForLocalSets)
{
    const auto local =
        std::make_shared<Material>(KeywordShader("", "multi_compile_local_fragment"));
    m_Cmd.EnableShaderKeyword("TINT_ON");
    Draw(local);
    local->EnableKeyword("TINT_LOUD");
    EXPECT_THAT(Results(), ElementsAre("_Loud")) << "the material as it is when it is executed";
}

TEST_F(GlobalKeywords, EndWithTheFrame)
{
    const auto material = std::make_shared<Material>(KeywordShader(""));
    m_Cmd.EnableShaderKeyword("TINT_ON");
    Draw(material);
    EXPECT_THAT(Results(), ElementsAre("_On"));
    m_Cmd.Clear();
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    m_Cmd.SetRenderTarget(RTHandle(test::Target("Picture", 4, 4)));
    Draw(material);
    EXPECT_THAT(Results(), ElementsAre("_Off"));
}

TEST_F(GlobalKeywords, OfTheShaderClassLastUntilTheyAreSwitchedOff)
{
    const auto material = std::make_shared<Material>(KeywordShader(""));
    Draw(material);
    Shader::EnableKeyword("TINT_ON");
    EXPECT_TRUE(Shader::IsKeywordEnabled("TINT_ON"));
    EXPECT_THAT(Results(), ElementsAre("_On"));
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    m_Cmd.DisableShaderKeyword("TINT_ON"); // to the frame's end
    Draw(material);
    EXPECT_THAT(Results(), ElementsAre("_On", "_Off"));
    EXPECT_TRUE(Shader::IsKeywordEnabled("TINT_ON"));
    m_Cmd.Clear();
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    Draw(material);
    EXPECT_THAT(Results(), ElementsAre("_On"));
    Shader::DisableKeyword(GlobalKeyword("TINT_ON"));
    EXPECT_FALSE(Shader::IsKeywordEnabled("TINT_ON"));
    EXPECT_FALSE(Shader::IsKeywordEnabled("TINT_NEVER"));
    m_Context.Begin(m_Report, glm::dvec3(0.0));
    EXPECT_THAT(Results(), ElementsAre("_Off"));
}

TEST_F(GlobalKeywords, AreThoseOfAnEarlierPlaceThere)
{
    const auto material = std::make_shared<Material>(KeywordShader(""));
    Draw(material);
    m_Context.ExecuteCommandBuffer(m_Cmd);
    m_Cmd.Clear();
    const auto place = m_Context.MarkPlace();
    m_Cmd.EnableShaderKeyword("TINT_ON");
    Draw(material);
    m_Context.ExecuteCommandBuffer(m_Cmd);
    m_Cmd.Clear();
    m_Context.RecordAt(place,
                       [&]
                       {
                           Draw(material);
                           m_Context.ExecuteCommandBuffer(m_Cmd);
                           m_Cmd.Clear();
                       });
    Draw(material);
    EXPECT_THAT(Results(), ElementsAre("_Off", "_Off", "_On", "_On"));
}

TEST_F(GlobalKeywords, AreValuesWhereTheShaderBranchesOnThem)
{
    const auto material = std::make_shared<Material>(test::ShaderOf(
        "Shader \"Test/Branches\" { SubShader { Pass {\nHLSLPROGRAM\n#pragma vertex V\n"
        "#pragma fragment F\n#pragma dynamic_branch _ WET\n"
        "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
        "float4 F() : SV_Target { return WET ? 1 : 2; }\nENDHLSL } } }"));
    m_Cmd.EnableShaderKeyword("WET");
    Draw(material);
    m_Context.ExecuteCommandBuffer(m_Cmd);
    const FrameCommands frame = m_Context.TakeCommands();
    const test::UniformBytes wet = test::FindUniform(frame, test::DrawsOf(frame).at(0), "WET");
    std::int32_t value = 0;
    std::memcpy(&value, wet.bytes, sizeof(value));
    EXPECT_EQ(value, 1);
}

TEST(LocalKeywords, SwitchThoseOfTheirShader)
{
    const auto shader = test::ShaderWithProgram(
        "", "#pragma multi_compile _ B_ON A_ON\n#pragma shader_feature_local C_ON\n");
    Material material(shader);
    const LocalKeyword keyword(*shader, "A_ON");
    EXPECT_EQ(keyword.name(), "A_ON");
    material.SetKeyword(keyword, true);
    EXPECT_TRUE(material.IsKeywordEnabled("A_ON"));
    material.DisableKeyword(keyword);
    EXPECT_FALSE(material.IsKeywordEnabled(keyword));
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { LocalKeyword(*shader, "A_OFF"); }),
                test::Mentions("'Test/Program'", "no keyword 'A_OFF'", "A_ON, B_ON, C_ON"));
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { LocalKeyword(*test::ShaderWithProgram(""), "A_ON"); }),
                test::Mentions("'Test/Program'", "no keyword 'A_ON'", "none"));
}

} // namespace
} // namespace limn

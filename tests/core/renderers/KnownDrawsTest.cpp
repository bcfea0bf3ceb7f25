// What drawing keeps from one draw or frame to the next must not outlive what it was made of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;

const ShaderPropertyId _Cull("_Cull");

class KnownDraws : public testing::Test
{
protected:
    static std::shared_ptr<Material> Culled(const std::string& properties)
    {
        return std::make_shared<Material>(
            test::ShaderWithProgram(properties, "", "1", "Cull [_Cull]"), "Paint");
    }
    void Draw(const std::shared_ptr<Material>& material)
    {
        CommandBuffer cmd;
        cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3);
        m_Context.ExecuteCommandBuffer(cmd);
    }
    void SetGlobal(CullMode mode)
    {
        CommandBuffer cmd;
        cmd.SetGlobalFloat(_Cull, static_cast<float>(mode));
        m_Context.ExecuteCommandBuffer(cmd);
    }
    /// Of the draws so far; ends the frame.
    std::vector<CullMode> TakeModes()
    {
        std::vector<CullMode> modes;
        for (const test::SeenDraw& draw : test::DrawsOf(m_Context.TakeCommands()))
        {
            modes.push_back(draw.state.cull);
        }
        m_Context.Begin(m_Report, glm::dvec3(0.0), {}, true);
        return modes;
    }

    RenderReport m_Report;
    ScriptableRenderContext m_Context{m_Report};
};

TEST_F(KnownDraws, HaveTheStateOfTheirMaterialNow)
{
    const auto material = Culled("_Cull (\"Cull\", Float) = 2");
    Draw(material);
    material->SetFloat(_Cull, 1.0f);
    Draw(material);
    EXPECT_THAT(TakeModes(), ElementsAre(CullMode::Back, CullMode::Front));
    Draw(material);
    material->SetFloat(_Cull, 0.0f);
    Draw(material);
    EXPECT_THAT(TakeModes(), ElementsAre(CullMode::Front, CullMode::Off));
}

TEST_F(KnownDraws, HaveTheStateThatIsGlobalNow)
{
    const auto material = Culled("");
    SetGlobal(CullMode::Front);
    Draw(material);
    SetGlobal(CullMode::Off);
    Draw(material);
    EXPECT_THAT(TakeModes(), ElementsAre(CullMode::Front, CullMode::Off));
    SetGlobal(CullMode::Back);
    Draw(material);
    material->SetFloat(_Cull, 1.0f); // before what is global
    Draw(material);
    EXPECT_THAT(TakeModes(), ElementsAre(CullMode::Back, CullMode::Front));
}

TEST_F(KnownDraws, OfEqualProgramsHaveTheDefaultsOfTheirShaders)
{
    const auto sampling = [](const std::string& color)
    {
        return std::make_shared<Material>(
            test::ShaderWithProgram("_Map (\"Map\", 2D) = \"" + color + "\" {}",
                                    "Texture2D _Map; SamplerState sampler_Map;",
                                    "_Map.Sample(sampler_Map, float2(0.5, 0.5))"));
    };
    const auto white = sampling("white");
    const auto black = sampling("black");
    for (const auto& material : {white, black, white})
    {
        Draw(material);
    }
    std::vector<std::string> names;
    for (const test::SeenDraw& draw : test::DrawsOf(m_Context.TakeCommands()))
    {
        names.push_back(draw.bindings->textures.at(0).texture->name());
    }
    EXPECT_THAT(names, ElementsAre("white", "black", "white"));
}

TEST_F(KnownDraws, AreNewOnlyWhereAMaterialChanges)
{
    const auto material = Culled("_Cull (\"Cull\", Float) = 0");
    const std::uint64_t version = material->version();
    material->SetFloat(_Cull, 0.0f);
    EXPECT_EQ(material->version(), version);
    material->SetFloat(_Cull, -0.0f); // a shader may divide by it
    EXPECT_NE(material->version(), version);
    const std::uint64_t negative = material->version();
    material->SetInt(_Cull, 0);
    EXPECT_NE(material->version(), negative);
}

} // namespace
} // namespace limn

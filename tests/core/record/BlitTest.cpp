#include <gtest/gtest.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "record/RecordedCommands.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

const ShaderPropertyId unity_MatrixVP("unity_MatrixVP");

/// What CommandBuffer::Blit comes to in a frame.
class Blits : public testing::Test
{
protected:
    static std::shared_ptr<const Shader> CopyShader(const std::string& tags)
    {
        return test::ShaderOf("Shader \"Test/Copy\" { SubShader { Tags { " + tags + " } Pass {" +
                              test::Program("Texture2D _MainTex; SamplerState sampler_MainTex; "
                                            "float4 _MainTex_TexelSize; float4x4 unity_MatrixVP;",
                                            "_MainTex.Sample(sampler_MainTex, 0.5) + "
                                            "_MainTex_TexelSize + unity_MatrixVP[0]") +
                              "} } }");
    }
    FrameCommands Execute()
    {
        m_Context.ExecuteCommandBuffer(m_Cmd);
        return m_Context.TakeCommands();
    }

    RenderReport m_Report;
    ScriptableRenderContext m_Context{m_Report, glm::dvec3(1e7, 0.0, 0.0)};
    CommandBuffer m_Cmd;
    const RTHandle m_Source{test::Target("Source", 8, 4)};
    const RTHandle m_Dest{test::Target("Dest", 16, 2)};
    const std::shared_ptr<const Material> m_Copy =
        std::make_shared<Material>(CopyShader(""), "Copy");
};

} // namespace

TEST_F(Blits, BindSourceAndItsSizeAndTheDestination)
{
    m_Cmd.Blit(m_Source, m_Dest, m_Copy);
    const FrameCommands frame = Execute();
    ASSERT_EQ(frame.commands.size(), 2u);
    const auto& target = std::get<SetRenderTargetCommand>(frame.commands[0]);
    ASSERT_EQ(target.colors.size(), 1u);
    EXPECT_EQ(target.colors[0], m_Dest.rt());
    EXPECT_EQ(target.depth, nullptr);
    const test::SeenDraw draw = test::DrawsOf(frame).at(0);
    ASSERT_EQ(draw.bindings->textures.size(), 1u);
    EXPECT_EQ(draw.bindings->textures[0].texture, m_Source.rt());
    EXPECT_EQ(test::ReadUniform<float>(frame, draw, "_MainTex_TexelSize", 4),
              (std::vector<float>{1.0f / 8.0f, 1.0f / 4.0f, 8.0f, 4.0f}));
}

TEST_F(Blits, LeaveTheCameraAndTheMaterialAsTheyAre)
{
    const glm::mat4 camera(3.0f);
    m_Cmd.SetGlobalMatrix(unity_MatrixVP, camera);
    m_Cmd.Blit(m_Source, m_Dest, m_Copy);
    m_Cmd.DrawProcedural(glm::mat4(1.0f), m_Copy, 0, 3);
    EXPECT_EQ(m_Copy->Find(ShaderPropertyId("_MainTex")), nullptr);
    const FrameCommands frame = Execute();
    const auto draws = test::DrawsOf(frame);
    ASSERT_EQ(draws.size(), 2u);
    // Columns: 0...1 becomes -1...1 in x, and 1...-1 in y, as a projection into a texture has it.
    const auto blit = test::ReadUniform<float>(frame, draws[0], "unity_MatrixVP", 16);
    EXPECT_EQ(blit[0], 2.0f);
    EXPECT_EQ(blit[5], -2.0f);
    EXPECT_EQ(blit[12], -1.0f);
    EXPECT_EQ(blit[13], 1.0f);
    EXPECT_EQ(test::ReadUniform<float>(frame, draws[1], "unity_MatrixVP", 1)[0], 3.0f);
}

TEST_F(Blits, DrawAllPassesUnlessOneIsNamed)
{
    const auto two = std::make_shared<Material>(
        test::ShaderOf("Shader \"Test/Two\" { SubShader { Pass { " + test::Program() + "} Pass { " +
                       test::Program() + "} } }"),
        "Two");
    m_Cmd.Blit(m_Source, m_Dest, two);
    m_Cmd.Blit(m_Source, m_Dest, two, 1);
    const auto draws = test::DrawsOf(Execute());
    ASSERT_EQ(draws.size(), 3u);
    EXPECT_EQ(draws[0].shaderPass, 0);
    EXPECT_EQ(draws[1].shaderPass, 1);
    EXPECT_EQ(draws[2].shaderPass, 1);
}

TEST_F(Blits, KeepWhatThePassPromisesOfAFullScreen)
{
    const auto promising = std::make_shared<Material>(
        test::ShaderOf("Shader \"Test/Full\" { SubShader { Pass { Tags { \"LimnFullScreen\" = "
                       "\"0 0 0 0 where _MainTex is 0\" } " +
                       test::Program() + "} } }"));
    m_Cmd.Blit(m_Source, m_Dest, promising);
    m_Cmd.Blit(m_Source, m_Dest, m_Copy);
    m_Cmd.DrawMesh(test::Cube(), glm::mat4(1.0f), promising);
    const auto draws = test::DrawsOf(Execute());
    ASSERT_EQ(draws.size(), 3u);
    ASSERT_NE(draws[0].fullScreen, nullptr);
    ASSERT_EQ(draws[0].fullScreen->zeroTextures.size(), 1u);
    EXPECT_EQ(draws[0].fullScreen->zeroTextures[0], m_Source.rt());
    EXPECT_EQ(draws[1].fullScreen, nullptr) << "it promises nothing";
    EXPECT_EQ(draws[2].fullScreen, nullptr) << "any mesh covers a part only";
}

TEST_F(Blits, RefuseWhatIsNotThere)
{
    const auto errorOf = [&](const RTHandle& source, const RTHandle& dest,
                             const std::shared_ptr<const Material>& material, int pass)
    {
        const std::string message =
            test::ThrownMessage<ContractError>([&] { m_Cmd.Blit(source, dest, material, pass); });
        EXPECT_TRUE(m_Cmd.commands().empty()) << "nothing is recorded by a call that throws";
        return message;
    };
    EXPECT_THAT(errorOf(RTHandle(), m_Dest, m_Copy, 0),
                Mentions("Blit:", "source", "empty handle"));
    EXPECT_THAT(errorOf(m_Source, RTHandle(), m_Copy, 0),
                Mentions("Blit:", "destination", "empty handle"));
    EXPECT_THAT(errorOf(m_Source, m_Source, m_Copy, 0),
                Mentions("Blit:", "'Source'", "both", "copy"));
    EXPECT_THAT(errorOf(m_Source, m_Dest, nullptr, -1), Mentions("Blit", "material", "null"));
    EXPECT_THAT(errorOf(m_Source, m_Dest, m_Copy, 1),
                Mentions("'Copy'", "'Test/Copy'", "no pass 1", "has 1"));
}

} // namespace limn

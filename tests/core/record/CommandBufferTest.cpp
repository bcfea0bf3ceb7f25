#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <limn/core/CoreUtils.h>
#include <limn/core/ProfilingScope.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "record/RecordedCommands.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

using test::Mentions;

std::shared_ptr<const RenderTexture> Multisampled(const std::string& name)
{
    RenderTextureDescriptor descriptor(8, 4, GraphicsFormat::R8_UNorm);
    descriptor.msaaSamples = 4;
    return std::make_shared<const RenderTexture>(name, descriptor);
}

/// What a command buffer keeps and refuses.
class CommandBuffers : public testing::Test
{
protected:
    template <typename Action>
    std::string ErrorOf(Action&& action)
    {
        const std::string message = test::ThrownMessage<ContractError>(action);
        EXPECT_TRUE(m_Cmd.commands().empty()) << "nothing is recorded by a call that throws";
        return message;
    }

    CommandBuffer m_Cmd;
    const RTHandle m_Color{test::Target("Color")};
    const RTHandle m_Depth{test::DepthTarget("Depth")};
    const std::shared_ptr<const Material> m_Material =
        std::make_shared<Material>(test::ShaderWithModes({"A", "B"}), "Two");
};

TEST_F(CommandBuffers, KeepCommandsInOrderUntilCleared)
{
    m_Cmd.BeginSample("mask");
    m_Cmd.SetRenderTarget(m_Color, m_Depth);
    m_Cmd.ClearRenderTarget(ClearFlag::Color, Color::red);
    m_Cmd.DrawProcedural(glm::mat4(1.0f), m_Material, 1, 3);
    m_Cmd.EndSample();
    ASSERT_EQ(m_Cmd.commands().size(), 5u);
    EXPECT_EQ(std::get<BeginSampleCommand>(m_Cmd.commands()[0]).name, "mask");
    EXPECT_EQ(std::get<SetRenderTargetCommand>(m_Cmd.commands()[1]).depth, m_Depth.rt());
    EXPECT_EQ(std::get<ClearCommand>(m_Cmd.commands()[2]).color, Color::red);
    EXPECT_EQ(std::get<RecordedDraw>(m_Cmd.commands()[3]).shaderPass, 1);
    m_Cmd.Clear();
    EXPECT_TRUE(m_Cmd.commands().empty());
}

TEST_F(CommandBuffers, EndTheSampleOfAName)
{
    m_Cmd.BeginSample("outer");
    m_Cmd.BeginSample("inner");
    m_Cmd.EndSample("inner");
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Cmd.EndSample("inner"); }),
                Mentions("EndSample", "'inner'", "innermost", "'outer'"));
    m_Cmd.EndSample("outer");
    m_Cmd.EndSample("of another buffer");
    ASSERT_EQ(m_Cmd.commands().size(), 5u);
    EXPECT_TRUE(std::holds_alternative<EndSampleCommand>(m_Cmd.commands()[4]));
}

TEST_F(CommandBuffers, ClearDepthWithTheStencilWhereToldByBools)
{
    const auto flagsOf = [&](bool depth, bool color)
    {
        m_Cmd.Clear();
        m_Cmd.ClearRenderTarget(depth, color, Color::red, 0.25f);
        const auto& clear = std::get<ClearCommand>(m_Cmd.commands().at(0));
        EXPECT_EQ(clear.color, Color::red);
        EXPECT_EQ(clear.depth, 0.25f);
        return clear.flags;
    };
    EXPECT_EQ(flagsOf(false, false), ClearFlag::None);
    EXPECT_EQ(flagsOf(true, false), ClearFlag::DepthStencil);
    EXPECT_EQ(flagsOf(false, true), ClearFlag::Color);
    EXPECT_EQ(flagsOf(true, true), ClearFlag::All);
}

TEST_F(CommandBuffers, RefuseTargetsThatAreEmpty)
{
    EXPECT_THAT(ErrorOf([&] { m_Cmd.SetRenderTarget(RTHandle()); }),
                Mentions("SetRenderTarget", "both", "empty handles"));
    const std::vector<RTHandle> colors{m_Color, RTHandle()};
    EXPECT_THAT(ErrorOf([&] { m_Cmd.SetRenderTarget(colors, m_Depth); }),
                Mentions("SetRenderTarget", "a colour target", "empty handle"));
}

TEST_F(CommandBuffers, RefuseTargetsOfDifferentSizes)
{
    const RTHandle large(test::DepthTarget("Large", 16, 4));
    EXPECT_THAT(ErrorOf([&] { m_Cmd.SetRenderTarget(m_Color, large); }),
                Mentions("SetRenderTarget", "'Color' is 8x4", "'Large' is 16x4"));
}

TEST_F(CommandBuffers, RefuseTargetsOfDifferentSampleCounts)
{
    const RTHandle samples(Multisampled("Samples"));
    EXPECT_THAT(ErrorOf([&] { m_Cmd.SetRenderTarget(samples, m_Depth); }),
                Mentions("SetRenderTarget", "'Samples'", "4 samples", "'Depth'", "1 sample"));
}

TEST_F(CommandBuffers, RefuseMoreColorsThanAPassWrites)
{
    const std::vector<RTHandle> colors(9, m_Color);
    EXPECT_THAT(ErrorOf([&] { m_Cmd.SetRenderTarget(colors, m_Depth); }),
                Mentions("SetRenderTarget", "9 colour targets", "at most 8"));
}

TEST_F(CommandBuffers, RefuseAColorAsDepthAndADepthAmongColors)
{
    EXPECT_THAT(
        ErrorOf([&] { m_Cmd.SetRenderTarget(m_Color, m_Color); }),
        Mentions("SetRenderTarget", "depth target 'Color'", "R8G8B8A8_UNorm", "depth format"));
    EXPECT_THAT(
        ErrorOf([&] { m_Cmd.SetRenderTarget(m_Depth, m_Depth); }),
        Mentions("SetRenderTarget", "colour target 'Depth'", "D32_SFloat_S8_UInt", "depth"));
}

TEST_F(CommandBuffers, TakeADepthTextureOnItsOwnAsDepth)
{
    m_Cmd.SetRenderTarget(m_Depth);
    ASSERT_EQ(m_Cmd.commands().size(), 1u);
    const auto& target = std::get<SetRenderTargetCommand>(m_Cmd.commands()[0]);
    EXPECT_TRUE(target.colors.empty());
    EXPECT_EQ(target.depth, m_Depth.rt());
}

TEST_F(CommandBuffers, RefuseAViewportThatEndsBeyondTheLargestInt)
{
    constexpr int k_Most = std::numeric_limits<int>::max();
    EXPECT_THAT(ErrorOf(
                    [&] {
                        m_Cmd.SetViewport({10, 0, k_Most, 4});
                    }),
                Mentions("SetViewport", "2147483647x4", "(10, 0)", "beyond", "2147483647"));
    EXPECT_THAT(ErrorOf(
                    [&] {
                        m_Cmd.SetViewport({0, 1, 4, k_Most});
                    }),
                Mentions("SetViewport", "4x2147483647", "(0, 1)", "beyond", "2147483647"));
    m_Cmd.SetViewport({-10, 0, k_Most, k_Most});
    EXPECT_EQ(m_Cmd.commands().size(), 1u);
}

TEST_F(CommandBuffers, RefuseAViewportWithoutTexels)
{
    EXPECT_THAT(ErrorOf(
                    [&] {
                        m_Cmd.SetViewport({0, 0, 0, 4});
                    }),
                Mentions("SetViewport", "0x4", "greater than 0"));
}

TEST_F(CommandBuffers, RefuseToClearToADepthOutsideTheRange)
{
    EXPECT_THAT(ErrorOf([&] { m_Cmd.ClearRenderTarget(ClearFlag::All, Color::red, 1.5f); }),
                Mentions("ClearRenderTarget", "depth is 1.5", "0 (near)", "1 (far)"));
    EXPECT_THAT(ErrorOf([&] { m_Cmd.ClearRenderTarget(ClearFlag::All, Color::red, -0.5f); }),
                Mentions("ClearRenderTarget", "depth is -0.5", "0 (near)", "1 (far)"));
    EXPECT_THAT(
        ErrorOf([&] { m_Cmd.ClearRenderTarget(ClearFlag::All, Color::red, std::nanf("")); }),
        Mentions("ClearRenderTarget", "depth is nan", "0 (near)", "1 (far)"));
}

TEST_F(CommandBuffers, RefuseToClearToAColorThatIsNotFinite)
{
    for (const float bad : {std::nanf(""), HUGE_VALF})
    {
        EXPECT_THAT(ErrorOf(
                        [&] {
                            m_Cmd.ClearRenderTarget(ClearFlag::Color, {0, 0, bad, 1});
                        }),
                    Mentions("ClearRenderTarget", "colour", "not finite"));
    }
}

TEST_F(CommandBuffers, RefuseAMatrixThatIsNotFinite)
{
    const auto message = Mentions("'Two'", "matrix", "not finite");
    EXPECT_THAT(
        ErrorOf([&] { m_Cmd.DrawMesh(test::Cube(), glm::mat4(std::nanf("")), m_Material); }),
        message);
    EXPECT_THAT(ErrorOf([&] { m_Cmd.DrawProcedural(glm::mat4(HUGE_VALF), m_Material, 0, 3); }),
                message);
}

TEST_F(CommandBuffers, RefuseDrawsThatLackSomething)
{
    const glm::mat4 matrix(1.0f);
    EXPECT_THAT(ErrorOf([&] { m_Cmd.DrawMesh(test::Cube(), matrix, nullptr); }),
                Mentions("DrawMesh", "material", "null"));
    EXPECT_THAT(ErrorOf([&] { m_Cmd.DrawMesh(nullptr, matrix, m_Material); }),
                Mentions("DrawMesh", "mesh", "null"));
    EXPECT_THAT(ErrorOf([&] { m_Cmd.DrawProcedural(matrix, nullptr, 0, 3); }),
                Mentions("DrawProcedural", "material", "null"));
    EXPECT_THAT(ErrorOf([&] { m_Cmd.DrawProcedural(matrix, m_Material, 0, -3); }),
                Mentions("DrawProcedural", "vertex count -3", "negative"));
}

TEST_F(CommandBuffers, RefuseDrawsOfPartsThatDoNotExist)
{
    const glm::mat4 matrix(1.0f);
    EXPECT_THAT(ErrorOf([&] { m_Cmd.DrawMesh(test::Cube(), matrix, m_Material, 0, 2); }),
                Mentions("'Two'", "'Test/Modes'", "no pass 2", "has 2"));
    EXPECT_THAT(ErrorOf([&] { m_Cmd.DrawProcedural(matrix, m_Material, -1, 3); }),
                Mentions("'Two'", "'Test/Modes'", "no pass -1", "has 2"));
    const std::string mesh = "'" + test::Cube()->name() + "'";
    EXPECT_THAT(ErrorOf([&] { m_Cmd.DrawMesh(test::Cube(), matrix, m_Material, 1); }),
                Mentions(mesh, "no sub-mesh 1", "has 1"));
    EXPECT_THAT(ErrorOf([&] { m_Cmd.DrawMesh(test::Cube(), matrix, m_Material, -1); }),
                Mentions(mesh, "no sub-mesh -1", "has 1"));
}

TEST(CommandBufferPool, GivesOutEmptyBuffers)
{
    CommandBufferPool::Pooled first = CommandBufferPool::Get();
    first->BeginSample("left over");
    CommandBufferPool::Release(first);
    EXPECT_EQ(first, nullptr);
    EXPECT_TRUE(CommandBufferPool::Get()->commands().empty());
}

TEST(CommandBufferPool, GivesABufferThatWasReturnedOutAgain)
{
    CommandBufferPool::Pooled first = CommandBufferPool::Get();
    const CommandBuffer* address = first.get();
    CommandBufferPool::Release(first);
    EXPECT_EQ(CommandBufferPool::Get().get(), address);
}

TEST(CommandBufferPool, GivesTwoOwnersTwoBuffers)
{
    const CommandBufferPool::Pooled first = CommandBufferPool::Get();
    const CommandBufferPool::Pooled second = CommandBufferPool::Get();
    EXPECT_NE(first, second);
}

TEST(ProfilingScope, NamesWhatIsRecordedWhileItLives)
{
    CommandBuffer cmd;
    const ProfilingSampler sampler("Outline");
    {
        const ProfilingScope scope(cmd, sampler);
        cmd.SetGlobalFloat(ShaderPropertyId("_Value"), 1.0f);
    }
    ASSERT_EQ(cmd.commands().size(), 3u);
    EXPECT_EQ(std::get<BeginSampleCommand>(cmd.commands()[0]).name, "Outline");
    EXPECT_TRUE(std::holds_alternative<EndSampleCommand>(cmd.commands()[2]));
}

TEST_F(CommandBuffers, ClearWhatCoreUtilsIsAskedTo)
{
    CoreUtils::SetRenderTarget(m_Cmd, m_Color);
    EXPECT_EQ(m_Cmd.commands().size(), 1u);
    CoreUtils::SetRenderTarget(m_Cmd, m_Color, m_Depth, ClearFlag::All, Color::green);
    ASSERT_EQ(m_Cmd.commands().size(), 3u);
    const auto& clear = std::get<ClearCommand>(m_Cmd.commands()[2]);
    EXPECT_EQ(clear.flags, ClearFlag::All);
    EXPECT_EQ(clear.color, Color::green);
    EXPECT_EQ(clear.depth, 1.0f);
    EXPECT_EQ(clear.stencil, 0);
}

TEST(CoreUtils, RefusesAMaterialWithoutAShader)
{
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [] { CoreUtils::CreateEngineMaterial(std::shared_ptr<const Shader>()); }),
                Mentions("CreateEngineMaterial", "no shader"));
}

TEST_F(CommandBuffers, BlitATriangleOverTheDestination)
{
    const RTHandle destination(test::Target("Destination"));
    Blitter::BlitCameraTexture(m_Cmd, m_Color, destination, m_Material, 1);
    ASSERT_EQ(m_Cmd.commands().size(), 2u);
    const auto& target = std::get<SetRenderTargetCommand>(m_Cmd.commands()[0]);
    ASSERT_EQ(target.colors.size(), 1u);
    EXPECT_EQ(target.colors[0], destination.rt());
    EXPECT_EQ(target.depth, nullptr);
    const auto& draw = std::get<RecordedDraw>(m_Cmd.commands()[1]);
    EXPECT_EQ(draw.mesh, nullptr);
    EXPECT_EQ(draw.vertexCount, 3u);
    EXPECT_EQ(draw.shaderPass, 1);
    const auto* source = m_Cmd.PropertiesOf(draw)->Find(ShaderPropertyId("_BlitTexture"));
    ASSERT_NE(source, nullptr);
    EXPECT_EQ(std::get<std::shared_ptr<const Texture>>(*source), m_Color.rt());
    const auto* scaleBias = m_Cmd.PropertiesOf(draw)->Find(ShaderPropertyId("_BlitScaleBias"));
    ASSERT_NE(scaleBias, nullptr);
    EXPECT_EQ(std::get<glm::vec4>(*scaleBias), glm::vec4(1, 1, 0, 0));
}

TEST_F(CommandBuffers, RefuseABlitIntoItsOwnSource)
{
    EXPECT_THAT(
        ErrorOf([&] { Blitter::BlitCameraTexture(m_Cmd, m_Color, m_Color, m_Material, 0); }),
        Mentions("BlitCameraTexture", "'Color'", "both", "copy"));
}

TEST_F(CommandBuffers, RefuseABlitFromOrToNothing)
{
    EXPECT_THAT(
        ErrorOf([&] { Blitter::BlitCameraTexture(m_Cmd, RTHandle(), m_Color, m_Material, 0); }),
        Mentions("BlitCameraTexture", "source", "empty handle"));
    EXPECT_THAT(
        ErrorOf([&] { Blitter::BlitCameraTexture(m_Cmd, m_Color, RTHandle(), m_Material, 0); }),
        Mentions("BlitCameraTexture", "destination", "empty handle"));
    EXPECT_THAT(
        ErrorOf([&] { Blitter::BlitTexture(m_Cmd, RTHandle(), glm::vec4(1), m_Material, 0); }),
        Mentions("BlitTexture", "source", "empty handle"));
}

} // namespace
} // namespace limn

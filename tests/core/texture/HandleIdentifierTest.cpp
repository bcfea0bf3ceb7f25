#include <gtest/gtest.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/RenderTexturePool.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

/// Handles around what a name stands for.
class HandlesOfIdentifiers : public testing::Test
{
protected:
    HandlesOfIdentifiers() { m_Context.BeginCamera({m_Color, m_Depth, &m_Pool, nullptr}); }

    std::vector<test::SeenDraw> Draws()
    {
        m_Context.ExecuteCommandBuffer(m_Cmd);
        m_Frame = m_Context.TakeCommands();
        return test::DrawsOf(m_Frame);
    }

    RenderReport m_Report;
    RenderTexturePool m_Pool;
    ScriptableRenderContext m_Context{m_Report};
    CommandBuffer m_Cmd;
    FrameCommands m_Frame;
    const RTHandle m_Color{test::Target("CameraColor")};
    const RTHandle m_Depth{test::DepthTarget("CameraDepth")};
    const RTHandle m_Camera = RTHandles::Alloc(BuiltinRenderTextureType::CameraTarget);
    const RTHandle m_Temp = RTHandles::Alloc("_Temp");
    const std::shared_ptr<const Material> m_Reads = std::make_shared<Material>(
        test::ShaderWithProgram("", "Texture2D _BlitTexture;", "_BlitTexture.Load(int3(0, 0, 0))"));
};

TEST_F(HandlesOfIdentifiers, HaveNoTextureOfTheirOwn)
{
    EXPECT_TRUE(m_Temp);
    EXPECT_EQ(m_Temp.rt(), nullptr);
    EXPECT_EQ(m_Temp.nameID(), RenderTargetIdentifier("_Temp"));
    EXPECT_EQ(m_Camera.nameID(), BuiltinRenderTextureType::CameraTarget);
    EXPECT_EQ(m_Color.nameID(), RenderTargetIdentifier(m_Color));
    EXPECT_EQ(RTHandle().nameID(), RenderTargetIdentifier());
    RTHandle handle = m_Temp;
    EXPECT_EQ(handle, m_Temp);
    handle.Release();
    EXPECT_FALSE(handle);
}

TEST_F(HandlesOfIdentifiers, WrapWhatThereIs)
{
    EXPECT_EQ(RTHandles::Alloc(m_Color.rt()), m_Color);
    EXPECT_EQ(test::ThrownMessage<ContractError>(
                  [] { RTHandles::Alloc(std::shared_ptr<const RenderTexture>()); }),
              "RTHandles::Alloc: the texture is null");
    EXPECT_EQ(
        test::ThrownMessage<ContractError>([] { RTHandles::Alloc(RenderTargetIdentifier()); }),
        "RTHandles::Alloc: the identifier is none");
}

// URP 14: a handle whose rt is null is replaced whatever is asked for.
TEST_F(HandlesOfIdentifiers, AreReplacedByReAllocateIfNeeded)
{
    RTHandle handle = m_Temp;
    EXPECT_TRUE(RenderingUtils::ReAllocateIfNeeded(handle, {8, 4, GraphicsFormat::R8G8B8A8_UNorm}));
    ASSERT_NE(handle.rt(), nullptr);
    EXPECT_EQ(handle.rt()->width(), 8);
}

TEST_F(HandlesOfIdentifiers, AreTargetsAndSourcesOfCommands)
{
    m_Cmd.GetTemporaryRT("_Temp", 8, 4);
    CoreUtils::SetRenderTarget(m_Cmd, m_Temp, m_Camera);
    Blitter::BlitCameraTexture(m_Cmd, m_Camera, m_Temp, m_Reads, 0);
    m_Cmd.Blit(m_Temp, m_Color, m_Reads);
    m_Cmd.SetGlobalTexture("_BlitTexture", m_Camera);
    m_Cmd.SetRenderTarget(m_Temp);
    m_Cmd.DrawProcedural(glm::mat4(1.0f), m_Reads, 0, 3);
    const auto draws = Draws();
    std::vector<const SetRenderTargetCommand*> targets;
    for (const FrameCommand& command : m_Frame.commands)
    {
        if (const auto* target = std::get_if<SetRenderTargetCommand>(&command))
        {
            targets.push_back(target);
        }
    }
    ASSERT_EQ(targets.size(), 4u);
    const auto temporary = targets[0]->colors[0];
    EXPECT_EQ(temporary->width(), 8);
    EXPECT_EQ(targets[0]->depth, m_Depth.rt());
    EXPECT_EQ(targets[1]->colors[0], temporary);
    EXPECT_EQ(targets[2]->colors[0], m_Color.rt());
    EXPECT_EQ(targets[3]->colors[0], temporary);
    ASSERT_EQ(draws.size(), 3u);
    EXPECT_EQ(draws[0].bindings->textures.at(0).texture, m_Color.rt());
    EXPECT_EQ(draws[2].bindings->textures.at(0).texture, m_Color.rt());
}

TEST_F(HandlesOfIdentifiers, CannotBeSourceAndDestination)
{
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { Blitter::BlitCameraTexture(m_Cmd, m_Temp, m_Temp, m_Reads, 0); }),
                test::Mentions("BlitCameraTexture", "'one identifier'", "both", "copy"));
}

} // namespace
} // namespace limn

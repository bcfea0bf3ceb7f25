#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/RenderTexturePool.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

/// What Blitter's functions come to besides the two that take a source, a material and a pass.
class BlitterForms : public testing::Test
{
protected:
    BlitterForms() { m_Context.BeginCamera({m_Color, m_Depth, &m_Pool, m_CopyMaterial}); }

    std::vector<test::SeenDraw> Execute()
    {
        m_Context.ExecuteCommandBuffer(m_Cmd);
        m_Cmd.Clear();
        m_Frame = m_Context.TakeCommands();
        return test::DrawsOf(m_Frame);
    }
    std::vector<float> ScaleBias(const test::SeenDraw& draw) const
    {
        return test::ReadUniform<float>(m_Frame, draw, "_BlitScaleBias", 4);
    }
    const SetRenderTargetCommand& Target(std::size_t index) const
    {
        return std::get<SetRenderTargetCommand>(m_Frame.commands.at(index));
    }
    static std::shared_ptr<const Texture> SourceOf(const test::SeenDraw& draw)
    {
        return draw.bindings->textures.at(0).texture;
    }

    RenderReport m_Report;
    RenderTexturePool m_Pool;
    ScriptableRenderContext m_Context{m_Report};
    CommandBuffer m_Cmd;
    FrameCommands m_Frame;
    const RTHandle m_Color{test::Target("CameraColor")};
    const RTHandle m_Depth{test::DepthTarget("CameraDepth")};
    const RTHandle m_Source{test::Target("Source")};
    const RTHandle m_Dest{test::Target("Dest")};
    const std::shared_ptr<const Material> m_CopyMaterial = CoreUtils::CreateEngineMaterial(
        FindBuiltinShader("Hidden/Universal/CoreBlit", test::Compiler()));
    const std::shared_ptr<const Material> m_Reads = std::make_shared<Material>(
        test::ShaderWithProgram("", "Texture2D _BlitTexture; float4 _BlitScaleBias;",
                                "_BlitTexture.Load(int3(0, 0, 0)) + _BlitScaleBias"));
};

TEST_F(BlitterForms, CopyOntoWhatIsBoundWithoutAMaterial)
{
    m_Cmd.SetRenderTarget(m_Dest);
    Blitter::BlitTexture(m_Cmd, m_Source, {0.5f, 1, 0.25f, 0}, 0, false);
    Blitter::BlitTexture(m_Cmd, m_Source, {1, 1, 0, 0}, 0, true);
    const auto draws = Execute();
    ASSERT_EQ(m_Frame.commands.size(), 3u) << "one target";
    EXPECT_EQ(draws.at(0).program, m_CopyMaterial->Compile(0));
    EXPECT_EQ(draws.at(1).program, m_CopyMaterial->Compile(1));
    EXPECT_EQ(SourceOf(draws[0]), m_Source.rt());
    EXPECT_EQ(ScaleBias(draws[0]), (std::vector<float>{0.5f, 1, 0.25f, 0}));
}

TEST_F(BlitterForms, CopyIntoATextureOrAPartOfIt)
{
    Blitter::BlitCameraTexture(m_Cmd, m_Source, m_Dest);
    Blitter::BlitCameraTexture(m_Cmd, m_Source, m_Dest, {1, 1, 2, 2}, 0, true);
    const auto draws = Execute();
    ASSERT_EQ(m_Frame.commands.size(), 5u);
    EXPECT_EQ(Target(0).colors[0], m_Dest.rt());
    EXPECT_EQ(Target(0).depth, nullptr);
    EXPECT_EQ(draws.at(0).program, m_CopyMaterial->Compile(0));
    EXPECT_EQ(std::get<SetViewportCommand>(m_Frame.commands[3]).rect, (ViewportRect{1, 1, 2, 2}));
    EXPECT_EQ(draws.at(1).program, m_CopyMaterial->Compile(1));
    EXPECT_EQ(ScaleBias(draws[1]), (std::vector<float>{1, 1, 0, 0}));
}

TEST_F(BlitterForms, HaveNoMipLevelThatTheSourceHasNot)
{
    Blitter::BlitCameraTexture(m_Cmd, m_Source, m_Dest, 1.0f);
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Execute(); }),
                test::Mentions("BlitTexture", "'" + m_Source.rt()->name() + "'", "no mip level 1;",
                               "is 1"));
    m_Cmd.Clear();
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] {
                        Blitter::BlitTexture(m_Cmd, RTHandle(), {1, 1, 0, 0}, 0, false);
                    }),
                test::Mentions("BlitTexture", "source", "empty handle"));
}

TEST_F(BlitterForms, LeaveASourceByIdentifierGlobal)
{
    m_Cmd.SetRenderTarget(m_Dest);
    Blitter::BlitTexture(m_Cmd, m_Source.nameID(), {2, 2, 0, 0}, m_Reads, 0);
    Blitter::BlitTexture(m_Cmd, {3, 3, 0, 0}, m_Reads, 0);
    Blitter::BlitTexture(m_Cmd, BuiltinRenderTextureType::CameraTarget, m_Source.nameID(), m_Reads,
                         0);
    const auto draws = Execute();
    ASSERT_EQ(draws.size(), 3u);
    EXPECT_EQ(SourceOf(draws[0]), m_Source.rt());
    EXPECT_EQ(SourceOf(draws[1]), m_Source.rt());
    EXPECT_EQ(SourceOf(draws[2]), m_Color.rt());
    EXPECT_EQ(ScaleBias(draws[0]), (std::vector<float>{2, 2, 0, 0}));
    EXPECT_EQ(ScaleBias(draws[1]), (std::vector<float>{3, 3, 0, 0}));
    EXPECT_EQ(ScaleBias(draws[2]), (std::vector<float>{1, 1, 0, 0}));
    EXPECT_EQ(Target(3).colors[0], m_Source.rt());
}

// What is loaded and stored is no command: with actions or without, the frame is the same.
TEST_F(BlitterForms, TakeLoadAndStoreActions)
{
    using Load = RenderBufferLoadAction;
    using Store = RenderBufferStoreAction;
    m_Cmd.SetRenderTarget(m_Dest, Load::DontCare, Store::Store);
    m_Cmd.SetRenderTarget(m_Dest, Load::Load, Store::Resolve, m_Depth, Load::DontCare,
                          Store::DontCare);
    Blitter::BlitCameraTexture(m_Cmd, m_Source, m_Dest, Load::DontCare, Store::Store, m_Reads, 0);
    Execute();
    ASSERT_EQ(m_Frame.commands.size(), 4u);
    EXPECT_THAT(Target(0).colors, ElementsAre(m_Dest.rt()));
    EXPECT_EQ(Target(0).depth, nullptr);
    EXPECT_EQ(Target(1).depth, m_Depth.rt());
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { m_Cmd.SetRenderTarget(m_Dest, Load::Clear, Store::Store); }),
                test::Mentions("SetRenderTarget", "RenderBufferLoadAction::Clear", "colour",
                               "ClearRenderTarget"));
}

// Unity: CoreUtils.SetRenderTarget (core 14) in all its forms of one or two targets.
TEST_F(BlitterForms, BindAndClearTargetsWithAndWithoutActions)
{
    using Load = RenderBufferLoadAction;
    using Store = RenderBufferStoreAction;
    const RenderTargetIdentifier color = m_Dest.nameID();
    const RenderTargetIdentifier depth = m_Depth.nameID();
    CoreUtils::SetRenderTarget(m_Cmd, m_Dest, Load::DontCare, Store::Store);
    CoreUtils::SetRenderTarget(m_Cmd, m_Dest, Load::Load, Store::Store, m_Depth, Load::Load,
                               Store::DontCare, ClearFlag::Depth);
    CoreUtils::SetRenderTarget(m_Cmd, color, ClearFlag::Color, Color::red);
    CoreUtils::SetRenderTarget(m_Cmd, color, depth);
    CoreUtils::SetRenderTarget(m_Cmd, color, Load::DontCare, Store::Store, ClearFlag::Color,
                               Color::green);
    CoreUtils::SetRenderTarget(m_Cmd, color, Load::Load, Store::Store, depth, Load::Load,
                               Store::Store, ClearFlag::None);
    m_Cmd.SetRenderTarget(m_Dest, Load::Load, Store::Store, m_Depth, Load::Load, Store::Store);
    Execute();
    std::vector<std::string> seen;
    for (const FrameCommand& command : m_Frame.commands)
    {
        const auto* target = std::get_if<SetRenderTargetCommand>(&command);
        const auto* clear = std::get_if<ClearCommand>(&command);
        seen.push_back(target  ? target->colors[0]->name() + (target->depth ? "+depth" : "")
                       : clear ? (clear->flags & ClearFlag::Depth ? "clear depth"
                                  : clear->color == Color::red    ? "clear red"
                                                                  : "clear green")
                               : "other");
    }
    EXPECT_THAT(seen, ElementsAre("Dest", "Dest+depth", "clear depth", "Dest", "clear red",
                                  "Dest+depth", "Dest", "clear green", "Dest+depth", "Dest+depth"));
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { CoreUtils::SetRenderTarget(m_Cmd, m_Dest, Load::Clear, Store::Store); }),
                test::Mentions("SetRenderTarget", "RenderBufferLoadAction::Clear"));
}

TEST_F(BlitterForms, NeedACameraForPlainCopies)
{
    m_Context.EndCamera();
    m_Cmd.SetRenderTarget(m_Dest);
    Blitter::BlitTexture(m_Cmd, m_Source, {1, 1, 0, 0}, 0, false);
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Execute(); }),
                HasSubstr("BlitTexture: no camera is rendered"));
}

} // namespace
} // namespace limn

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/FrameCompiler.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "frame/FrameBuilder.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

using test::CommandsOf;
using test::FrameBuilder;
using test::Mentions;
using testing::ElementsAre;
using testing::IsEmpty;

/// How a frame's commands become passes.
class FrameCompilerPasses : public testing::Test
{
protected:
    CompiledFrame Compile(FrameBuilder& builder) { return m_Compiler.Compile(builder.Take()); }
    std::string ErrorOf(FrameBuilder& builder)
    {
        return test::ThrownMessage<ContractError>([&] { Compile(builder); });
    }

    test::FrameCompiler m_Compiler;
    FrameBuilder m_Frame;
    const test::RenderTexturePtr m_A = test::Target("A");
    const test::RenderTexturePtr m_B = test::Target("B");
    const test::RenderTexturePtr m_Depth = test::DepthTarget("Depth");
};

TEST_F(FrameCompilerPasses, MakeNoneOfNoCommands)
{
    const CompiledFrame frame = Compile(m_Frame);
    EXPECT_THAT(frame.passes, IsEmpty());
    EXPECT_THAT(frame.finalBarriers, IsEmpty());
}

TEST_F(FrameCompilerPasses, PutDrawsOnOneTargetTogether)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1).Draw(2);
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 1u);
    const CompiledRenderPass& pass = frame.passes[0];
    EXPECT_THAT(CommandsOf(pass), ElementsAre("draw 1", "draw 2"));
    ASSERT_EQ(pass.colors.size(), 1u);
    EXPECT_EQ(pass.colors[0].texture, m_A);
    ASSERT_TRUE(pass.depth);
    EXPECT_EQ(pass.depth->texture, m_Depth);
    EXPECT_EQ(pass.width, 8);
    EXPECT_EQ(pass.height, 4);
}

//   bind A  draw 1  bind B  draw 2  bind A  draw 3
//  └──── pass A ───┘└─── pass B ──┘└─── pass A ──┘
TEST_F(FrameCompilerPasses, SplitWhereAnotherTargetIsDrawnInto)
{
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Draw(2).Bind(m_A).Draw(3);
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 3u);
    EXPECT_EQ(frame.passes[0].colors[0].texture, m_A);
    EXPECT_EQ(frame.passes[1].colors[0].texture, m_B);
    EXPECT_EQ(frame.passes[2].colors[0].texture, m_A);
    EXPECT_THAT(CommandsOf(frame.passes[2]), ElementsAre("draw 3"));
}

TEST_F(FrameCompilerPasses, SplitWhereOnlyTheDepthDiffers)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1).Bind(m_A).Draw(2);
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 2u);
    EXPECT_TRUE(frame.passes[0].depth);
    EXPECT_FALSE(frame.passes[1].depth);
}

TEST_F(FrameCompilerPasses, ContinueWhereTheSameTargetIsBoundAgain)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1).Bind(m_A, m_Depth).Draw(2);
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_THAT(CommandsOf(frame.passes[0]), ElementsAre("draw 1", "draw 2"));
}

TEST_F(FrameCompilerPasses, LeaveOutATargetThatIsBoundAndNeverDrawnInto)
{
    m_Frame.Bind(m_B).Bind(m_A).Draw(1).Bind(m_B);
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_EQ(frame.passes[0].colors[0].texture, m_A);
}

TEST_F(FrameCompilerPasses, ContinueAcrossATargetThatWasNeverDrawnInto)
{
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Bind(m_A).Draw(2);
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_THAT(CommandsOf(frame.passes[0]), ElementsAre("draw 1", "draw 2"));
}

TEST_F(FrameCompilerPasses, LeaveOutAClearOfNothing)
{
    m_Frame.Bind(m_A).Clear(ClearFlag::None);
    EXPECT_THAT(Compile(m_Frame).passes, IsEmpty());
}

TEST_F(FrameCompilerPasses, KeepAClearWithoutADraw)
{
    m_Frame.Bind(m_A).Clear(ClearFlag::Color, Color::red);
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_EQ(frame.passes[0].colors[0].load, LoadOp::Clear);
    EXPECT_EQ(frame.passes[0].colors[0].clearColor, Color::red);
    EXPECT_THAT(CommandsOf(frame.passes[0]), IsEmpty());
}

TEST_F(FrameCompilerPasses, DrawIntoDepthAlone)
{
    m_Frame.Bind(nullptr, m_Depth).Draw(1);
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_THAT(frame.passes[0].colors, IsEmpty());
    EXPECT_EQ(frame.passes[0].depth->texture, m_Depth);
    EXPECT_EQ(frame.passes[0].width, 8);
}

TEST_F(FrameCompilerPasses, DrawIntoSeveralColors)
{
    m_Frame.Bind({m_A, m_B}, m_Depth).Draw(1);
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 1u);
    ASSERT_EQ(frame.passes[0].colors.size(), 2u);
    EXPECT_EQ(frame.passes[0].colors[1].texture, m_B);
}

// A logical operation is one for all colours of a pass.
TEST_F(FrameCompilerPasses, ContinueOnMoreOrFewerColorsWithoutALogicalOperation)
{
    for (const BlendOp operation : {BlendOp::Max, BlendOp::LogicalClear, BlendOp::LogicalXor})
    {
        const std::size_t expected = operation == BlendOp::Max ? 1 : 2;
        m_Frame.Bind(m_A).Draw(1);
        m_Frame.last().state.targets[0].colorBlendOperation = operation;
        m_Frame.Bind({m_A, m_B}, nullptr).Draw(2);
        EXPECT_EQ(test::FrameCompiler(true).Compile(m_Frame.Take(), {m_A, m_B}).passes.size(),
                  expected);
        m_Frame.Bind({m_A, m_B}, nullptr).Draw(1).Bind(m_A).Draw(2);
        m_Frame.last().state.targets[0].alphaBlendOperation = operation;
        EXPECT_EQ(test::FrameCompiler(true).Compile(m_Frame.Take(), {m_A, m_B}).passes.size(),
                  expected);
    }
}

TEST_F(FrameCompilerPasses, SetTheViewportBeforeTheDrawsThatItIsFor)
{
    m_Frame.Bind(m_A).Draw(1).Viewport(1, 2, 3, 1).Draw(2);
    EXPECT_THAT(CommandsOf(Compile(m_Frame).passes.at(0)),
                ElementsAre("draw 1", "viewport 1 2 3 1", "draw 2"));
}

TEST_F(FrameCompilerPasses, SetTheViewportOfAPassThatBeginsWithIt)
{
    m_Frame.Bind(m_A).Viewport(1, 2, 3, 1).Draw(1);
    EXPECT_THAT(CommandsOf(Compile(m_Frame).passes.at(0)),
                ElementsAre("viewport 1 2 3 1", "draw 1"));
}

TEST_F(FrameCompilerPasses, UndoTheViewportWhereTheTargetIsBoundAgain)
{
    m_Frame.Bind(m_A).Viewport(1, 2, 3, 1).Draw(1).Bind(m_A).Draw(2);
    EXPECT_THAT(CommandsOf(Compile(m_Frame).passes.at(0)),
                ElementsAre("viewport 1 2 3 1", "draw 1", "viewport 0 0 8 4", "draw 2"));
}

TEST_F(FrameCompilerPasses, ForgetTheViewportOfTheTargetBefore)
{
    m_Frame.Bind(m_A).Viewport(1, 2, 3, 1).Bind(m_B).Draw(1);
    EXPECT_THAT(CommandsOf(Compile(m_Frame).passes.at(0)), ElementsAre("draw 1"));
}

TEST_F(FrameCompilerPasses, KeepAClearOfAViewportInsideThePass)
{
    m_Frame.Bind(m_A).Viewport(1, 2, 3, 1).Clear(ClearFlag::Color, Color::red).Draw(1);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_THAT(CommandsOf(pass), ElementsAre("viewport 1 2 3 1", "clear 1", "draw 1"));
    EXPECT_EQ(pass.colors[0].load, LoadOp::DontCare);
}

TEST_F(FrameCompilerPasses, KeepAClearBehindADrawInsideThePass)
{
    m_Frame.Bind(m_A).Draw(1).Clear(ClearFlag::Color, Color::red).Draw(2);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_THAT(CommandsOf(pass), ElementsAre("draw 1", "clear 1", "draw 2"));
    EXPECT_EQ(std::get<ClearCommand>(pass.commands[1]).color, Color::red);
}

TEST_F(FrameCompilerPasses, KeepAFullClearBehindAClearOfAViewport)
{
    m_Frame.Bind(m_A).Viewport(1, 2, 3, 1).Clear(ClearFlag::Color, Color::red);
    m_Frame.Bind(m_A).Clear(ClearFlag::Color, Color::green);
    EXPECT_THAT(CommandsOf(Compile(m_Frame).passes.at(0)),
                ElementsAre("viewport 1 2 3 1", "clear 1", "viewport 0 0 8 4", "clear 1"));
}

TEST_F(FrameCompilerPasses, AreNamedAfterTheInnermostSample)
{
    m_Frame.Begin("Frame").Begin("Mask").Bind(m_A).Draw(1).End();
    m_Frame.Bind(m_B).Draw(2).End().Bind(m_A).Draw(3);
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 3u);
    EXPECT_EQ(frame.passes[0].name, "Mask");
    EXPECT_EQ(frame.passes[1].name, "Frame");
    EXPECT_EQ(frame.passes[2].name, "");
}

TEST_F(FrameCompilerPasses, KeepTheOrderOfSamplesAndDraws)
{
    m_Frame.Begin("Opaque").Bind(m_A).Draw(1).End();
    m_Frame.Begin("Empty").Bind(m_B).End();
    m_Frame.Begin("Transparent").Bind(m_A).Draw(2).End();
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_THAT(CommandsOf(frame.passes[0]),
                ElementsAre("begin Opaque", "draw 1", "end", "begin Empty", "end",
                            "begin Transparent", "draw 2", "end"));
}

int Depth(const CompiledFrame& frame)
{
    int depth = 0;
    for (const CompiledRenderPass& pass : frame.passes)
    {
        for (const std::string& text : CommandsOf(pass))
        {
            depth += text.starts_with("begin") ? 1 : text == "end" ? -1 : 0;
            EXPECT_GE(depth, 0);
        }
    }
    return depth;
}

TEST_F(FrameCompilerPasses, BalanceASampleThatSpansSeveral)
{
    m_Frame.Begin("All").Bind(m_A).Draw(1).Bind(m_B).Draw(2).Bind(m_A).End();
    EXPECT_EQ(Depth(Compile(m_Frame)), 0);
}

TEST_F(FrameCompilerPasses, EndTheSamplesThatTheFrameLeavesOpen)
{
    m_Frame.Begin("All").Begin("Inner").Bind(m_A).Draw(1);
    EXPECT_THAT(CommandsOf(Compile(m_Frame).passes.at(0)),
                ElementsAre("begin All", "begin Inner", "draw 1", "end", "end"));
}

TEST_F(FrameCompilerPasses, CannotEndASampleThatNeverBegan)
{
    m_Frame.Bind(m_A).Draw(1).End();
    EXPECT_THAT(ErrorOf(m_Frame), Mentions("EndSample", "without", "BeginSample"));
}

TEST_F(FrameCompilerPasses, NeedATargetForADraw)
{
    m_Frame.Begin("Outline").Draw(1);
    EXPECT_THAT(ErrorOf(m_Frame), Mentions("draw", "'Outline'", "before", "render target"));
}

TEST_F(FrameCompilerPasses, NeedATargetForAClear)
{
    m_Frame.Clear(ClearFlag::All);
    EXPECT_THAT(ErrorOf(m_Frame), Mentions("clear", "before", "render target"));
}

TEST_F(FrameCompilerPasses, CannotSampleTheirOwnColor)
{
    m_Frame.Begin("Outline").Bind(m_A, m_Depth).Draw(1, {m_B}).Draw(2, {m_A});
    EXPECT_THAT(ErrorOf(m_Frame), Mentions("'Outline'", "samples 'A'", "drawing into", "copy"));
}

TEST_F(FrameCompilerPasses, CannotSampleTheirOwnDepth)
{
    m_Frame.Begin("Outline").Bind(m_A, m_Depth).Draw(1, {m_Depth});
    EXPECT_THAT(ErrorOf(m_Frame), Mentions("'Outline'", "samples 'Depth'", "drawing into", "copy"));
}

TEST_F(FrameCompilerPasses, CarryTheFramesDataAlong)
{
    FrameCommands commands;
    commands.uniformData = {std::byte{1}, std::byte{2}};
    commands.perDraw.resize(3);
    const CompiledFrame frame = m_Compiler.Compile(std::move(commands));
    EXPECT_EQ(frame.uniformData.size(), 2u);
    EXPECT_EQ(frame.perDraw.size(), 3u);
}

} // namespace
} // namespace limn

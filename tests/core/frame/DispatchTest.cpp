#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/DrawError.h>
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
using testing::UnorderedElementsAre;
using enum TextureUsage;

/// What becomes of dispatches among draws.
class Dispatches : public testing::Test
{
protected:
    CompiledFrame Compile(const std::vector<test::RenderTexturePtr>& outputs = {},
                          bool leavesOut = true)
    {
        FrameCompilerOptions options;
        options.leavesOut = leavesOut;
        CompiledFrame frame = CompileFrame(m_Frame.Take(), m_States, outputs, options);
        m_States = frame.states;
        return frame;
    }

    static std::vector<std::vector<std::string>> Passes(const CompiledFrame& frame)
    {
        std::vector<std::vector<std::string>> passes;
        for (const CompiledRenderPass& pass : frame.passes)
        {
            passes.push_back(CommandsOf(pass));
        }
        return passes;
    }

    TextureStates m_States;
    FrameBuilder m_Frame;
    const test::RenderTexturePtr m_A = test::Target("A");
    const test::RenderTexturePtr m_B = test::Target("B");
    const test::RenderTexturePtr m_Temporary = test::Target("T", 8, 4, true);
    const std::shared_ptr<GraphicsBuffer> m_Buffer =
        std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::Structured, 1, 4);
};

//   draw A ──▶ kernel samples A, writes B ──▶ draw into A samples B
TEST_F(Dispatches, WaitForWhatTheySampleAndAreWaitedFor)
{
    m_Frame.Bind(m_A).Draw(1).Dispatch(2, {m_A}, {m_B}).Draw(3, {m_B});
    const CompiledFrame frame = Compile({m_A});
    ASSERT_EQ(Passes(frame),
              (std::vector<std::vector<std::string>>{{"draw 1"}, {"dispatch 2"}, {"draw 3"}}));
    EXPECT_TRUE(frame.passes[1].isCompute());
    EXPECT_THAT(frame.passes[1].barriers,
                UnorderedElementsAre(TextureBarrier{m_A, ColorAttachment, ShaderRead},
                                     TextureBarrier{m_B, Undefined, RandomWrite}));
    EXPECT_THAT(frame.passes[2].barriers,
                UnorderedElementsAre(TextureBarrier{m_A, ShaderRead, ColorAttachment},
                                     TextureBarrier{m_B, RandomWrite, ShaderRead}));
    EXPECT_EQ(frame.passes[2].colors[0].load, LoadOp::Load);
}

TEST_F(Dispatches, WaitForEachOtherWhereTheyWriteTheSame)
{
    m_Frame.Dispatch(1, {}, {m_A}).Dispatch(2, {}, {m_A});
    const CompiledFrame frame = Compile({m_A});
    ASSERT_EQ(frame.passes.size(), 2u);
    EXPECT_THAT(frame.passes[1].barriers,
                ElementsAre(TextureBarrier{m_A, RandomWrite, RandomWrite}));
    EXPECT_THAT(frame.finalBarriers, ElementsAre(TextureBarrier{m_A, RandomWrite, CopySource}));
}

TEST_F(Dispatches, AreOnePassWhereTheyDoNotMindEachOther)
{
    m_Frame.Bind(m_Temporary).Clear(ClearFlag::Color, Color::white);
    m_Frame.Dispatch(1, {m_Temporary}, {m_A}).Dispatch(2, {m_Temporary}, {m_B});
    m_Frame.Dispatch(3, {m_A}, {m_B});
    const CompiledFrame frame = Compile({m_A, m_B});
    EXPECT_EQ(Passes(frame), (std::vector<std::vector<std::string>>{
                                 {}, {"dispatch 1", "dispatch 2"}, {"dispatch 3"}}));
}

TEST_F(Dispatches, AreLeftOutWhereNothingReadsWhatTheyWrite)
{
    m_Frame.Begin("Unread").Dispatch(1, {}, {m_Temporary}).End().Dispatch(2, {}, {m_A});
    const CompiledFrame frame = Compile({m_A});
    EXPECT_EQ(Passes(frame), (std::vector<std::vector<std::string>>{{"dispatch 2"}}));
    ASSERT_EQ(frame.leftOut.size(), 1u);
    EXPECT_EQ(frame.leftOut[0].pass, "Unread");
    EXPECT_EQ(frame.leftOut[0].reason, "nothing reads 'T'");
    EXPECT_THAT(frame.leftOut[0].targets, ElementsAre("T"));
}

TEST_F(Dispatches, TakeWithThemWhatTheyAloneRead)
{
    const test::RenderTexturePtr other = test::Target("Other", 8, 4, true);
    m_Frame.Bind(other).Clear(ClearFlag::Color, Color::white).Draw(1);
    m_Frame.Dispatch(2, {other}, {m_Temporary});
    EXPECT_THAT(Compile().passes, IsEmpty());
}

TEST_F(Dispatches, MayReadWhatTheyWrite)
{
    m_Frame.Bind(m_Temporary).Clear(ClearFlag::Color, Color::white).Draw(1);
    m_Frame.Dispatch(2, {}, {m_Temporary}).Dispatch(3, {m_Temporary}, {m_A});
    EXPECT_EQ(Passes(Compile({m_A})),
              (std::vector<std::vector<std::string>>{{"draw 1"}, {"dispatch 2"}, {"dispatch 3"}}));
}

TEST_F(Dispatches, AreRunWhereTheyAreKept)
{
    m_Frame.Dispatch(1, {}, {m_Temporary}, {}, true);
    EXPECT_EQ(Compile().passes.size(), 1u);
}

TEST_F(Dispatches, AreRunWhereTheyWriteABuffer)
{
    m_Frame.Dispatch(1, {}, {}, {FrameBuilder::Write(m_Buffer)});
    m_Frame.Dispatch(2, {}, {m_Temporary}, {FrameBuilder::Read(m_Buffer)});
    EXPECT_EQ(Passes(Compile()), (std::vector<std::vector<std::string>>{{"dispatch 1"}}));
}

TEST_F(Dispatches, GetWhatWasClearedOnly)
{
    m_Frame.Bind(m_A).Clear(ClearFlag::Color, Color::white).Dispatch(1, {}, {m_A});
    const CompiledFrame frame = Compile({m_A});
    ASSERT_EQ(frame.passes.size(), 2u);
    EXPECT_EQ(frame.passes[0].name, "Clear A");
    EXPECT_EQ(frame.passes[0].colors[0].load, LoadOp::Clear);
    EXPECT_EQ(frame.passes[0].colors[0].store, StoreOp::Store);
}

TEST_F(Dispatches, LetDrawsGoOnAcrossThem)
{
    m_Frame.Bind(m_A).Draw(1).Dispatch(2, {}, {m_B}).Draw(3);
    EXPECT_EQ(Passes(Compile({m_A, m_B})),
              (std::vector<std::vector<std::string>>{{"draw 1", "draw 3"}, {"dispatch 2"}}));
}

TEST_F(Dispatches, KeepTheViewportOfTheDrawsAroundThem)
{
    m_Frame.Bind(m_A).Viewport(0, 0, 4, 2).Draw(1).Dispatch(2, {m_A}, {m_B}).Draw(3, {m_B});
    EXPECT_EQ(Passes(Compile({m_A})),
              (std::vector<std::vector<std::string>>{
                  {"viewport 0 0 4 2", "draw 1"}, {"dispatch 2"}, {"viewport 0 0 4 2", "draw 3"}}));
}

TEST_F(Dispatches, NeedNoTarget)
{
    m_Frame.Dispatch(1, {}, {m_A});
    EXPECT_EQ(Compile({m_A}, false).passes.size(), 1u);
}

TEST_F(Dispatches, AreRefusedWhereTheySampleWhatTheyWrite)
{
    m_Frame.Dispatch(1, {m_A}, {m_A});
    EXPECT_THAT(test::ThrownMessage<DrawError>([&] { Compile(); }),
                Mentions("dispatch", "samples 'A'", "write", "writable"));
}

TEST_F(Dispatches, AreABarrierApartOnOneBuffer)
{
    m_Frame.Dispatch(1, {}, {}, {FrameBuilder::Write(m_Buffer)});
    m_Frame.Dispatch(2, {}, {m_A}, {FrameBuilder::Read(m_Buffer)});
    m_Frame.Dispatch(3, {}, {m_B}, {FrameBuilder::Read(m_Buffer)});
    m_Frame.Dispatch(4, {}, {}, {FrameBuilder::Write(m_Buffer)});
    m_Frame.Dispatch(5, {}, {}, {FrameBuilder::Write(m_Buffer)});
    const CompiledFrame frame = Compile({m_A, m_B});
    ASSERT_EQ(Passes(frame),
              (std::vector<std::vector<std::string>>{
                  {"dispatch 1"}, {"dispatch 2", "dispatch 3"}, {"dispatch 4"}, {"dispatch 5"}}));
    const ShaderStage kernel = ShaderStage::Compute;
    EXPECT_THAT(frame.passes[0].bufferBarriers, IsEmpty());
    EXPECT_THAT(frame.passes[1].bufferBarriers,
                ElementsAre(BufferBarrier{m_Buffer, kernel, true, kernel, false}));
    EXPECT_THAT(frame.passes[2].bufferBarriers,
                ElementsAre(BufferBarrier{m_Buffer, kernel, true, kernel, true}));
    EXPECT_THAT(frame.passes[3].bufferBarriers,
                ElementsAre(BufferBarrier{m_Buffer, kernel, true, kernel, true}));
}

TEST_F(Dispatches, AreABarrierApartFromDrawsAndFramesOnOneBuffer)
{
    m_Frame.Dispatch(1, {}, {}, {FrameBuilder::Write(m_Buffer)});
    Compile();
    const auto read = FrameBuilder::Read(m_Buffer, ShaderStage::Fragment);
    m_Frame.Bind(m_A).Draw(2);
    auto bindings = std::make_shared<DrawBindings>();
    bindings->buffers = {read};
    m_Frame.last().bindings = bindings;
    m_Frame.Dispatch(3, {}, {}, {FrameBuilder::Write(m_Buffer)});
    const CompiledFrame frame = Compile({m_A});
    ASSERT_EQ(frame.passes.size(), 2u);
    EXPECT_THAT(frame.passes[0].bufferBarriers,
                ElementsAre(BufferBarrier{m_Buffer, ShaderStage::Compute, true,
                                          ShaderStage::Fragment, false}));
    EXPECT_THAT(frame.passes[1].bufferBarriers,
                ElementsAre(BufferBarrier{m_Buffer, ShaderStage::Compute | ShaderStage::Fragment,
                                          true, ShaderStage::Compute, true}));
}

TEST_F(Dispatches, OfASteadyFrameAreNotWorkedOutAgain)
{
    FrameCache cache;
    m_Frame.Bind(m_A).Draw(1).Dispatch(2, {m_A}, {m_B}, {FrameBuilder::Write(m_Buffer)});
    const FrameCommands recorded = m_Frame.Take();
    std::vector<std::uint64_t> structures;
    for (int i = 0; i < 4; ++i)
    {
        FrameCommands commands = recorded;
        const auto frame = cache.Compile(commands, m_States, {}, {});
        m_States = frame->states;
        structures.push_back(frame->structure);
    }
    EXPECT_EQ(structures[2], structures[3]);
    FrameCommands other = recorded;
    std::get<DispatchCommand>(other.commands.back()).groups[1] = 2;
    EXPECT_NE(cache.Compile(other, m_States, {}, {})->structure, structures[3]);
}

} // namespace
} // namespace limn

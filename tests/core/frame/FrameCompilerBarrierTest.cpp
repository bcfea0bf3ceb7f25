#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/FrameCompiler.h>

#include "frame/FrameBuilder.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

using test::FrameBuilder;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;
using Outputs = std::vector<test::RenderTexturePtr>;
using enum TextureUsage;

/// Which textures change their use before which pass.
class FrameCompilerBarriers : public testing::Test
{
protected:
    CompiledFrame Compile(FrameBuilder& builder, const Outputs& outputs = {})
    {
        return m_Compiler.Compile(builder.Take(), outputs);
    }

    test::FrameCompiler m_Compiler;
    FrameBuilder m_Frame;
    const test::RenderTexturePtr m_A = test::Target("A");
    const test::RenderTexturePtr m_B = test::Target("B");
    const test::RenderTexturePtr m_C = test::Target("C");
    const test::RenderTexturePtr m_Depth = test::DepthTarget("Depth");
};

TEST_F(FrameCompilerBarriers, MakeNewTexturesAttachments)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1);
    EXPECT_THAT(Compile(m_Frame).passes.at(0).barriers,
                UnorderedElementsAre(TextureBarrier{m_A, Undefined, ColorAttachment},
                                     TextureBarrier{m_Depth, Undefined, DepthStencilAttachment}));
}

//   pass A writes A ──▶ pass B samples A
TEST_F(FrameCompilerBarriers, StandBetweenWritingAndSampling)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1).Bind(m_B).Draw(2, {m_A, m_Depth});
    EXPECT_THAT(Compile(m_Frame).passes.at(1).barriers,
                UnorderedElementsAre(TextureBarrier{m_A, ColorAttachment, ShaderRead},
                                     TextureBarrier{m_Depth, DepthStencilAttachment, ShaderRead},
                                     TextureBarrier{m_B, Undefined, ColorAttachment}));
}

//   pass B samples A ──▶ pass A writes A
TEST_F(FrameCompilerBarriers, StandBetweenSamplingAndWriting)
{
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Draw(2, {m_A}).Bind(m_A).Draw(3);
    EXPECT_THAT(Compile(m_Frame).passes.at(2).barriers,
                ElementsAre(TextureBarrier{m_A, ShaderRead, ColorAttachment}));
}

TEST_F(FrameCompilerBarriers, StandBetweenWritingAndWritingAgain)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1).Bind(m_A).Draw(2);
    EXPECT_THAT(Compile(m_Frame).passes.at(1).barriers,
                ElementsAre(TextureBarrier{m_A, ColorAttachment, ColorAttachment}));
}

TEST_F(FrameCompilerBarriers, AreNotNeededBetweenSamplingAndSampling)
{
    const test::RenderTexturePtr mask = test::Target("Mask");
    m_Frame.Bind(mask).Draw(1).Bind(m_A).Draw(2, {mask}).Bind(m_B).Draw(3, {mask});
    EXPECT_THAT(Compile(m_Frame).passes.at(2).barriers,
                ElementsAre(TextureBarrier{m_B, Undefined, ColorAttachment}));
}

TEST_F(FrameCompilerBarriers, StandOnceForATextureThatManyDrawsSample)
{
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Draw(2, {m_A}).Draw(3, {m_A, m_A});
    EXPECT_THAT(Compile(m_Frame).passes.at(1).barriers,
                ElementsAre(TextureBarrier{m_A, ColorAttachment, ShaderRead},
                            TextureBarrier{m_B, Undefined, ColorAttachment}));
}

TEST_F(FrameCompilerBarriers, StandBeforeThePassEvenIfALateDrawSamples)
{
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Draw(2).Draw(3, {m_A});
    const CompiledFrame frame = Compile(m_Frame);
    ASSERT_EQ(frame.passes.size(), 2u);
    EXPECT_THAT(frame.passes[1].barriers,
                ElementsAre(TextureBarrier{m_A, ColorAttachment, ShaderRead},
                            TextureBarrier{m_B, Undefined, ColorAttachment}));
}

TEST_F(FrameCompilerBarriers, AreNotNeededForTexturesFromTheCpu)
{
    const auto image = std::make_shared<const Texture2D>("Image", 1, 1, GraphicsFormat::R8_UNorm,
                                                         std::vector<std::byte>(1));
    m_Frame.Bind(m_A).Draw(1, {image});
    EXPECT_THAT(Compile(m_Frame).passes.at(0).barriers,
                ElementsAre(TextureBarrier{m_A, Undefined, ColorAttachment}));
}

TEST_F(FrameCompilerBarriers, RememberTheUseInTheFrameBefore)
{
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Draw(2, {m_A});
    Compile(m_Frame);
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Draw(2, {m_A});
    const CompiledFrame frame = Compile(m_Frame);
    EXPECT_THAT(frame.passes.at(0).barriers,
                ElementsAre(TextureBarrier{m_A, ShaderRead, ColorAttachment}));
    EXPECT_THAT(frame.passes.at(1).barriers,
                ElementsAre(TextureBarrier{m_A, ColorAttachment, ShaderRead},
                            TextureBarrier{m_B, ColorAttachment, ColorAttachment}));
}

TEST_F(FrameCompilerBarriers, MakeOutputsReadableBehindTheLastPass)
{
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Draw(2, {m_A});
    EXPECT_THAT(Compile(m_Frame, {m_A, m_B}).finalBarriers,
                ElementsAre(TextureBarrier{m_A, ShaderRead, CopySource},
                            TextureBarrier{m_B, ColorAttachment, CopySource}));
}

TEST_F(FrameCompilerBarriers, LeadBackFromAnOutputToATarget)
{
    m_Frame.Bind(m_A).Draw(1);
    Compile(m_Frame, {m_A});
    m_Frame.Bind(m_A).Draw(1);
    const CompiledFrame frame = Compile(m_Frame, {m_A});
    EXPECT_THAT(frame.passes.at(0).barriers,
                ElementsAre(TextureBarrier{m_A, CopySource, ColorAttachment}));
    EXPECT_THAT(frame.finalBarriers, ElementsAre(TextureBarrier{m_A, ColorAttachment, CopySource}));
}

TEST_F(FrameCompilerBarriers, StandOnceForAnOutputThatIsNamedTwice)
{
    m_Frame.Bind(m_A).Draw(1);
    EXPECT_THAT(Compile(m_Frame, {m_A, m_A}).finalBarriers,
                ElementsAre(TextureBarrier{m_A, ColorAttachment, CopySource}));
}

TEST_F(FrameCompilerBarriers, AreNotNeededForAnOutputThatIsStillReadable)
{
    m_Frame.Bind(m_A).Draw(1);
    Compile(m_Frame, {m_A});
    EXPECT_THAT(Compile(m_Frame, {m_A}).finalBarriers, IsEmpty());
}

TEST_F(FrameCompilerBarriers, AreWorkedOutAfreshByEachCompiler)
{
    m_Frame.Bind(m_A).Draw(1);
    Compile(m_Frame);
    test::FrameCompiler other;
    m_Frame.Bind(m_A).Draw(1);
    EXPECT_THAT(other.Compile(m_Frame.Take()).passes.at(0).barriers,
                ElementsAre(TextureBarrier{m_A, Undefined, ColorAttachment}));
}

/// Reads one texture in these functions.
std::shared_ptr<const ShaderProgram> ReaderIn(ShaderStage stages)
{
    auto program = std::make_shared<ShaderProgram>();
    program->layout.textures.emplace_back().stages = stages;
    return program;
}

TEST_F(FrameCompilerBarriers, SayWhichFunctionsReadTheTextureInTheFrame)
{
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Draw(2, {m_A});
    m_Frame.last().program = ReaderIn(ShaderStage::Fragment);
    m_Frame.Bind(m_C).Draw(3, {m_A});
    m_Frame.last().program = ReaderIn(ShaderStage::Vertex);
    const CompiledFrame frame = Compile(m_Frame);
    EXPECT_THAT(
        frame.passes.at(1).barriers,
        testing::Contains(TextureBarrier{m_A, ColorAttachment, ShaderRead, ShaderStage::Both}));
    EXPECT_THAT(frame.passes.at(2).barriers,
                ElementsAre(TextureBarrier{m_C, Undefined, ColorAttachment}));
}

//   frame 1: A sampled by a fragment function ──▶ frame 2: by a vertex function
TEST_F(FrameCompilerBarriers, StandBeforeTheFunctionsThatReadATextureForTheFirstTime)
{
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Draw(2, {m_A});
    m_Frame.last().program = ReaderIn(ShaderStage::Fragment);
    Compile(m_Frame);
    const auto readIn = [&](ShaderStage stages)
    {
        m_Frame.Bind(m_B).Draw(3, {m_A});
        m_Frame.last().program = ReaderIn(stages);
        return Compile(m_Frame).passes.at(0).barriers;
    };
    const TextureBarrier again{m_B, ColorAttachment, ColorAttachment};
    EXPECT_THAT(readIn(ShaderStage::Fragment), ElementsAre(again));
    EXPECT_THAT(readIn(ShaderStage::Both),
                ElementsAre(TextureBarrier{m_A, ShaderRead, ShaderRead, ShaderStage::Both}, again));
    EXPECT_THAT(readIn(ShaderStage::Vertex), ElementsAre(again));
}

} // namespace
} // namespace limn

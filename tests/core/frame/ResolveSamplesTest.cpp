#include "frame/FrameBuilder.h"
#include "scene/TestScene.h"

#include <gmock/gmock.h>

#include "Mentions.h"

namespace limn
{
namespace
{

using test::FrameBuilder;
using test::FrameCompiler;
using test::Mentions;
using test::RenderTexturePtr;

RenderTexturePtr Smooth(const std::string& name, bool isTransient = true,
                        GraphicsFormat format = GraphicsFormat::R8_UNorm)
{
    RenderTextureDescriptor descriptor(8, 4, format);
    descriptor.msaaSamples = 4;
    return std::make_shared<RenderTexture>(name, descriptor, SamplerState{}, isTransient);
}

class ResolvedSamples : public testing::Test
{
protected:
    /// A node of one draw on samples that are there.
    FrameBuilder& DrawOn(const RenderTexturePtr& target, std::uint32_t number)
    {
        return m_Frame.Bind(target).Draw(number);
    }
    FrameBuilder& Begin(const RenderTexturePtr& target, std::uint32_t number)
    {
        return m_Frame.Bind(target).Clear(ClearFlag::Color, Color::red).Draw(number);
    }
    FrameBuilder& Read(const RenderTexturePtr& texture, std::uint32_t number)
    {
        return m_Frame.Bind(m_Other).Clear(ClearFlag::Color).Draw(number, {texture});
    }

    const RenderTexturePtr m_Smooth = Smooth("smooth");
    const RenderTexturePtr m_Other = test::Target("other", 8, 4);
    FrameBuilder m_Frame;
    FrameCompiler m_Compiler{true};
};

TEST_F(ResolvedSamples, AreResolvedWhereADrawReadsThemAndNotKept)
{
    Begin(m_Smooth, 1);
    Read(m_Smooth, 2);
    const CompiledFrame frame = m_Compiler.Compile(m_Frame.Take(), {m_Other});
    ASSERT_EQ(frame.passes.size(), 2u);
    const auto& color = frame.passes[0].colors[0];
    EXPECT_EQ(color.resolve, m_Smooth);
    EXPECT_EQ(color.store, StoreOp::DontCare) << "nothing draws on them";
    EXPECT_EQ(frame.passes[1].colors[0].resolve, nullptr) << "one sample a texel";
}

TEST_F(ResolvedSamples, AreKeptAndNotResolvedWhereTheyAreOnlyDrawnOn)
{
    const RenderTexturePtr depth = Smooth("depth", true, GraphicsFormat::D32_SFloat);
    m_Frame.Bind(m_Smooth, depth).Clear(ClearFlag::All, Color::red).Draw(1);
    const RenderTexturePtr between = Smooth("between");
    m_Frame.Bind(between, depth).Clear(ClearFlag::Color).Draw(2); // cannot go before
    m_Frame.Bind(m_Smooth).Draw(3, {between});
    const CompiledFrame frame = m_Compiler.Compile(m_Frame.Take(), {m_Smooth});
    ASSERT_EQ(frame.passes.size(), 3u);
    EXPECT_EQ(frame.passes[0].colors[0].resolve, nullptr);
    EXPECT_EQ(frame.passes[0].colors[0].store, StoreOp::Store);
    EXPECT_EQ(frame.passes[2].colors[0].load, LoadOp::Load);
    EXPECT_EQ(frame.passes[2].colors[0].resolve, m_Smooth) << "an output";
    EXPECT_EQ(frame.passes[2].colors[0].store, StoreOp::DontCare);
}

TEST_F(ResolvedSamples, AreDrawnByAllNodesWhereTheyAreCopied)
{
    Begin(m_Smooth, 1);
    const RenderTexturePtr between = test::Target("between", 8, 4);
    m_Frame.Bind(between).Draw(2);
    DrawOn(m_Smooth, 3);
    const RenderTexturePtr copy = test::Target("copy", 8, 4, false, GraphicsFormat::R8_UNorm);
    m_Frame.Bind(copy).Blit(4, {m_Smooth}, "copy");
    const CompiledFrame frame = m_Compiler.Compile(m_Frame.Take(), {copy, between});
    std::vector<std::string> drawn;
    for (const CompiledRenderPass& pass : frame.passes)
    {
        std::ranges::copy(test::CommandsOf(pass), std::back_inserter(drawn));
    }
    EXPECT_THAT(drawn, testing::UnorderedElementsAre("draw 1", "draw 2", "draw 3"));
}

TEST_F(ResolvedSamples, AreKeptAndResolvedWhereTheyAreReadAndThenDrawnOn)
{
    Begin(m_Smooth, 1);
    Read(m_Smooth, 2);
    DrawOn(m_Smooth, 3);
    const CompiledFrame frame = m_Compiler.Compile(m_Frame.Take(), {m_Smooth, m_Other});
    ASSERT_EQ(frame.passes.size(), 3u);
    EXPECT_EQ(frame.passes[0].colors[0].resolve, m_Smooth);
    EXPECT_EQ(frame.passes[0].colors[0].store, StoreOp::Store);
    EXPECT_EQ(frame.passes[2].colors[0].load, LoadOp::Load);
}

TEST_F(ResolvedSamples, AreKeptAndResolvedForAFrameThatMayReadOrDrawOn)
{
    const RenderTexturePtr kept = Smooth("kept", false);
    Begin(kept, 1);
    const CompiledFrame frame = m_Compiler.Compile(m_Frame.Take());
    ASSERT_EQ(frame.passes.size(), 1u);
    EXPECT_EQ(frame.passes[0].colors[0].resolve, kept);
    EXPECT_EQ(frame.passes[0].colors[0].store, StoreOp::Store);
}

TEST_F(ResolvedSamples, AreKeptWhereANextFrameMayReadThem)
{
    for (const bool isTransient : {false, true})
    {
        const RenderTexturePtr kept = Smooth("kept", isTransient);
        Begin(kept, 1);
        Read(kept, 2);
        Begin(kept, 3); // what the next frame overwrites
        m_Frame.Bind(m_Other).Draw(4, {kept});
        const CompiledFrame frame = m_Compiler.Compile(m_Frame.Take(), {m_Other});
        ASSERT_EQ(frame.passes.size(), 4u);
        EXPECT_EQ(frame.passes[0].colors[0].store, StoreOp::DontCare);
        EXPECT_EQ(frame.passes[0].colors[0].resolve, kept);
        EXPECT_EQ(frame.passes[2].colors[0].store,
                  isTransient ? StoreOp::DontCare : StoreOp::Store);
        EXPECT_EQ(frame.passes[2].colors[0].resolve, kept);
    }
}

TEST_F(ResolvedSamples, OfDepthAreResolvedWhereSomethingReadsDepth)
{
    const RenderTexturePtr depth = Smooth("depth", true, GraphicsFormat::D32_SFloat);
    for (const bool reads : {false, true})
    {
        m_Frame.Bind(m_Smooth, depth).Clear(ClearFlag::All).Draw(1);
        m_Frame.Bind(m_Other).Clear(ClearFlag::Color).Draw(2, {m_Smooth, reads ? depth : m_Smooth});
        const CompiledFrame frame = m_Compiler.Compile(m_Frame.Take(), {m_Other});
        ASSERT_EQ(frame.passes.size(), 2u);
        EXPECT_EQ(frame.passes[0].depth->resolve, reads ? depth : nullptr);
        EXPECT_EQ(frame.passes[0].depth->store, StoreOp::DontCare);
    }
}

TEST_F(ResolvedSamples, GoStraightIntoTheCopyThatAloneReadsThem)
{
    const RenderTexturePtr output = test::Target("output", 8, 4, false, m_Smooth->graphicsFormat());
    Begin(m_Smooth, 1);
    m_Frame.Blit(2, {m_Other}, "", FrameBuilder::Additive());
    m_Frame.Bind(output).Blit(3, {m_Smooth}, "copy");
    const CompiledFrame frame = m_Compiler.Compile(m_Frame.Take(), {output});
    ASSERT_EQ(frame.passes.size(), 1u);
    const auto& color = frame.passes[0].colors[0];
    EXPECT_EQ(color.texture, m_Smooth);
    EXPECT_EQ(color.resolve, output);
    EXPECT_EQ(color.store, StoreOp::DontCare);
    EXPECT_EQ(color.clearColor.a, 1.0f) << "as the copy's";
    EXPECT_THAT(frame.passes[0].barriers,
                testing::Contains(TextureBarrier{output, TextureUsage::Undefined,
                                                 TextureUsage::ColorAttachment}));
    ASSERT_EQ(frame.leftOut.size(), 1u);
    EXPECT_THAT(frame.leftOut[0].reason,
                Mentions("'output'", "resolved", "directly", "'smooth'", "blends"));
}

TEST_F(ResolvedSamples, AreCopiedIntoAnotherFormat)
{
    const RenderTexturePtr output = test::Target("output", 8, 4);
    Begin(m_Smooth, 1);
    m_Frame.Bind(output).Blit(2, {m_Smooth}, "copy");
    EXPECT_EQ(m_Compiler.Compile(m_Frame.Take(), {output}).passes.size(), 2u)
        << "a resolve cannot convert";
}

} // namespace
} // namespace limn

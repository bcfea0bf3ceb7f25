#include "frame/FrameBuilder.h"
#include "scene/TestScene.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using test::FrameBuilder;
using test::RenderTexturePtr;
using testing::ElementsAre;
using testing::IsEmpty;

/// What a frame leaves in a texture that no frame before has used.
class ATextureOfNoHistory : public testing::Test
{
protected:
    /// The draws that are run, by number, pass after pass.
    std::vector<std::uint32_t> Compile(const std::vector<RenderTexturePtr>& outputs)
    {
        m_Last = m_Compiler.Compile(m_Frame.Take(), outputs);
        std::vector<std::uint32_t> draws;
        for (const CompiledRenderPass& pass : m_Last.passes)
        {
            for (const PassCommand& command : pass.commands)
            {
                if (const auto* draw = std::get_if<DrawCommand>(&command))
                {
                    draws.push_back(draw->firstInstance);
                }
            }
        }
        return draws;
    }

    /// A full-screen pass that is 0 0 0 1 all over, because of a number.
    FrameBuilder& BlitNothing(std::uint32_t number, const RenderTexturePtr& from,
                              const RenderTargetBlendState& blend = {})
    {
        m_Frame.Blit(number, {from}, "True", blend);
        FullScreenPromise promise = *m_Frame.last().fullScreen;
        promise.zeroProperty = ShaderPropertyId("_Zero");
        promise.output = {0, 0, 0, 1};
        m_Frame.last().fullScreen = std::make_shared<FullScreenPromise>(promise);
        return m_Frame;
    }

    /// Mask, edges and camera, as an outline's passes.
    void RecordOutline(bool hasWidth, bool hasColor)
    {
        m_Frame.Bind(m_Mask).Clear(ClearFlag::Color).Draw(1).Bind(m_Edges);
        hasWidth ? m_Frame.Blit(2, {m_Mask}, "True") : BlitNothing(2, m_Mask);
        m_Frame.Bind(m_Camera).Clear(ClearFlag::Color).Draw(3);
        if (hasColor)
        {
            m_Frame.Blit(4, {m_Edges}, "0 0 0 1 where", FrameBuilder::Additive());
        }
        else
        {
            BlitNothing(4, m_Edges, FrameBuilder::Additive());
        }
    }

    test::FrameCompiler m_Compiler{true};
    FrameBuilder m_Frame;
    CompiledFrame m_Last;
    const RenderTexturePtr m_Camera = test::Target("Camera");
    const RenderTexturePtr m_Mask = test::Target("Mask", 8, 4, true, GraphicsFormat::R8_UNorm);
    const RenderTexturePtr m_Edges = test::Target("Edges", 8, 4, true, GraphicsFormat::R8_UNorm);
};

//   mask ─▶ edges ─▶ camera: whatever makes the last step nothing takes the others with it
TEST_F(ATextureOfNoHistory, IsNotDrawnWhereAllThatReadItIsLeftOut)
{
    RecordOutline(false, true);
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(3u)) << "no width";
    RecordOutline(true, false);
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(3u)) << "no colour";
    RecordOutline(true, true);
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(1u, 2u, 3u, 4u));
    EXPECT_THAT(m_Last.notes, IsEmpty());
}

TEST_F(ATextureOfNoHistory, IsNotDrawnWhereNoColourOfAFirstFrameIsSeen)
{
    RecordOutline(true, false);
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(3u));
}

//   frame 1: scene ─▶ history ─▶ camera                 frame 2: history ─▶ camera
TEST_F(ATextureOfNoHistory, IsKeptForTheNextFrameWhereItIsShown)
{
    const RenderTexturePtr history = test::Target("History");
    m_Frame.Bind(history).Clear(ClearFlag::Color).Draw(1).Bind(m_Camera).Draw(2, {history});
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(1u, 2u));
    EXPECT_EQ(m_Last.passes.at(0).colors.at(0).store, StoreOp::Store);
    m_Frame.Bind(m_Camera).Draw(3, {history});
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(3u));
    EXPECT_THAT(m_Last.notes, IsEmpty());
}

//   frame 1: scene ─▶ history, scene ─▶ camera          frame 2: history ─▶ camera
TEST_F(ATextureOfNoHistory, IsKeptForTheNextFrameWhereNothingReadsItYet)
{
    const RenderTexturePtr history = test::Target("History");
    m_Frame.Bind(history).Clear(ClearFlag::Color).Draw(1).Bind(m_Camera).Draw(2);
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(1u, 2u));
    EXPECT_EQ(m_Last.passes.at(0).colors.at(0).store, StoreOp::Store);
    m_Frame.Bind(m_Camera).Draw(3, {history});
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(3u));
    EXPECT_THAT(m_Last.notes, IsEmpty());
}

//   frame 1: history ─▶ camera ─▶ history, where the last is for the next frame alone
TEST_F(ATextureOfNoHistory, IsKeptAsItIsWrittenLast)
{
    const RenderTexturePtr history = test::Target("History");
    m_Frame.Bind(history).Clear(ClearFlag::Color).Draw(1).Bind(m_Camera);
    BlitNothing(2, history).Bind(history).Blit(3, {m_Camera}, "True");
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(3u)) << "draw 1 is not seen, draw 3 may be";
    EXPECT_EQ(m_Last.passes.back().colors.at(0).store, StoreOp::Store);
}

TEST_F(ATextureOfNoHistory, IsKeptWhereItIsAnOutput)
{
    RecordOutline(true, false);
    EXPECT_THAT(Compile({m_Camera, m_Mask}), ElementsAre(1u, 3u));
}

//   frames 1...n: scene ─▶ history, never read          then, as a feature is switched on, it is
TEST_F(ATextureOfNoHistory, IsDrawnAndKeptHoweverOftenItWasDrawnOverUnread)
{
    const RenderTexturePtr history = test::Target("History");
    for (int i = 0; i < 4; ++i)
    {
        m_Frame.Bind(history).Clear(ClearFlag::Color).Draw(1).Bind(m_Camera).Draw(2);
        EXPECT_THAT(Compile({m_Camera}), ElementsAre(1u, 2u)) << "frame " << i;
        EXPECT_EQ(m_Last.passes.at(0).colors.at(0).store, StoreOp::Store);
    }
    m_Frame.Bind(m_Camera).Draw(3, {history});
    EXPECT_THAT(Compile({m_Camera}), ElementsAre(3u));
    EXPECT_THAT(m_Last.notes, IsEmpty());
}

//   frame 1: scene ─▶ history     last frame: scene ─▶ mask ─▶ history, blended ─▶ camera
TEST_F(ATextureOfNoHistory, IsReadInTheLastFrameThoughThatKeepsNothing)
{
    const RenderTexturePtr history = test::Target("History");
    m_Frame.Bind(history).Clear(ClearFlag::Color).Draw(1);
    const CompiledFrame frame = CompileFrame(m_Frame.Take(), {}, std::vector{m_Camera}, {});
    m_Frame.Bind(m_Mask).Clear(ClearFlag::Color).Draw(2).Bind(m_Edges).Draw(3, {m_Mask});
    m_Frame.Bind(history).Blit(4, {m_Edges}, "True", FrameBuilder::Additive());
    m_Frame.Bind(m_Camera).Draw(5, {history});
    FrameCompilerOptions options;
    options.isLast = true;
    options.footprint = [](const RenderTexture&)
    {
        return TextureFootprint{64, 64, 0};
    };
    const CompiledFrame last =
        CompileFrame(m_Frame.Take(), frame.states, std::vector{m_Camera}, options);
    ASSERT_EQ(last.passes.size(), 4u);
    EXPECT_EQ(last.passes.at(2).colors.at(0).load, LoadOp::Load);
    EXPECT_EQ(last.passes.at(2).colors.at(0).store, StoreOp::Store);
    for (const PlacedTexture& placed : last.placed)
    {
        EXPECT_NE(placed.texture, history);
    }
}

/// What somebody has of a pool for longer than a frame.
TEST_F(ATextureOfNoHistory, IsKeptThoughTransientWhereItIsHeld)
{
    m_Frame.Bind(m_Mask).Clear(ClearFlag::Color).Draw(1).Bind(m_Camera).Draw(2);
    FrameCompilerOptions options;
    options.held = {m_Mask->id()};
    const CompiledFrame frame = CompileFrame(m_Frame.Take(), {}, std::vector{m_Camera}, options);
    ASSERT_EQ(frame.passes.size(), 2u);
    EXPECT_EQ(frame.passes.at(0).colors.at(0).store, StoreOp::Store);
    m_Frame.Bind(m_Camera).Draw(3, {m_Mask});
    const CompiledFrame next =
        CompileFrame(m_Frame.Take(), frame.states, std::vector{m_Camera}, options);
    EXPECT_EQ(next.passes.size(), 1u);
    EXPECT_TRUE(next.leftOut.empty());
}

} // namespace
} // namespace limn

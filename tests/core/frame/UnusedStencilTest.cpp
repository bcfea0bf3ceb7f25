#include <gtest/gtest.h>
#include <limn/core/FrameCompiler.h>

#include "frame/FrameBuilder.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

/// Whether depth is drawn into a texture with a stencil.
class UnusedStencil : public testing::Test
{
protected:
    static FrameCommands Drawing(test::FrameBuilder& builder, bool usesStencil)
    {
        FrameCommands frame = builder.Take();
        for (DrawSetup& setup : frame.setups)
        {
            setup.state.stencilEnabled = usesStencil;
        }
        return frame;
    }

    GraphicsFormat DepthFormat(const CompiledFrame& frame) const
    {
        return frame.passes.at(0).depth->texture->graphicsFormat();
    }

    test::FrameCompiler m_Compiler;
    test::FrameBuilder m_Frame;
    const test::RenderTexturePtr m_Color = test::Target("Color");
    const test::RenderTexturePtr m_Transient = test::DepthTarget("Depth", 8, 4, true);
    const test::RenderTexturePtr m_Kept = test::DepthTarget("Depth");
};

TEST_F(UnusedStencil, IsLeftOutOfTransientDepth)
{
    m_Frame.Bind(m_Color, m_Transient).Clear(ClearFlag::All, Color::clear, 1.0f, 5).Draw(1);
    const CompiledFrame frame = m_Compiler.Compile(Drawing(m_Frame, false));
    EXPECT_EQ(DepthFormat(frame), GraphicsFormat::D32_SFloat);
    EXPECT_EQ(frame.passes[0].depth->texture->name(), "Depth");
    EXPECT_EQ(frame.passes[0].depth->load, LoadOp::Clear);
    EXPECT_NE(frame.passes[0].depth->stencilLoad, LoadOp::Clear);
}

TEST_F(UnusedStencil, IsThereWhereADrawUsesIt)
{
    m_Frame.Bind(m_Color, m_Transient).Clear(ClearFlag::All).Draw(1);
    const CompiledFrame frame = m_Compiler.Compile(Drawing(m_Frame, true));
    EXPECT_EQ(frame.passes[0].depth->texture, m_Transient);
    EXPECT_EQ(frame.passes[0].depth->stencilLoad, LoadOp::Clear);
}

TEST_F(UnusedStencil, IsTheSameTextureInEveryFrame)
{
    m_Frame.Bind(m_Color, m_Transient).Draw(1);
    const auto first = m_Compiler.Compile(Drawing(m_Frame, false)).passes.at(0).depth->texture;
    m_Frame.Bind(m_Color, m_Transient).Draw(1);
    const auto second = m_Compiler.Compile(Drawing(m_Frame, false)).passes.at(0).depth->texture;
    EXPECT_EQ(first, second);
    m_Frame.Bind(m_Color, m_Transient).Draw(1);
    EXPECT_EQ(m_Compiler.Compile(Drawing(m_Frame, true)).passes.at(0).depth->texture, m_Transient);
}

TEST_F(UnusedStencil, IsLeftOutOfDepthThatDrawsSample)
{
    const test::RenderTexturePtr other = test::Target("Other");
    m_Frame.Bind(m_Color, m_Transient).Draw(1).Bind(other).Draw(2, {m_Color, m_Transient});
    const CompiledFrame frame = m_Compiler.Compile(Drawing(m_Frame, false));
    EXPECT_EQ(DepthFormat(frame), GraphicsFormat::D32_SFloat);
    const auto& draw = std::get<DrawCommand>(frame.passes.at(1).commands.at(0));
    const auto& textures = frame.Setup(draw).bindings->textures;
    EXPECT_EQ(textures.at(0).texture, m_Color);
    EXPECT_EQ(textures.at(1).texture, frame.passes[0].depth->texture);
    EXPECT_EQ(frame.passes[0].depth->store, StoreOp::Store);
}

TEST_F(UnusedStencil, StaysInDepthThatIsKeptGivenOutOrReadByAKernel)
{
    m_Frame.Bind(m_Color, m_Kept).Draw(1);
    EXPECT_EQ(DepthFormat(m_Compiler.Compile(Drawing(m_Frame, false))),
              GraphicsFormat::D32_SFloat_S8_UInt);
    m_Frame.Bind(m_Color, m_Transient).Draw(1).Dispatch(2, {m_Transient}, {m_Color});
    EXPECT_EQ(DepthFormat(m_Compiler.Compile(Drawing(m_Frame, false))),
              GraphicsFormat::D32_SFloat_S8_UInt);
    m_Frame.Bind(m_Color, m_Transient).Draw(1);
    const std::vector<test::RenderTexturePtr> outputs{m_Transient};
    EXPECT_EQ(DepthFormat(m_Compiler.Compile(Drawing(m_Frame, false), outputs)),
              GraphicsFormat::D32_SFloat_S8_UInt);
}

TEST_F(UnusedStencil, LeavesNoClearOfItBehind)
{
    m_Frame.Bind(m_Color, m_Transient).Draw(1).Clear(ClearFlag::Stencil).Draw(2);
    m_Frame.Clear(ClearFlag::DepthStencil).Draw(3);
    const CompiledFrame frame = m_Compiler.Compile(Drawing(m_Frame, false));
    EXPECT_EQ(test::CommandsOf(frame.passes.at(0)),
              (std::vector<std::string>{"draw 1", "draw 2", "clear 2", "draw 3"}));
}

} // namespace
} // namespace limn

#include <gtest/gtest.h>
#include <limn/core/FrameCompiler.h>

#include "frame/FrameBuilder.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

using test::FrameBuilder;
using Outputs = std::vector<test::RenderTexturePtr>;

/// What becomes of the contents of targets at the borders of passes.
class FrameCompilerLoadStore : public testing::Test
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
    const test::RenderTexturePtr m_Depth = test::DepthTarget("Depth");
    const test::RenderTexturePtr m_Transient = test::Target("Transient", 8, 4, true);
    const test::RenderTexturePtr m_TransientDepth = test::DepthTarget("TransientDepth", 8, 4, true);
};

TEST_F(FrameCompilerLoadStore, DoesNotLoadWhatWasNeverWritten)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_EQ(pass.colors[0].load, LoadOp::DontCare);
    EXPECT_EQ(pass.depth->load, LoadOp::DontCare);
    EXPECT_EQ(pass.depth->stencilLoad, LoadOp::DontCare);
}

TEST_F(FrameCompilerLoadStore, TurnsAClearAtTheBeginningIntoTheLoad)
{
    m_Frame.Bind(m_A, m_Depth)
        .Clear(ClearFlag::All, Color{0.1f, 0.2f, 0.3f, 0.4f}, 0.5f, 7)
        .Draw(1);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_EQ(pass.colors[0].load, LoadOp::Clear);
    EXPECT_EQ(pass.colors[0].clearColor, (Color{0.1f, 0.2f, 0.3f, 0.4f}));
    EXPECT_EQ(pass.depth->load, LoadOp::Clear);
    EXPECT_EQ(pass.depth->stencilLoad, LoadOp::Clear);
    EXPECT_EQ(pass.depth->clearDepth, 0.5f);
    EXPECT_EQ(pass.depth->clearStencil, 7);
    EXPECT_EQ(pass.commands.size(), 1u);
}

TEST_F(FrameCompilerLoadStore, ClearsOnlyTheAspectsThatTheFlagsName)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1).Bind(m_B).Draw(2);
    m_Frame.Bind(m_A, m_Depth).Clear(ClearFlag::Stencil).Draw(3);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(2);
    EXPECT_EQ(pass.colors[0].load, LoadOp::Load);
    EXPECT_EQ(pass.depth->load, LoadOp::Load);
    EXPECT_EQ(pass.depth->stencilLoad, LoadOp::Clear);
}

TEST_F(FrameCompilerLoadStore, AddsClearsBeforeTheFirstDrawUp)
{
    m_Frame.Bind(m_A, m_Depth).Clear(ClearFlag::All, Color::red, 1.0f, 1);
    m_Frame.Clear(ClearFlag::Color, Color::green).Clear(ClearFlag::Stencil, Color::red, 0.5f, 9);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_EQ(pass.colors[0].clearColor, Color::green);
    EXPECT_EQ(pass.depth->clearDepth, 1.0f);
    EXPECT_EQ(pass.depth->clearStencil, 9);
    EXPECT_EQ(pass.depth->load, LoadOp::Clear);
}

TEST_F(FrameCompilerLoadStore, LoadsWhatAnEarlierPassWrote)
{
    m_Frame.Bind(m_A).Draw(1).Bind(m_B).Draw(2).Bind(m_A).Draw(3);
    EXPECT_EQ(Compile(m_Frame).passes.at(2).colors[0].load, LoadOp::Load);
}

TEST_F(FrameCompilerLoadStore, LoadsWhatAnEarlierFrameWrote)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1);
    Compile(m_Frame);
    m_Frame.Bind(m_A, m_Depth).Draw(1);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_EQ(pass.colors[0].load, LoadOp::Load);
    EXPECT_EQ(pass.depth->load, LoadOp::Load);
}

TEST_F(FrameCompilerLoadStore, ForgetsATransientTextureWithItsFrame)
{
    m_Frame.Bind(m_Transient, m_TransientDepth).Draw(1);
    Compile(m_Frame);
    m_Frame.Bind(m_Transient, m_TransientDepth).Draw(1);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_EQ(pass.colors[0].load, LoadOp::DontCare);
    EXPECT_EQ(pass.depth->load, LoadOp::DontCare);
}

TEST_F(FrameCompilerLoadStore, StoresWhatOutlivesTheFrame)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_EQ(pass.colors[0].store, StoreOp::Store);
    EXPECT_EQ(pass.depth->store, StoreOp::Store);
    EXPECT_EQ(pass.depth->stencilStore, StoreOp::Store);
}

TEST_F(FrameCompilerLoadStore, DoesNotStoreATransientTextureThatNobodyReads)
{
    m_Frame.Bind(m_Transient, m_TransientDepth).Draw(1);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_EQ(pass.colors[0].store, StoreOp::DontCare);
    EXPECT_EQ(pass.depth->store, StoreOp::DontCare);
    EXPECT_EQ(pass.depth->stencilStore, StoreOp::DontCare);
}

//   pass T ── stored ──▶ sampled by pass A
TEST_F(FrameCompilerLoadStore, StoresATransientTextureThatALaterPassSamples)
{
    m_Frame.Bind(m_Transient, m_TransientDepth).Draw(1).Bind(m_A).Draw(2, {m_Transient});
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_EQ(pass.colors[0].store, StoreOp::Store);
    EXPECT_EQ(pass.depth->store, StoreOp::DontCare);
}

TEST_F(FrameCompilerLoadStore, StoresATransientTextureThatALaterPassDrawsOver)
{
    m_Frame.Bind(m_Transient).Draw(1).Bind(m_A).Draw(2).Bind(m_Transient).Draw(3);
    m_Frame.Bind(m_A).Draw(4, {m_Transient}).Bind(m_Transient).Draw(5);
    const CompiledFrame frame = Compile(m_Frame);
    EXPECT_EQ(frame.passes.at(0).colors[0].store, StoreOp::Store);
    EXPECT_EQ(frame.passes.at(2).colors[0].load, LoadOp::Load);
    EXPECT_EQ(frame.passes.at(2).colors[0].store, StoreOp::Store);
    EXPECT_EQ(frame.passes.at(4).colors[0].store, StoreOp::DontCare);
}

TEST_F(FrameCompilerLoadStore, NeitherLoadsNorStoresWhatNobodyReads)
{
    m_Frame.Bind(m_Transient).Draw(1).Bind(m_A).Draw(2).Bind(m_Transient).Draw(3);
    const CompiledFrame frame = Compile(m_Frame);
    EXPECT_EQ(frame.passes.at(0).colors[0].store, StoreOp::DontCare);
    EXPECT_EQ(frame.passes.at(2).colors[0].load, LoadOp::DontCare);
    EXPECT_EQ(frame.passes.at(2).colors[0].store, StoreOp::DontCare);
}

TEST_F(FrameCompilerLoadStore, StoresATransientTextureThatIsAnOutput)
{
    m_Frame.Bind(m_Transient).Draw(1);
    EXPECT_EQ(Compile(m_Frame, {m_Transient}).passes.at(0).colors[0].store, StoreOp::Store);
}

TEST_F(FrameCompilerLoadStore, DoesNotStoreWhatALaterPassClears)
{
    m_Frame.Bind(m_A, m_Depth).Draw(1).Bind(m_B).Draw(2);
    m_Frame.Bind(m_A, m_Depth).Clear(ClearFlag::Color | ClearFlag::Depth).Draw(3);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_EQ(pass.colors[0].store, StoreOp::DontCare);
    EXPECT_EQ(pass.depth->store, StoreOp::DontCare);
    EXPECT_EQ(pass.depth->stencilStore, StoreOp::Store);
}

TEST_F(FrameCompilerLoadStore, StoresWhatIsSampledBeforeItIsCleared)
{
    m_Frame.Bind(m_Transient).Draw(1).Bind(m_B).Draw(2, {m_Transient});
    m_Frame.Bind(m_Transient).Clear(ClearFlag::Color).Draw(3);
    const CompiledFrame frame = Compile(m_Frame);
    EXPECT_EQ(frame.passes.at(0).colors[0].store, StoreOp::Store);
    EXPECT_EQ(frame.passes.at(2).colors[0].store, StoreOp::DontCare);
}

TEST_F(FrameCompilerLoadStore, StoresWhatALaterPassClearsOnlyInAViewport)
{
    m_Frame.Bind(m_Transient).Draw(1).Bind(m_B).Draw(2);
    m_Frame.Bind(m_Transient).Viewport(0, 0, 1, 1).Clear(ClearFlag::Color);
    m_Frame.Bind(m_B).Draw(3, {m_Transient});
    const CompiledFrame frame = Compile(m_Frame);
    EXPECT_EQ(frame.passes.at(0).colors[0].store, StoreOp::Store);
    EXPECT_EQ(frame.passes.at(2).colors[0].load, LoadOp::Load);
}

TEST_F(FrameCompilerLoadStore, DoesNotLoadATextureThatReplacesADestroyedOne)
{
    test::RenderTexturePtr texture = test::Target("Mask");
    m_Frame.Bind(texture).Draw(1);
    Compile(m_Frame);
    texture = test::Target("Mask");
    m_Frame.Bind(texture).Draw(1);
    const CompiledRenderPass pass = Compile(m_Frame).passes.at(0);
    EXPECT_EQ(pass.colors[0].load, LoadOp::DontCare);
    ASSERT_EQ(pass.barriers.size(), 1u);
    EXPECT_EQ(pass.barriers[0].before, TextureUsage::Undefined);
}

TEST_F(FrameCompilerLoadStore, DoesNotKeepATextureAlive)
{
    std::weak_ptr<const RenderTexture> watched;
    {
        const test::RenderTexturePtr texture = test::Target("Mask");
        watched = texture;
        m_Frame.Bind(texture).Draw(1);
        Compile(m_Frame);
        m_Frame = FrameBuilder();
    }
    EXPECT_TRUE(watched.expired());
}

TEST_F(FrameCompilerLoadStore, MakesMipLevelsWhereTheyAreStored)
{
    RenderTextureDescriptor descriptor(8, 4, GraphicsFormat::R8G8B8A8_UNorm);
    descriptor.useMipMap = true;
    const auto mipped = [&](bool automatic, bool isTransient)
    {
        descriptor.autoGenerateMips = automatic;
        return std::make_shared<const RenderTexture>("Mips", descriptor, SamplerState(),
                                                     isTransient);
    };
    const auto automatic = mipped(true, true);
    m_Frame.Bind(automatic).Draw(1).Bind(m_A).Draw(2, {automatic}).Bind(automatic).Draw(3);
    m_Frame.Bind(m_B).Draw(4, {m_A});
    auto passes = Compile(m_Frame, {m_B}).passes;
    EXPECT_TRUE(passes.at(0).colors[0].generatesMips);
    EXPECT_FALSE(passes.at(1).colors[0].generatesMips) << "of one level";
    for (std::size_t i = 2; i < passes.size(); ++i)
    {
        EXPECT_FALSE(passes[i].colors[0].generatesMips) << "nothing reads them";
    }
    const auto byHand = mipped(false, false);
    m_Frame.Bind(byHand).Draw(1);
    EXPECT_FALSE(Compile(m_Frame).passes.at(0).colors[0].generatesMips);
}

// Drawn into twice with another target in between, so that the passes might become one.
TEST_F(FrameCompilerLoadStore, MakesMipLevelsThatOnlyTheLaterDrawsAskFor)
{
    RenderTextureDescriptor descriptor(8, 4, GraphicsFormat::R8G8B8A8_UNorm);
    descriptor.useMipMap = true;
    descriptor.autoGenerateMips = false;
    const auto mipped = std::make_shared<const RenderTexture>("Mips", descriptor);
    m_Frame.Bind(mipped).Draw(1).Bind(m_A).Draw(2).BindForMips(mipped).Draw(3);
    m_Frame.Bind(m_B).Draw(4, {mipped, m_A});
    const auto passes = Compile(m_Frame, {m_B}).passes;
    int count = 0;
    for (const auto& pass : passes)
    {
        for (const auto& color : pass.colors)
        {
            count += color.generatesMips ? 1 : 0;
        }
    }
    EXPECT_EQ(count, 1);
}

} // namespace
} // namespace limn

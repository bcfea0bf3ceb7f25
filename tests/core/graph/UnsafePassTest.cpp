#include "graph/GraphHarness.h"

#include <gtest/gtest.h>

#include "ThrownMessage.h"

namespace limn::test
{
namespace
{

TEST(UnsafePass, DrawsIntoWhatItDeclares)
{
    GraphPass pass(
        [](RenderGraph& graph, ContextContainer&)
        {
            TextureHandle mask;
            graph.CreateTextureIfInvalid(Desc("_Mask"), mask);
            const TextureHandle made = mask;
            graph.CreateTextureIfInvalid(Desc("_Other"), mask);
            EXPECT_EQ(mask, made) << "there is one";
            const RenderTargetInfo info = graph.GetRenderTargetInfo(mask);
            EXPECT_EQ(info.width, 8);
            EXPECT_EQ(info.height, 4);
            EXPECT_EQ(info.msaaSamples, 1);
            EXPECT_EQ(info.format, GraphicsFormat::R8G8B8A8_UNorm);
            AddUnsafe(
                graph, "Mask",
                [&](auto& builder)
                {
                    builder.SetRenderAttachment(mask, 0);
                    builder.AllowPassCulling(false);
                },
                [](UnsafeCommandBuffer& cmd) { Draw(cmd); });
        });
    RendererHarness harness;
    harness.renderer.builtIn = {&pass};
    const CompiledFrame frame = harness.Render(true);
    ASSERT_EQ(frame.passes.size(), 1u);
    ASSERT_EQ(frame.passes[0].colors.size(), 1u);
    EXPECT_EQ(frame.passes[0].colors[0].texture->name(), "_Mask");
}

TEST(GraphPasses, OverrideOneWayToDrawAtLeast)
{
    ScriptableRenderPass pass;
    pass.profilingSampler = ProfilingSampler("Empty");
    RendererHarness harness;
    harness.renderer.builtIn = {&pass};
    EXPECT_EQ(ThrownMessage<ContractError>([&] { harness.Render(); }),
              "pass 'Empty' overrides neither Execute nor RecordRenderGraph");
}

} // namespace
} // namespace limn::test

#include "graph/GraphHarness.h"

#include <gtest/gtest.h>

#include "Mentions.h"
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

/// Says which of its ways to draw has run.
class PassOfBothWays final : public ScriptableRenderPass
{
public:
    void Execute(ScriptableRenderContext&, RenderingData&) override { ran += "Execute "; }
    void RecordRenderGraph(RenderGraph&, ContextContainer&) override { ran += "Graph "; }
    std::string ran;
};

class PassOfTheOldWay final : public ScriptableRenderPass
{
public:
    void Execute(ScriptableRenderContext&, RenderingData&) override { ++count; }
    int count = 0;
};

TEST(GraphPasses, RunTheirGraphUnlessCompatibilityModeIsOn)
{
    PassOfBothWays both;
    PassOfTheOldWay old;
    GraphPass graph([](RenderGraph&, ContextContainer&) {});
    RendererHarness harness;
    harness.renderer.builtIn = {&both, &old, &graph};
    harness.Render();
    harness.Render();
    EXPECT_EQ(both.ran, "Graph Graph ");
    EXPECT_EQ(old.count, 2);
    both.ran.clear();
    harness.enableRenderCompatibilityMode = true;
    harness.Render();
    EXPECT_EQ(both.ran, "Execute ");
    EXPECT_EQ(old.count, 3);
}

TEST(GraphPasses, OverrideOneWayToDrawAtLeast)
{
    ScriptableRenderPass pass;
    pass.profilingSampler = ProfilingSampler("Empty");
    RendererHarness harness;
    harness.renderer.builtIn = {&pass};
    EXPECT_THAT(ThrownMessage<ContractError>([&] { harness.Render(); }),
                Mentions("'Empty'", "neither Execute", "RecordRenderGraph"));
}

} // namespace
} // namespace limn::test

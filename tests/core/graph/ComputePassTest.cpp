#include "graph/GraphHarness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

using test::AddRaster;
using test::Desc;
using test::GraphPass;
using test::Mentions;
using testing::ElementsAre;
using testing::IsEmpty;

std::shared_ptr<ComputeShader> Kernel(const std::string& declarations, const std::string& body)
{
    return ComputeShader::FromText("#pragma kernel K\n" + declarations +
                                       "\n[numthreads(8, 8, 1)]\nvoid K(uint3 id : "
                                       "SV_DispatchThreadID)\n{\n" +
                                       body + "\n}\n",
                                   "Filter.compute", test::Compiler());
}

const std::shared_ptr<ComputeShader>& Filter()
{
    static const auto shader = Kernel("Texture2D _Source; RWTexture2D<float4> _Result;",
                                      "_Result[id.xy] = _Source.Load(int3(id.xy, 0));");
    return shader;
}
const std::shared_ptr<ComputeShader>& Fill()
{
    static const auto shader = Kernel("RWTexture2D<float4> _Result;", "_Result[id.xy] = id.x;");
    return shader;
}
const std::shared_ptr<ComputeShader>& Count()
{
    static const auto shader =
        Kernel("RWStructuredBuffer<uint> _Counts;", "InterlockedAdd(_Counts[0], 1);");
    return shader;
}

/// A compute pass, as AddRaster adds another one.
template <typename Declare, typename Record>
void AddCompute(RenderGraph& graph, const char* name, Declare declare, Record record)
{
    test::NoData* data = nullptr;
    auto builder = graph.AddComputePass<test::NoData>(name, data);
    declare(builder);
    builder.SetRenderFunc([record](test::NoData&, ComputeGraphContext& context)
                          { record(context.cmd); });
}

TextureDesc WritableDesc(const char* name)
{
    TextureDesc desc = Desc(name);
    desc.enableRandomWrite = true;
    return desc;
}

/// Compute passes of a render graph.
class ComputePass : public testing::Test
{
protected:
    void Render(GraphPass::Recording recording)
    {
        m_Pass = std::make_unique<GraphPass>(std::move(recording));
        harness.renderer.builtIn = {m_Pass.get()};
        m_Frame = harness.Render(true);
    }
    std::string ErrorOf(GraphPass::Recording recording)
    {
        return test::OnlyLine(
            test::ThrownMessage<ContractError>([&] { Render(std::move(recording)); }));
    }
    /// _Filled, by a pass "Fill".
    static TextureHandle Filled(RenderGraph& graph)
    {
        const TextureHandle filled = graph.CreateTexture(WritableDesc("_Filled"));
        AddCompute(
            graph, "Fill", [&](auto& builder) { builder.UseTexture(filled, AccessFlags::Write); },
            [=](ComputeCommandBuffer& cmd)
            {
                cmd.SetComputeTextureParam(Fill(), 0, "_Result", filled);
                cmd.DispatchCompute(Fill(), 0, 1, 1, 1);
            });
        return filled;
    }
    static std::vector<std::string> PassesOf(const CompiledFrame& frame)
    {
        std::vector<std::string> names;
        for (const CompiledRenderPass& pass : frame.passes)
        {
            names.push_back(pass.name);
        }
        return names;
    }

    test::RendererHarness harness;
    std::unique_ptr<GraphPass> m_Pass;
    CompiledFrame m_Frame; ///< of the last Render
};

TEST_F(ComputePass, RunsItsKernelsBetweenRasterPasses)
{
    Render(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            const TextureHandle filled = Filled(graph);
            const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
            AddRaster(
                graph, "Show",
                [&](auto& builder)
                {
                    builder.SetRenderAttachment(color, 0);
                    builder.UseTexture(filled);
                },
                [=](RasterCommandBuffer& cmd) { test::Sample(cmd, filled); });
        });
    EXPECT_THAT(harness.report.notes, IsEmpty());
    const auto names = PassesOf(m_Frame);
    EXPECT_NE(std::ranges::find(names, "Fill"), names.end());
}

TEST_F(ComputePass, IsLeftOutWhereNothingReadsWhatItWrites)
{
    Render([](RenderGraph& graph, ContextContainer&) { Filled(graph); });
    const auto names = PassesOf(m_Frame);
    EXPECT_EQ(std::ranges::find(names, "Fill"), names.end());
    EXPECT_TRUE(std::ranges::any_of(m_Frame.leftOut, [](const LeftOut& leftOut)
                                    { return leftOut.reason == "nothing reads '_Filled'"; }));
}

TEST_F(ComputePass, IsKeptWhereItMayNotBeCulled)
{
    Render(
        [](RenderGraph& graph, ContextContainer&)
        {
            const TextureHandle filled = graph.CreateTexture(WritableDesc("_Filled"));
            AddCompute(
                graph, "Fill",
                [&](auto& builder)
                {
                    builder.UseTexture(filled, AccessFlags::Write);
                    builder.AllowPassCulling(false);
                },
                [=](ComputeCommandBuffer& cmd)
                {
                    cmd.SetComputeTextureParam(Fill(), 0, "_Result", filled);
                    cmd.DispatchCompute(Fill(), 0, 1, 1, 1);
                });
        });
    const auto names = PassesOf(m_Frame);
    EXPECT_NE(std::ranges::find(names, "Fill"), names.end());
}

TEST_F(ComputePass, IsRefusedWhereItWritesWhatItDoesNotDeclare)
{
    EXPECT_THAT(ErrorOf(
                    [](RenderGraph& graph, ContextContainer&)
                    {
                        const TextureHandle filled = graph.CreateTexture(WritableDesc("_Filled"));
                        AddCompute(
                            graph, "Fill", [](auto&) {},
                            [=](ComputeCommandBuffer& cmd)
                            {
                                cmd.SetComputeTextureParam(Fill(), 0, "_Result", filled);
                                cmd.DispatchCompute(Fill(), 0, 1, 1, 1);
                            });
                    }),
                Mentions("'Fill'", "no write of '_Filled'", "kernel", "throws", "UseTexture",
                         "AccessFlags::Write"));
}

TEST_F(ComputePass, IsRefusedWhereItSamplesWhatItDoesNotDeclare)
{
    EXPECT_THAT(ErrorOf(
                    [](RenderGraph& graph, ContextContainer&)
                    {
                        const TextureHandle filled = Filled(graph);
                        const TextureHandle result = graph.CreateTexture(WritableDesc("_Out"));
                        AddCompute(
                            graph, "Filter",
                            [&](auto& builder) { builder.UseTexture(result, AccessFlags::Write); },
                            [=](ComputeCommandBuffer& cmd)
                            {
                                cmd.SetComputeTextureParam(Filter(), 0, "_Source", filled);
                                cmd.SetComputeTextureParam(Filter(), 0, "_Result", result);
                                cmd.DispatchCompute(Filter(), 0, 1, 1, 1);
                            });
                    }),
                Mentions("'Filter'", "no read of '_Filled'", "samples", "throws", "UseTexture",
                         "'_Filled'>)"));
}

TEST_F(ComputePass, DeclaresItsBuffers)
{
    const auto run = [](AccessFlags flags)
    {
        return [=](RenderGraph& graph, ContextContainer&)
        {
            BufferDesc desc(4, 4);
            desc.name = "_Counts";
            const BufferHandle counts = graph.CreateBuffer(desc);
            AddCompute(
                graph, "Count",
                [&](auto& builder)
                {
                    if (flags != AccessFlags::None)
                    {
                        builder.UseBuffer(counts, flags);
                    }
                },
                [=](ComputeCommandBuffer& cmd)
                {
                    cmd.SetComputeBufferParam(Count(), 0, "_Counts", counts);
                    cmd.DispatchCompute(Count(), 0, 1, 1, 1);
                });
        };
    };
    EXPECT_THAT(ErrorOf(run(AccessFlags::None)),
                Mentions("'Count'", "no write", "buffer '_Counts'", "kernel", "no buffer",
                         "UseBuffer", "AccessFlags::ReadWrite"));
    EXPECT_THAT(ErrorOf(run(AccessFlags::Read)),
                Mentions("'Count'", "reads buffer '_Counts'", "no pass before"));
    Render(run(AccessFlags::ReadWrite));
    EXPECT_THAT(harness.report.notes, IsEmpty());
}

TEST_F(ComputePass, NotesBuffersThatItDeclaresForNothing)
{
    const auto own = std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::Structured, 4, 4);
    own->SetName("own");
    Render(
        [=](RenderGraph& graph, ContextContainer&)
        {
            const BufferHandle buffer = graph.ImportBuffer(own);
            EXPECT_EQ(buffer, graph.ImportBuffer(own));
            AddCompute(
                graph, "Idle", [&](auto& builder) { builder.UseBuffer(buffer); },
                [](ComputeCommandBuffer&) {});
        });
    EXPECT_THAT(harness.report.notes, ElementsAre(Mentions("'Idle'", "buffer 'own'", "nowhere")));
}

TEST_F(ComputePass, RefusesBuffersOfEarlierFrames)
{
    BufferHandle kept;
    Render([&](RenderGraph& graph, ContextContainer&) { kept = graph.CreateBuffer({4, 4}); });
    EXPECT_THAT(ErrorOf(
                    [=](RenderGraph& graph, ContextContainer&)
                    {
                        AddCompute(
                            graph, "Late", [&](auto& builder) { builder.UseBuffer(kept); },
                            [](ComputeCommandBuffer&) {});
                    }),
                Mentions("'Late'", "UseBuffer", "the buffer is a", "earlier frame"));
}

TEST_F(ComputePass, SwitchesKeywordsAsUnsafePassesDo)
{
    Render(
        [](RenderGraph& graph, ContextContainer&)
        {
            const auto declare = [](auto& builder)
            {
                builder.AllowGlobalStateModification(true);
            };
            const auto record = [](auto& cmd)
            {
                cmd.SetKeyword(GlobalKeyword("GLOBAL"), true);
                cmd.SetKeyword(Fill(), "LOCAL", true);
                cmd.SetComputeFloatParam(Fill(), "_X", 1.0f);
            };
            AddCompute(graph, "Compute", declare, record);
            test::AddUnsafe(graph, "Unsafe", declare, record);
        });
    EXPECT_TRUE(Fill()->IsKeywordEnabled("LOCAL"));
    Fill()->DisableKeyword("LOCAL");
}

TEST_F(ComputePass, MaySetGlobalsWhereItSaysSo)
{
    EXPECT_THAT(
        ErrorOf(
            [](RenderGraph& graph, ContextContainer&)
            {
                AddCompute(
                    graph, "Global", [](auto&) {},
                    [](ComputeCommandBuffer& cmd) { cmd.SetGlobalFloat("_X", 1.0f); });
            }),
        Mentions("'Global'", "global '_X'", "throws", "AllowGlobalStateModification(true)"));
}

TEST_F(ComputePass, HasATransientBuffer)
{
    BufferHandle first;
    Render(
        [&](RenderGraph& graph, ContextContainer&)
        {
            AddCompute(
                graph, "Count",
                [&](auto& builder)
                {
                    first = builder.CreateTransientBuffer(BufferDesc(3, 4));
                    const BufferHandle like = builder.CreateTransientBuffer(first);
                    EXPECT_NE(like, first);
                    EXPECT_EQ(graph.GetBufferDesc(like).count, 3);
                    EXPECT_EQ(graph.GetBufferDesc(like).stride, 4);
                    builder.AllowPassCulling(false);
                    builder.EnableAsyncCompute(true);
                },
                [&](ComputeCommandBuffer& cmd)
                {
                    cmd.SetComputeBufferParam(Count(), 0, "_Counts", first);
                    cmd.DispatchCompute(Count(), 0, 1, 1, 1);
                });
        });
    ASSERT_EQ(m_Frame.passes.size(), 1u);
    EXPECT_TRUE(m_Frame.passes[0].isCompute());
}

} // namespace
} // namespace limn

#include "graph/GraphHarness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "pipeline/PipelineTest.h"

namespace limn
{
namespace
{

using test::AddRaster;
using test::AddUnsafe;
using test::Desc;
using test::Draw;
using test::GraphPass;
using test::Mentions;
using test::Sample;
using testing::ElementsAre;
using testing::IsEmpty;

/// A camera drawn by a UniversalRenderer with one feature, whose passes a test gives.
class RenderGraphFrame : public test::PipelineTest<>
{
protected:
    RenderGraphFrame() : PipelineTest(8, 4) { m_Request.compile.leavesOut = false; }

    void Add(GraphPass::Recording recording, const char* name = "Feature",
             RenderPassEvent event = RenderPassEvent::AfterRenderingTransparents)
    {
        m_Passes.push_back(std::make_unique<GraphPass>(std::move(recording), name, event));
        m_Renderer.AddFeature(std::make_unique<test::LoggingFeature>(
            name, m_Log, std::vector<ScriptableRenderPass*>{m_Passes.back().get()}));
    }

    /// "target" of each pass, in their order.
    static std::vector<std::string> Targets(const RenderResult& result)
    {
        std::vector<std::string> names;
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            names.push_back(pass.colors.empty() ? pass.depth->texture->name()
                                                : pass.colors.front().texture->name());
        }
        return names;
    }
    static const CompiledRenderPass& PassInto(const RenderResult& result, const std::string& target)
    {
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            if (!pass.colors.empty() && pass.colors.front().texture->name() == target)
            {
                return pass;
            }
        }
        throw std::runtime_error("no pass draws into " + target);
    }
    /// Names of what the pass's draws have bound.
    static std::vector<std::string> Sampled(const RenderResult& result,
                                            const CompiledRenderPass& pass)
    {
        std::vector<std::string> names;
        for (const PassCommand& command : pass.commands)
        {
            if (const auto* draw = std::get_if<DrawCommand>(&command))
            {
                for (const TextureSlot& slot : result.frame->Setup(*draw).bindings->textures)
                {
                    names.push_back(slot.texture->name());
                }
            }
        }
        return names;
    }

    test::Log m_Log;
    std::vector<std::unique_ptr<GraphPass>> m_Passes;
};

/// Draws `name` into a texture of its own, and that into the camera's colour.
void DrawMaskAndComposite(RenderGraph& graph, ContextContainer& frameData, const TextureDesc& desc)
{
    const TextureHandle mask = graph.CreateTexture(desc);
    const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
    AddRaster(
        graph, "Mask", [&](auto& builder) { builder.SetRenderAttachment(mask, 0); },
        [](RasterCommandBuffer& cmd) { Draw(cmd); });
    AddRaster(
        graph, "Composite",
        [&](auto& builder)
        {
            builder.UseTexture(mask);
            builder.SetRenderAttachment(color, 0);
        },
        [mask](RasterCommandBuffer& cmd) { Sample(cmd, mask); });
}

} // namespace

TEST_F(RenderGraphFrame, RunsPassesInTheirOrderIntoWhatTheyDeclare)
{
    Add([](RenderGraph& graph, ContextContainer& frameData)
        { DrawMaskAndComposite(graph, frameData, Desc("_Mask")); });
    const RenderResult result = Render();
    EXPECT_THAT(Targets(result), ElementsAre("_CameraColorAttachmentA", "_Mask",
                                             "_CameraColorAttachmentA", "limn_Output"));
    const CompiledRenderPass& mask = result.frame->passes.at(1);
    EXPECT_EQ(mask.name, "Mask");
    EXPECT_EQ(mask.colors[0].load, LoadOp::Clear);
    EXPECT_EQ(mask.colors[0].clearColor, Color::black);
    EXPECT_FALSE(mask.depth.has_value());
    const CompiledRenderPass& composite = result.frame->passes.at(2);
    EXPECT_EQ(composite.name, "Composite");
    EXPECT_EQ(composite.colors[0].load, LoadOp::Load);
    EXPECT_THAT(Sampled(result, composite), ElementsAre("_Mask"));
    EXPECT_THAT(result.report.notes, IsEmpty());
}

TEST_F(RenderGraphFrame, BeginsATextureWithNothingWhereItsDescOrWriteAllSaysSo)
{
    TextureDesc unclear = Desc("_Unclear");
    unclear.clearBuffer = false;
    Add(
        [&](RenderGraph& graph, ContextContainer&)
        {
            const TextureHandle one = graph.CreateTexture(unclear);
            const TextureHandle other = graph.CreateTexture(Desc("_Covered"));
            const auto draw = [](RasterCommandBuffer& cmd)
            {
                Draw(cmd);
            };
            AddRaster(
                graph, "1", [&](auto& builder) { builder.SetRenderAttachment(one, 0); }, draw);
            AddRaster(
                graph, "2",
                [&](auto& builder)
                { builder.SetRenderAttachment(other, 0, AccessFlags::WriteAll); },
                draw);
        });
    const RenderResult result = Render();
    EXPECT_EQ(PassInto(result, "_Unclear").colors[0].load, LoadOp::DontCare);
    EXPECT_EQ(PassInto(result, "_Covered").colors[0].load, LoadOp::DontCare);
}

/// So does what is made like it begin: features that blend into a mask count on it.
TEST_F(RenderGraphFrame, SaysOfABaseCamerasTexturesThatTheyAreCleared)
{
    m_Camera.backgroundColor = Color(1, 0, 0, 0.5f);
    Add(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            const auto& resources = frameData.Get<UniversalResourceData>();
            TextureDesc desc = graph.GetTextureDesc(resources.cameraColor);
            EXPECT_TRUE(desc.clearBuffer);
            EXPECT_EQ(desc.clearColor, Color(1, 0, 0, 0.5f));
            EXPECT_TRUE(graph.GetTextureDesc(resources.cameraDepth).clearBuffer);
            desc.name = "_Like";
            desc.clearColor = Color::clear;
            DrawMaskAndComposite(graph, frameData, desc);
        });
    const RenderResult result = Render();
    EXPECT_EQ(PassInto(result, "_Like").colors[0].load, LoadOp::Clear);
    EXPECT_EQ(PassInto(result, "_Like").colors[0].clearColor, Color::clear);
    int clears = 0;
    for (const CompiledRenderPass& pass : result.frame->passes)
    {
        const bool isCamera =
            !pass.colors.empty() && pass.colors[0].texture->name() == "_CameraColorAttachmentA";
        clears += isCamera && pass.colors[0].load == LoadOp::Clear ? 1 : 0;
    }
    EXPECT_EQ(clears, 1) << "the pipeline's own, before the objects";
}

TEST_F(RenderGraphFrame, MakesATextureLikeAnotherOneByAnotherName)
{
    Add(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            const auto& resources = frameData.Get<UniversalResourceData>();
            const TextureHandle kept = graph.CreateTexture(resources.cameraColor, "_Kept");
            TextureDesc desc = graph.GetTextureDesc(resources.cameraColor);
            EXPECT_EQ(graph.GetTextureDesc(kept).format, desc.format);
            EXPECT_EQ(graph.GetTextureDesc(kept).width, 8);
            EXPECT_FALSE(graph.GetTextureDesc(kept).clearBuffer);
            const TextureHandle cleared = graph.CreateTexture(kept, "_Cleared", true);
            EXPECT_TRUE(graph.GetTextureDesc(cleared).clearBuffer);
            for (const TextureHandle& texture : {kept, cleared})
            {
                AddRaster(
                    graph, "Draw", [&](auto& builder) { builder.SetRenderAttachment(texture, 0); },
                    [](RasterCommandBuffer& cmd) { Draw(cmd); });
            }
        });
    const RenderResult result = Render();
    EXPECT_THAT(Targets(result), testing::IsSupersetOf({"_Kept", "_Cleared"}));
}

TEST_F(RenderGraphFrame, TakesASamplerAndShowsAPassByItsName)
{
    Add(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
            const ProfilingSampler sampler("Sampler");
            test::NoData* data = nullptr;
            {
                auto builder = graph.AddRasterRenderPass("Raster", data, sampler);
                builder.SetRenderAttachment(color, 0);
                builder.SetRenderFunc([](test::NoData&, RasterGraphContext& context)
                                      { Draw(context.cmd); });
            }
            {
                auto builder = graph.AddUnsafePass("Unsafe", data, sampler);
                const TextureHandle other = graph.CreateTexture(Desc("_Other"));
                builder.UseTexture(other, AccessFlags::Write);
                builder.SetRenderFunc(
                    [other](test::NoData&, UnsafeGraphContext& context)
                    {
                        context.cmd.SetRenderTarget(other);
                        Draw(context.cmd);
                    });
            }
            auto builder = graph.AddComputePass("Compute", data, sampler);
            builder.SetRenderFunc([](test::NoData&, ComputeGraphContext&) {});
        });
    const RenderResult result = Render();
    std::vector<std::string> names;
    for (const CompiledRenderPass& pass : result.frame->passes)
    {
        names.push_back(pass.name);
    }
    EXPECT_THAT(names, testing::IsSupersetOf({"Raster", "Unsafe"}));
    EXPECT_THAT(names, testing::Not(testing::Contains("Sampler")));
}

TEST_F(RenderGraphFrame, GivesEachHandleATextureAndTheNextFrameTheSameOnes)
{
    std::vector<RTHandle> textures;
    Add(
        [&](RenderGraph& graph, ContextContainer&)
        {
            for (const char* name : {"_A", "_A", "_B"})
            {
                textures.push_back(graph.CreateTexture(Desc(name)));
            }
        });
    Render();
    Render();
    ASSERT_EQ(textures.size(), 6u);
    EXPECT_NE(textures[0], textures[1]);
    EXPECT_EQ(textures[0], textures[3]);
    EXPECT_EQ(textures[1], textures[4]);
    EXPECT_EQ(textures[2], textures[5]);
    EXPECT_EQ(textures[2].rt()->name(), "_B");
    EXPECT_TRUE(textures[2].rt()->isTransient());
}

TEST_F(RenderGraphFrame, MakesTexturesOfAPartOfTheCamerasSizeAndWithMips)
{
    std::vector<TextureHandle> made;
    Add(
        [&](RenderGraph& graph, ContextContainer&)
        {
            TextureDesc scaled(glm::vec2(0.5f, 2.0f));
            scaled.name = "_Scaled";
            scaled.useMipMap = true;
            scaled.anisoLevel = 4;
            TextureDesc byFunction([](const glm::ivec2& size) { return size / 3; });
            byFunction.name = "_ByFunction";
            made = {graph.CreateTexture(scaled), graph.CreateTexture(byFunction),
                    TextureHandle::nullHandle};
        });
    Render(); // 8x4
    ASSERT_EQ(made.size(), 3u);
    EXPECT_EQ(made[0].rt()->width(), 4);
    EXPECT_EQ(made[0].rt()->height(), 8);
    EXPECT_EQ(made[0].rt()->mipmapCount(), 4);
    EXPECT_EQ(made[0].rt()->sampler().anisoLevel, 4);
    EXPECT_EQ(made[1].rt()->width(), 2);
    EXPECT_EQ(made[1].rt()->height(), 1);
    EXPECT_FALSE(made[2].IsValid());
    EXPECT_FALSE(RendererListHandle::nullHandle.IsValid());
}

TEST_F(RenderGraphFrame, NamesATextureOfNoSize)
{
    const auto message = [](const TextureDesc& desc)
    {
        return test::ThrownMessage<ContractError>([&] { desc.descriptor(); });
    };
    EXPECT_THAT(message(TextureDesc(glm::vec2(0.0f, 1.0f))),
                Mentions("CreateTexture:", "scale factor is 0, 1;", "greater than 0"));
    EXPECT_THAT(message(TextureDesc(RTHandles::ScaleFunc())),
                Mentions("CreateTexture", "scale function", "empty"));
}

TEST_F(RenderGraphFrame, IsWorkedOutOnceWhileFramesRecordTheSame)
{
    m_Request.compile.leavesOut = true;
    Add([](RenderGraph& graph, ContextContainer& frameData)
        { DrawMaskAndComposite(graph, frameData, Desc("_Mask")); });
    Render();
    Render();
    const std::uint64_t structure = Render().frame->structure;
    EXPECT_NE(structure, 0u);
    EXPECT_EQ(Render().frame->structure, structure);
}

TEST_F(RenderGraphFrame, OrdersPassesOfBothStylesByTheirEvent)
{
    test::LoggingPass old("old", RenderPassEvent::AfterRenderingOpaques, m_Log);
    const auto nothing = [](RenderGraph&, ContextContainer&) {
    };
    Add(nothing, "late", RenderPassEvent::AfterRenderingOpaques + 1);
    m_Renderer.AddFeature(std::make_unique<test::LoggingFeature>(
        "old", m_Log, std::vector<ScriptableRenderPass*>{&old}));
    Add(nothing, "early", RenderPassEvent::BeforeRenderingOpaques);
    std::vector<std::string> names;
    for (const ExecutedPassReport& pass : Render().report.passes)
    {
        names.push_back(pass.name.name());
    }
    EXPECT_THAT(names, ElementsAre("early", "Draw Opaque Objects", "old", "late",
                                   "Draw Transparent Objects", "Final Blit"));
}

TEST_F(RenderGraphFrame, LeavesOutWhatNothingReadsUnlessAPassIsNotToBeCulled)
{
    m_Request.compile.leavesOut = true;
    bool allowsCulling = true;
    bool allowsGlobals = false;
    Add(
        [&](RenderGraph& graph, ContextContainer&)
        {
            const TextureHandle texture = graph.CreateTexture(Desc("_Unread"));
            AddRaster(
                graph, "Unread",
                [&](auto& builder)
                {
                    builder.SetRenderAttachment(texture, 0);
                    builder.AllowGlobalStateModification(allowsGlobals);
                    builder.AllowPassCulling(allowsCulling);
                },
                [](RasterCommandBuffer& cmd) { Draw(cmd); });
        });
    const RenderResult culled = Render();
    EXPECT_THAT(Targets(culled), ElementsAre("limn_Output"));
    ASSERT_FALSE(culled.frame->leftOut.empty());
    EXPECT_EQ(culled.frame->leftOut.back().reason, "nothing reads '_Unread'");
    allowsCulling = false;
    EXPECT_THAT(Targets(Render()), testing::Contains("_Unread"));
    allowsCulling = true;
    allowsGlobals = true; // whatever AllowPassCulling says
    EXPECT_THAT(Targets(Render()), testing::Contains("_Unread"));
}

TEST_F(RenderGraphFrame, MakesATextureGlobalBehindThePassThatSaysSo)
{
    const ShaderPropertyId blitTexture("_BlitTexture");
    Add(
        [&](RenderGraph& graph, ContextContainer& frameData)
        {
            const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
            const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
            AddRaster(
                graph, "Mask",
                [&](auto& builder)
                {
                    builder.SetRenderAttachment(mask, 0);
                    builder.SetGlobalTextureAfterPass(mask, blitTexture);
                },
                [](RasterCommandBuffer& cmd) { Draw(cmd); });
            for (const bool all : {false, true})
            {
                AddRaster(
                    graph, "Composite",
                    [&](auto& builder)
                    {
                        if (all)
                        {
                            builder.UseAllGlobalTextures(true);
                        }
                        else
                        {
                            builder.UseGlobalTexture(blitTexture);
                        }
                        builder.SetRenderAttachment(color, 0);
                    },
                    [](RasterCommandBuffer& cmd) { Draw(cmd, test::Sampling()); });
            }
        });
    const RenderResult result = Render();
    EXPECT_THAT(Sampled(result, result.frame->passes.at(2)), ElementsAre("_Mask", "_Mask"));
}

TEST_F(RenderGraphFrame, GivesShadersTheInputAttachmentsUnderTheirNumbers)
{
    const auto inputs = std::make_shared<const Material>(
        test::ShaderWithProgram("", "Texture2D _UnityFBInput0; Texture2D _UnityFBInput3;",
                                "_UnityFBInput0.Load(0) + _UnityFBInput3.Load(0)"));
    Add(
        [&](RenderGraph& graph, ContextContainer& frameData)
        {
            const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
            const TextureHandle first = graph.CreateTexture(Desc("_First"));
            const TextureHandle second = graph.CreateTexture(Desc("_Second"));
            for (const TextureHandle& drawn : {first, second})
            {
                AddRaster(
                    graph, "Fill", [&](auto& builder) { builder.SetRenderAttachment(drawn, 0); },
                    [](RasterCommandBuffer& cmd) { Draw(cmd); });
            }
            for (const bool swapped : {false, true})
            {
                AddRaster(
                    graph, "Composite",
                    [&](auto& builder)
                    {
                        builder.SetInputAttachment(first, swapped ? 3 : 0);
                        builder.SetInputAttachment(second, swapped ? 0 : 3);
                        builder.SetRenderAttachment(color, 0);
                    },
                    [=](RasterCommandBuffer& cmd) { Draw(cmd, inputs); });
            }
        });
    const RenderResult result = Render();
    EXPECT_THAT(Sampled(result, result.frame->passes.at(result.frame->passes.size() - 2)),
                ElementsAre("_First", "_Second", "_Second", "_First"));
}

TEST_F(RenderGraphFrame, TakesAnAssignedTextureForTheCamerasColourFromThenOn)
{
    Add(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            auto& resources = frameData.Get<UniversalResourceData>();
            const TextureHandle source = resources.activeColorTexture();
            TextureDesc desc = source.GetDescriptor(graph);
            desc.name = "_Inverted";
            const TextureHandle destination = graph.CreateTexture(desc);
            graph.AddBlitPass({source, destination, test::Sampling(), 0}, "Invert");
            resources.cameraColor = destination;
            EXPECT_EQ(resources.activeColorTexture(), destination);
        });
    Add(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
            EXPECT_EQ(color.rt()->name(), "_Inverted");
            AddRaster(
                graph, "Later", [&](auto& builder) { builder.SetRenderAttachment(color, 0); },
                [](RasterCommandBuffer& cmd) { Draw(cmd); });
        },
        "Later", RenderPassEvent::AfterRenderingTransparents + 1);
    for (int frame = 0; frame < 2; ++frame) // each begins with the renderer's own
    {
        const RenderResult result = Render();
        EXPECT_THAT(Targets(result),
                    ElementsAre("_CameraColorAttachmentA", "_Inverted", "limn_Output"));
        EXPECT_THAT(Sampled(result, PassInto(result, "limn_Output")), ElementsAre("_Inverted"));
    }
}

TEST_F(RenderGraphFrame, CopiesAndBlitsWithTheRenderersShader)
{
    Add(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
            TextureDesc desc = color.GetDescriptor(graph);
            desc.name = "_Copy";
            const TextureHandle copy = graph.CreateTexture(desc);
            const TextureHandle half = graph.CreateTexture(Desc("_Half"));
            graph.AddCopyPass(color, copy);
            graph.AddBlitPass(copy, half, glm::vec2(0.5f), glm::vec2(0.25f));
        });
    const RenderResult result = Render();
    EXPECT_THAT(Sampled(result, PassInto(result, "_Copy")), ElementsAre("_CameraColorAttachmentA"));
    EXPECT_THAT(Sampled(result, PassInto(result, "_Half")), ElementsAre("_Copy"));
}

TEST_F(RenderGraphFrame, BlitsWithTheSourceUnderAnotherName)
{
    const auto material = std::make_shared<const Material>(test::ShaderWithProgram(
        "", "Texture2D _Other; SamplerState sampler_Other;", "_Other.Sample(sampler_Other, 0)"));
    Add(
        [&material](RenderGraph& graph, ContextContainer& frameData)
        {
            const auto& resources = frameData.Get<UniversalResourceData>();
            RenderGraphUtils::BlitMaterialParameters blit(
                resources.activeColorTexture(), graph.CreateTexture(Desc("_Kept")), material, 0);
            blit.sourceTexturePropertyID = Shader::PropertyToID("_Other");
            graph.AddBlitPass(blit, "Keep");
        });
    const RenderResult result = Render();
    EXPECT_THAT(Sampled(result, PassInto(result, "_Kept")), ElementsAre("_CameraColorAttachmentA"));
}

TEST_F(RenderGraphFrame, DrawsRendererListsAndCountsWhatBecameOfThem)
{
    test::AddCube(m_Scene, "cube", {0.0f, 0.0f, 5.0f}, {test::Plain()});
    Add(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            const auto& rendering = frameData.Get<UniversalRenderingData>();
            const DrawingSettings drawing = RenderingUtils::CreateDrawingSettings(
                ShaderTagId("UniversalForward"), rendering, frameData.Get<UniversalCameraData>(),
                frameData.Get<UniversalLightData>(), SortingCriteria::CommonOpaque);
            const RendererListHandle list = graph.CreateRendererList(RendererListParams(
                rendering.cullResults(), drawing, FilteringSettings(RenderQueueRange::opaque)));
            const auto& resources = frameData.Get<UniversalResourceData>();
            AddRaster(
                graph, "List",
                [&](auto& builder)
                {
                    builder.UseRendererList(list);
                    builder.SetRenderAttachment(resources.activeColorTexture(), 0);
                    builder.SetRenderAttachmentDepth(resources.activeDepthTexture());
                },
                [list](RasterCommandBuffer& cmd) { cmd.DrawRendererList(list); });
        });
    const RenderResult result = Render();
    EXPECT_EQ(result.report.draws.back().pass, "List");
    EXPECT_EQ(result.report.draws.back().counts, (FilterCounts{1, 0, 0, 0, 0}));
    EXPECT_THAT(result.report.notes, IsEmpty());
}

TEST_F(RenderGraphFrame, LetsAnUnsafePassSetItsTargetsAndUseANativeCommandBuffer)
{
    Add(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
            const TextureHandle mask = graph.CreateTexture(Desc("_Mask"));
            AddUnsafe(
                graph, "Chain",
                [&](auto& builder)
                {
                    builder.UseTexture(mask, AccessFlags::ReadWrite);
                    builder.UseTexture(color, AccessFlags::Write);
                },
                [mask, color](UnsafeCommandBuffer& cmd)
                {
                    cmd.SetRenderTarget(mask);
                    Draw(cmd);
                    Blitter::BlitCameraTexture(CommandBufferHelpers::GetNativeCommandBuffer(cmd),
                                               mask, color, test::Sampling(), 0);
                });
        });
    const RenderResult result = Render();
    EXPECT_THAT(Targets(result), ElementsAre("_CameraColorAttachmentA", "_Mask",
                                             "_CameraColorAttachmentA", "limn_Output"));
    EXPECT_EQ(result.frame->passes.at(1).colors[0].load, LoadOp::Clear);
    EXPECT_THAT(result.report.notes, IsEmpty());
}

TEST_F(RenderGraphFrame, GivesThePassItsDataAndHandsItsTexturesToLaterOnes)
{
    struct Shared final : ContextItem
    {
        TextureHandle texture;
        void Reset() override { texture = {}; }
    };
    struct PassData
    {
        TextureHandle source;
    };
    Add(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            const TextureHandle made = graph.CreateTexture(Desc("_Made"));
            frameData.Create<Shared>().texture = made;
            AddRaster(
                graph, "Make", [&](auto& builder) { builder.SetRenderAttachment(made, 0); },
                [](RasterCommandBuffer& cmd) { Draw(cmd); });
        },
        "Make");
    Add(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            PassData* passData = nullptr;
            auto builder = graph.AddRasterRenderPass<PassData>("Use", passData);
            passData->source = frameData.Get<Shared>().texture;
            builder.UseTexture(passData->source);
            builder.SetRenderAttachment(frameData.Get<UniversalResourceData>().activeColorTexture(),
                                        0);
            builder.SetRenderFunc([](PassData& data, RasterGraphContext& context)
                                  { Sample(context.cmd, data.source); });
        },
        "Use");
    const RenderResult result = Render();
    EXPECT_THAT(Sampled(result, result.frame->passes.at(2)), ElementsAre("_Made"));
}

TEST_F(RenderGraphFrame, ClearsAnImportedTextureOnlyWhereItIsAskedTo)
{
    const RTHandle kept(test::Target("_Kept"));
    const RTHandle cleared(test::Target("_Cleared"));
    Add(
        [&](RenderGraph& graph, ContextContainer&)
        {
            const TextureHandle handles[] = {graph.ImportTexture(kept),
                                             graph.ImportTexture(cleared, {true, Color::green})};
            for (const TextureHandle& texture : handles)
            {
                AddRaster(
                    graph, "Draw", [&](auto& builder) { builder.SetRenderAttachment(texture, 0); },
                    [](RasterCommandBuffer& cmd) { Draw(cmd); });
            }
        });
    const RenderResult result = Render();
    EXPECT_NE(PassInto(result, "_Kept").colors[0].load, LoadOp::Clear);
    EXPECT_EQ(PassInto(result, "_Cleared").colors[0].load, LoadOp::Clear);
    EXPECT_EQ(PassInto(result, "_Cleared").colors[0].clearColor, Color::green);
}

} // namespace limn

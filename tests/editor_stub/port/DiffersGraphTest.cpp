#include "port/Differs.h"

#include "Mentions.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/RecordingDevice.h>

namespace limn::test
{

namespace
{

using testing::Contains;
using testing::HasSubstr;

struct PassData
{
    TextureHandle source;
};

using Recording = std::function<void(RenderGraph&, ContextContainer&)>;

class RecordedPass final : public ScriptableRenderPass
{
public:
    explicit RecordedPass(Recording recording) : m_Recording(std::move(recording)) {}
    void Execute(ScriptableRenderContext&, RenderingData&) override { ++executed; }
    void RecordRenderGraph(RenderGraph& graph, ContextContainer& frameData) override
    {
        ++recorded;
        m_Recording(graph, frameData);
    }
    int executed = 0;
    int recorded = 0;

private:
    Recording m_Recording;
};

class OnePassFeature final : public ScriptableRendererFeature
{
public:
    explicit OnePassFeature(ScriptableRenderPass& pass) : m_Pass(pass) {}
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(m_Pass);
    }

private:
    ScriptableRenderPass& m_Pass;
};

RenderResult Render(ScriptableRenderPass& pass, bool compatibilityMode = false)
{
    static RecordingDevice device;
    UniversalRenderPipeline pipeline(device);
    pipeline.enableRenderCompatibilityMode = compatibilityMode;
    UniversalRenderer renderer(DiffersCompiler());
    renderer.AddFeature(std::make_unique<OnePassFeature>(pass));
    Scene scene;
    Camera camera;
    RenderRequest request;
    request.scene = &scene;
    request.camera = &camera;
    request.width = 8;
    request.height = 4;
    return pipeline.RenderSingleCamera(renderer, request);
}

RenderResult RenderGraphOf(Recording recording)
{
    RecordedPass pass(std::move(recording));
    return Render(pass);
}

std::string ErrorOf(Recording recording)
{
    try
    {
        RenderGraphOf(std::move(recording));
    }
    catch (const ContractError& error)
    {
        return error.what();
    }
    return "nothing is thrown";
}

TextureDesc Desc(const char* name)
{
    TextureDesc desc(8, 4);
    desc.name = name;
    return desc;
}

std::shared_ptr<const Material> GraphMaterial()
{
    return std::make_shared<const Material>(DiffersShader());
}

/// A pass "Own" of one kind of builder.
template <typename Declare, typename Record>
void AddOwn(RenderGraph& graph, bool isRaster, Declare declare, Record record)
{
    PassData* data = nullptr;
    if (isRaster)
    {
        auto builder = graph.AddRasterRenderPass<PassData>("Own", data);
        declare(builder);
        builder.SetRenderFunc([record](PassData&, RasterGraphContext& context)
                              { record(context.cmd); });
        return;
    }
    auto builder = graph.AddUnsafePass<PassData>("Own", data);
    declare(builder);
    builder.SetRenderFunc([record](PassData&, UnsafeGraphContext& context)
                          { record(context.cmd); });
}

const auto k_DrawNothing = [](BaseCommandBuffer&) {
};
const auto k_DrawAll = [](BaseCommandBuffer& cmd)
{
    CoreUtils::DrawFullScreen(cmd, GraphMaterial());
};

void ExpectABuilderAndDataThatIsAPointer()
{
    int ran = 0;
    RenderGraphOf(
        [&](RenderGraph& graph, ContextContainer& frameData)
        {
            const TextureHandle color = frameData.Get<UniversalResourceData>().activeColorTexture();
            PassData* passData = nullptr;
            {
                auto builder = graph.AddRasterRenderPass<PassData>("Raster", passData);
                passData->source = color;
                builder.SetRenderAttachment(color, 0);
                builder.SetRenderFunc(
                    [&ran](PassData& data, RasterGraphContext& context)
                    {
                        ran += data.source.IsValid() ? 1 : 0;
                        k_DrawAll(context.cmd);
                    });
            }
            auto builder =
                graph.AddUnsafePass<PassData>("Unsafe", passData, ProfilingSampler("Unsafe"));
            builder.AllowPassCulling(false);
            builder.SetRenderFunc([&ran](PassData&, UnsafeGraphContext&) { ran += 10; });
        });
    EXPECT_EQ(ran, 11);
}

void ExpectASentenceForWhatIsNotDeclared()
{
    for (const bool isRaster : {true, false})
    {
        const auto nothing = [](auto&) {
        };
        EXPECT_THAT(ErrorOf([&](RenderGraph& graph, ContextContainer&)
                            { AddOwn(graph, isRaster, nothing, k_DrawAll); }),
                    HasSubstr("pass 'Own' draws"))
            << "no SetRenderAttachment, no SetRenderTarget";
        const auto read =
            [&](const std::function<void(BaseRenderGraphBuilder&, const TextureHandle&)>& declare)
        {
            return ErrorOf(
                [&](RenderGraph& graph, ContextContainer&)
                {
                    TextureDesc desc = Desc("_Own");
                    desc.clearBuffer = false;
                    const TextureHandle own = graph.CreateTexture(desc);
                    AddOwn(
                        graph, isRaster, [&](auto& builder) { declare(builder, own); },
                        k_DrawNothing);
                });
        };
        EXPECT_THAT(read([](BaseRenderGraphBuilder& builder, const TextureHandle& own)
                         { builder.UseTexture(own); }),
                    Mentions("'Own'", "reads '_Own'", "no pass before"));
        EXPECT_THAT(read([](BaseRenderGraphBuilder& builder, const TextureHandle&)
                         { builder.UseGlobalTexture("_NoGlobal"); }),
                    Mentions("no pass before", "global"));
        EXPECT_THAT(
            ErrorOf(
                [&](RenderGraph& graph, ContextContainer&)
                {
                    AddOwn(graph, isRaster, nothing,
                           [](BaseCommandBuffer& cmd) { cmd.SetGlobalFloat("_Width", 1.0f); });
                }),
            HasSubstr(isRaster ? "AllowGlobalStateModification(true)" : "AllowPassCulling(false)"));
    }
}

/// What a pass that declares this and draws nothing, or all of it, has noted.
void ExpectANoteForWhatIsDeclaredForNothing()
{
    for (const bool isRaster : {true, false})
    {
        const RenderResult result = RenderGraphOf(
            [&](RenderGraph& graph, ContextContainer&)
            {
                const TextureHandle own = graph.CreateTexture(Desc("_Own"));
                AddOwn(
                    graph, isRaster,
                    [&](auto& builder)
                    {
                        builder.SetRenderAttachment(own, 0);
                        builder.AllowPassCulling(false);
                        builder.EnableAsyncCompute(true); // no effect
                    },
                    k_DrawNothing);
            });
        EXPECT_THAT(result.report.notes, Contains(Mentions("write of '_Own'", "draws nothing")));
    }
}

void ExpectWhatIsDeclaredToBeDone()
{
    const RenderResult result = RenderGraphOf(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            const auto& resources = frameData.Get<UniversalResourceData>();
            const TextureHandle own = graph.CreateTexture(Desc("_Own"));
            AddOwn(
                graph, true,
                [&](auto& builder)
                {
                    builder.SetRenderAttachment(own, 0);
                    builder.SetRenderAttachmentDepth(resources.activeDepthTexture());
                    builder.SetGlobalTextureAfterPass(own, "_Made");
                    builder.AllowPassCulling(false);
                },
                k_DrawAll);
            AddOwn(
                graph, false,
                [&](auto& builder)
                {
                    builder.UseGlobalTexture("_Made");
                    builder.UseAllGlobalTextures(true);
                    builder.SetGlobalTextureAfterPass(own, "_Made");
                    builder.AllowPassCulling(false);
                    builder.AllowGlobalStateModification(true);
                },
                [](BaseCommandBuffer& cmd) { cmd.SetGlobalFloat("_Width", 1.0f); });
        });
    ASSERT_FALSE(result.frame->passes.empty());
    const auto pass =
        std::ranges::find_if(result.frame->passes, [](const auto& p) { return p.name == "Own"; });
    ASSERT_NE(pass, result.frame->passes.end());
    EXPECT_TRUE(pass->depth.has_value());
    EXPECT_EQ(pass->colors.front().texture->name(), "_Own");
}

void ExpectRendererListsToBeDeclared()
{
    for (const bool isRaster : {true, false})
    {
        const auto draw = [&](bool declares)
        {
            return ErrorOf(
                [&](RenderGraph& graph, ContextContainer& frameData)
                {
                    const auto& rendering = frameData.Get<UniversalRenderingData>();
                    const RendererListParams params(rendering.cullResults(),
                                                    RenderingUtils::CreateDrawingSettings(
                                                        ShaderTagId("UniversalForward"), rendering,
                                                        frameData.Get<UniversalCameraData>(),
                                                        frameData.Get<UniversalLightData>(),
                                                        SortingCriteria::CommonOpaque),
                                                    FilteringSettings());
                    EXPECT_EQ(params.cullingResults, &rendering.cullResults());
                    EXPECT_GE(rendering.time(), 0.0);
                    const RendererListHandle list = graph.CreateRendererList(params);
                    AddOwn(
                        graph, isRaster,
                        [&](auto& builder)
                        {
                            builder.SetRenderAttachment(
                                frameData.Get<UniversalResourceData>().activeColorTexture(), 0);
                            if (declares)
                            {
                                builder.UseRendererList(list);
                            }
                        },
                        [list](BaseCommandBuffer& cmd) { cmd.DrawRendererList(list); });
                });
        };
        EXPECT_EQ(draw(true), "nothing is thrown");
        EXPECT_THAT(draw(false), HasSubstr("without declaring it by UseRendererList"));
    }
}

/// Rectangles, instances and objects of RasterCommandBuffer and UnsafeCommandBuffer.
void ExpectDrawsAsOfACommandBuffer()
{
    GameObject object;
    const auto quad = CreatePrimitive(PrimitiveType::Quad);
    const std::vector<glm::mat4> matrices(3, glm::mat4(1.0f));
    for (const bool isRaster : {true, false})
    {
        object.renderer = MeshRenderer{quad, {GraphMaterial()}};
        const RenderResult result = RenderGraphOf(
            [&](RenderGraph& graph, ContextContainer&)
            {
                const TextureHandle own = graph.CreateTexture(Desc("_Own"));
                AddOwn(
                    graph, isRaster,
                    [&](auto& builder)
                    {
                        builder.SetRenderAttachment(own, 0);
                        builder.AllowPassCulling(false);
                    },
                    [&](BaseCommandBuffer& cmd)
                    {
                        cmd.SetViewport({1, 0, 4, 2});
                        cmd.EnableScissorRect({2, 0, 3, 1});
                        cmd.DrawRenderer(object, GraphMaterial(), 0, 0);
                        cmd.DrawMeshInstanced(quad, 0, GraphMaterial(), 0, matrices);
                        object.renderer->mesh = CreatePrimitive(PrimitiveType::Cube);
                    });
            });
        const auto pass = std::ranges::find_if(result.frame->passes,
                                               [](const auto& p) { return p.name == "Own"; });
        ASSERT_NE(pass, result.frame->passes.end());
        std::vector<ViewportRect> viewports;
        std::uint32_t instances = 0;
        for (const PassCommand& command : pass->commands)
        {
            if (const auto* viewport = std::get_if<SetViewportCommand>(&command))
            {
                viewports.push_back(viewport->rect);
            }
            if (const auto* draw = std::get_if<DrawCommand>(&command))
            {
                EXPECT_EQ(result.frame->MeshOf(*draw), quad) << "as it was when recorded";
                EXPECT_EQ(draw->scissor, (ViewportRect{2, 0, 3, 1}));
                instances += draw->instanceCount;
            }
        }
        EXPECT_THAT(viewports, Contains(ViewportRect{1, 0, 4, 2}));
        EXPECT_EQ(instances, 4u) << "without enableInstancing";
    }
}

void ExpectASentenceForABufferThatThePassBeforeUses()
{
    using Target = GraphicsBuffer::Target;
    const auto from =
        std::make_shared<GraphicsBuffer>(Target::Structured | Target::CopySource, 4, 4);
    const auto to =
        std::make_shared<GraphicsBuffer>(Target::Structured | Target::CopyDestination, 4, 4);
    const std::vector<std::uint32_t> numbers(4);
    for (const bool isCompute : {true, false})
    {
        EXPECT_THAT(ErrorOf(
                        [&](RenderGraph& graph, ContextContainer&)
                        {
                            const auto uncullable = [](auto& builder)
                            {
                                builder.AllowPassCulling(false);
                            };
                            PassData* data = nullptr;
                            {
                                auto builder = graph.AddUnsafePass<PassData>("Copy", data);
                                uncullable(builder);
                                builder.SetRenderFunc(
                                    [&](PassData&, UnsafeGraphContext& context)
                                    {
                                        context.cmd.CopyBuffer(from, to);
                                        if (!isCompute)
                                        {
                                            context.cmd.SetBufferData(from, numbers);
                                        }
                                    });
                            }
                            auto builder = graph.AddComputePass<PassData>("Set", data);
                            uncullable(builder);
                            builder.SetRenderFunc([&](PassData&, ComputeGraphContext& context)
                                                  { context.cmd.SetBufferData(from, numbers); });
                        }),
                    HasSubstr("this frame uses"));
    }
}

void ExpectOneWayOfEachPass()
{
    for (const bool compatibilityMode : {false, true})
    {
        RecordedPass pass([](RenderGraph&, ContextContainer&) {});
        Render(pass, compatibilityMode);
        EXPECT_EQ(pass.recorded, compatibilityMode ? 0 : 1);
        EXPECT_EQ(pass.executed, compatibilityMode ? 1 : 0);
    }
}

void ExpectResourcesByFunctions()
{
    RenderGraphOf(
        [](RenderGraph& graph, ContextContainer& frameData)
        {
            auto& resources = frameData.Get<UniversalResourceData>();
            EXPECT_FALSE(resources.isActiveTargetBackBuffer());
            EXPECT_TRUE(resources.activeColorTexture().IsValid());
            EXPECT_TRUE(resources.activeDepthTexture().IsValid());
            EXPECT_EQ(resources.activeColorTexture(), resources.cameraColor);
            EXPECT_EQ(resources.activeColorTexture().rt()->width(), 8);
            const TextureHandle before = resources.cameraColor;
            resources.cameraColor = graph.CreateTexture(Desc("_Swapped"));
            EXPECT_NE(resources.activeColorTexture(), before);
            resources.cameraColor = before;
            const TextureHandle motionVectorColor; // what a port writes: an empty handle
            EXPECT_FALSE(motionVectorColor.IsValid());
        });
}

void ExpectNoEffectOfAsyncCompute()
{
    int ran = 0;
    RenderGraphOf(
        [&](RenderGraph& graph, ContextContainer&)
        {
            PassData* data = nullptr;
            auto builder = graph.AddComputePass<PassData>("Kernels", data);
            builder.EnableAsyncCompute(true);
            builder.AllowPassCulling(false);
            builder.SetRenderFunc([&ran](PassData&, ComputeGraphContext&) { ++ran; });
        });
    EXPECT_EQ(ran, 1);
}

} // namespace

DiffersChecks GraphDiffers()
{
    const auto builders = {"IRasterRenderGraphBuilder", "IUnsafeRenderGraphBuilder"};
    std::vector<std::string> declared =
        OfEach(builders, {"AllowGlobalStateModification", "UseTexture", "UseGlobalTexture"});
    std::vector<std::string> done =
        OfEach(builders, {"UseAllGlobalTextures", "SetGlobalTextureAfterPass"});
    done.push_back("IRasterRenderGraphBuilder.SetRenderAttachmentDepth");
    std::vector<std::string> noted = OfEach(builders, {"AllowPassCulling", "EnableAsyncCompute"});
    noted.push_back("IRasterRenderGraphBuilder.SetRenderAttachment");
    std::vector<std::string> built = OfEach(builders, {"SetRenderFunc"});
    built.push_back("RenderGraph.AddRasterRenderPass");
    built.push_back("RenderGraph.AddUnsafePass");
    std::vector<std::string> lists = OfEach(builders, {"UseRendererList"});
    lists.push_back("RendererListParams.cullingResults");
    lists.push_back("UniversalRenderingData.cullResults");
    return {{built, ExpectABuilderAndDataThatIsAPointer},
            {declared, ExpectASentenceForWhatIsNotDeclared},
            {noted, ExpectANoteForWhatIsDeclaredForNothing},
            {done, ExpectWhatIsDeclaredToBeDone},
            {lists, ExpectRendererListsToBeDeclared},
            {OfEach({"RasterCommandBuffer", "UnsafeCommandBuffer"},
                    {"SetViewport", "EnableScissorRect", "DrawRenderer", "DrawMeshInstanced"}),
             ExpectDrawsAsOfACommandBuffer},
            {OfEach({"ComputeCommandBuffer", "UnsafeCommandBuffer"}, {"SetBufferData"}),
             ExpectASentenceForABufferThatThePassBeforeUses},
            {{"ScriptableRenderPass.RecordRenderGraph"}, ExpectOneWayOfEachPass},
            {Members("UniversalResourceData",
                     {"activeColorTexture", "activeDepthTexture", "isActiveTargetBackBuffer",
                      "motionVectorColor", "motionVectorDepth"}),
             ExpectResourcesByFunctions},
            {{"IComputeRenderGraphBuilder.EnableAsyncCompute"}, ExpectNoEffectOfAsyncCompute}};
}

} // namespace limn::test

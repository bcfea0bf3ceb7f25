#include "pipeline/RendererHarness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "pipeline/PipelineTest.h"
#include "renderers/DrawHarness.h"

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

/// Writes down the end of a stack as well.
class StackPass final : public LoggingPass
{
public:
    using LoggingPass::LoggingPass;
    void OnFinishCameraStackRendering(CommandBuffer&) override
    {
        Write("OnFinishCameraStackRendering");
    }
};

/// A camera that sees a cube of layer 0, and overlays that see one of layer 1.
class CameraStack : public PipelineTest<>
{
protected:
    CameraStack() : PipelineTest(64, 32)
    {
        AddCube(m_Scene, "first", {0, 0, 10}, {m_Opaque});
        AddCube(m_Scene, "second", {0, 0, 20}, {m_Opaque}).layer = 1;
        m_Camera.cullingMask = LayerMask::FromIndex(0);
        m_Request.compile.leavesOut = false;
    }

    Camera& AddOverlay()
    {
        auto overlay = std::make_shared<Camera>();
        overlay->renderType = CameraRenderType::Overlay;
        overlay->cullingMask = LayerMask::FromIndex(1);
        m_Camera.cameraStack.push_back(overlay);
        return *overlay;
    }

    static std::vector<std::string> ReportedPasses(const RenderResult& result)
    {
        std::vector<std::string> names;
        for (const ExecutedPassReport& pass : result.report.passes)
        {
            names.push_back(pass.name.name());
        }
        return names;
    }

    static std::vector<std::string> DrawsAndClears(const CompiledRenderPass& pass)
    {
        std::vector<std::string> commands;
        for (const PassCommand& command : pass.commands)
        {
            if (const auto* clear = std::get_if<ClearCommand>(&command))
            {
                const bool isDepth = Only(clear->flags, ClearFlag::Color) == ClearFlag::None;
                commands.emplace_back(isDepth ? "clear depth" : "clear colour");
            }
            else if (std::holds_alternative<DrawCommand>(command))
            {
                commands.emplace_back("draw");
            }
        }
        return commands;
    }

    const std::shared_ptr<Material> m_Opaque =
        std::make_shared<Material>(ShaderWithProgram("", "float4 _Value;", "_Value"));
};

//   base, depth cleared, overlay ─▶ _CameraColorAttachmentA ─▶ Final Blit
TEST_F(CameraStack, DrawsAnOverlayOntoTheColourOfItsBaseAndCopiesOnce)
{
    AddOverlay();
    const RenderResult result = Render();
    EXPECT_THAT(ReportedPasses(result),
                ElementsAre("Draw Opaque Objects", "Draw Transparent Objects",
                            "Draw Opaque Objects", "Draw Transparent Objects", "Final Blit"));
    ASSERT_EQ(result.frame->passes.size(), 2u) << "nothing comes between the cameras";
    const CompiledRenderPass& scene = result.frame->passes[0];
    ASSERT_EQ(scene.colors.size(), 1u);
    EXPECT_EQ(scene.colors[0].load, LoadOp::Clear);
    EXPECT_EQ(scene.colors[0].store, StoreOp::Store);
    ASSERT_TRUE(scene.depth);
    EXPECT_EQ(scene.depth->load, LoadOp::Clear);
    EXPECT_THAT(DrawsAndClears(scene), ElementsAre("draw", "clear depth", "draw"));
    EXPECT_EQ(result.frame->passes[1].name, "Final Blit");
}

TEST_F(CameraStack, KeepsTheDepthForAnOverlayThatDoesNotClearIt)
{
    AddOverlay().clearDepth = false;
    const RenderResult result = Render();
    ASSERT_EQ(result.frame->passes.size(), 2u);
    EXPECT_THAT(DrawsAndClears(result.frame->passes[0]), ElementsAre("draw", "draw"));
}

TEST_F(CameraStack, TellsFeaturesOfEachCameraWhatItIs)
{
    std::vector<CameraData> seen;
    m_Renderer.AddFeature(std::make_unique<CamerasReader>(seen));
    m_Camera.allowHDR = false;
    m_Camera.cameraType = CameraType::SceneView;
    m_Camera.renderPostProcessing = false;
    Camera& first = AddOverlay();
    first.clearDepth = false;
    first.fieldOfView = 20.0f;
    AddOverlay().antialiasing = AntialiasingMode::None;
    m_Camera.antialiasing = AntialiasingMode::FastApproximateAntialiasing;
    Render();
    ASSERT_EQ(seen.size(), 3u);
    const auto members = [&](auto member)
    {
        std::vector<int> values;
        for (const CameraData& data : seen)
        {
            values.push_back(static_cast<int>(data.*member));
        }
        return values;
    };
    EXPECT_THAT(members(&CameraData::renderType), ElementsAre(0, 1, 1));
    EXPECT_THAT(members(&CameraData::clearDepth), ElementsAre(1, 0, 1));
    EXPECT_THAT(members(&CameraData::resolveFinalTarget), ElementsAre(0, 0, 1));
    EXPECT_THAT(members(&CameraData::postProcessEnabled), ElementsAre(0, 1, 1));
    EXPECT_THAT(members(&CameraData::antialiasing), ElementsAre(1, 1, 1));
    EXPECT_THAT(members(&CameraData::isHdrEnabled), ElementsAre(0, 0, 0));
    EXPECT_THAT(members(&CameraData::cameraType), ElementsAre(2, 2, 2));
    EXPECT_EQ(seen[1].camera, &first);
    EXPECT_EQ(seen[1].cameraTargetDescriptor, seen[0].cameraTargetDescriptor);
    EXPECT_EQ(seen[1].gpuProjectionMatrix, WithFlippedY(first.gpuProjectionMatrix(2.0f)));
}

TEST_F(CameraStack, RunsFeaturesForEachCameraAndEndsTheStackOnce)
{
    Log log;
    StackPass pass("P", RenderPassEvent::AfterRenderingOpaques, log);
    m_Renderer.AddFeature(
        std::make_unique<LoggingFeature>("F", log, std::vector<ScriptableRenderPass*>{&pass}));
    log.clear(); // Create
    AddOverlay();
    Render();
    EXPECT_THAT(log,
                ElementsAre("F.AddRenderPasses", "F.SetupRenderPasses", "P.OnCameraSetup",
                            "P.Configure", "P.Execute", "P.OnCameraCleanup", "F.AddRenderPasses",
                            "F.SetupRenderPasses", "P.OnCameraSetup", "P.Configure", "P.Execute",
                            "P.OnCameraCleanup", "P.OnFinishCameraStackRendering"));
}

TEST_F(CameraStack, BlendsTheVolumesOfEachCameraBeforeItsFeatures)
{
    std::vector<const Camera*> asked;
    m_Request.blendVolumes = [&](const Camera& camera) -> const VolumeStack*
    {
        asked.push_back(&camera);
        return nullptr;
    };
    const Camera& overlay = AddOverlay();
    Render();
    EXPECT_THAT(asked, ElementsAre(&m_Camera, &overlay));
}

TEST_F(CameraStack, CopiesTheDepthForTheCameraThatReadsItOnly)
{
    const auto reading = std::make_shared<Material>(ShaderWithProgram(
        "", "Texture2D _CameraDepthTexture; SamplerState sampler_CameraDepthTexture;",
        "_CameraDepthTexture.Sample(sampler_CameraDepthTexture, float2(0, 0))"));
    reading->SetRenderQueue(3000);
    GameObject& glass = AddCube(m_Scene, "glass", {0, 0, 5}, {reading});
    AddOverlay();
    const auto countOf = [&]
    {
        const std::vector<std::string> names = ReportedPasses(Render());
        return std::ranges::count_if(names, [](const std::string& name)
                                     { return name == "CopyDepth" || name == "DepthPrepass"; });
    };
    EXPECT_EQ(countOf(), 1) << "read by the base";
    glass.layer = 1;
    EXPECT_EQ(countOf(), 1) << "read by the overlay";
    glass.activeSelf = false;
    EXPECT_EQ(countOf(), 0);
}

TEST_F(CameraStack, IsTheSingleCamerasFrameWhereNothingInItIsAnOverlay)
{
    const RenderResult alone = Render();
    m_Camera.cameraStack.push_back(std::make_shared<Camera>());
    const RenderResult stacked = Render();
    EXPECT_EQ(stacked.frame->passes.size(), alone.frame->passes.size());
    EXPECT_EQ(ReportedPasses(stacked), ReportedPasses(alone));
    EXPECT_THAT(alone.report.notes, IsEmpty());
    EXPECT_THAT(stacked.report.notes,
                ElementsAre(Mentions("camera 1", "cameraStack", "renderType is Base")));
}

TEST_F(CameraStack, DrawsBaseCamerasInTheOrderOfTheirWholeDepths)
{
    std::vector<CameraData> seen;
    m_Renderer.AddFeature(std::make_unique<CamerasReader>(seen));
    Camera one;
    one.depth = 1.9f;
    Camera two;
    two.depth = 1.2f;
    Camera early;
    early.depth = -3.0f;
    Camera overlay;
    overlay.renderType = CameraRenderType::Overlay;
    overlay.depth = -9.0f;
    const Camera* cameras[] = {&one, &two, &overlay, &early};
    const auto results = m_Pipeline.Render(m_Renderer, m_Request, cameras);
    EXPECT_EQ(results.size(), 3u);
    EXPECT_EQ(m_Device.frames().size(), 3u);
    std::vector<const Camera*> order;
    for (const CameraData& data : seen)
    {
        order.push_back(data.camera);
        EXPECT_TRUE(data.resolveFinalTarget);
    }
    EXPECT_THAT(order, ElementsAre(&early, &one, &two));
}

TEST_F(CameraStack, DrawsIntoTheTargetTextureOfTheBaseInItsSizeAndFormat)
{
    const auto target = std::make_shared<const RenderTexture>(
        "mirror", RenderTextureDescriptor(16, 16, GraphicsFormat::R8G8B8A8_UNorm));
    std::vector<CameraData> seen;
    m_Renderer.AddFeature(std::make_unique<CamerasReader>(seen));
    m_Camera.targetTexture = target;
    AddOverlay();
    const RenderResult result = Render();
    EXPECT_EQ(result.output.rt(), target);
    const CompiledRenderPass& last = result.frame->passes.back();
    EXPECT_EQ(last.colors.at(0).texture, target);
    EXPECT_EQ(last.width, 16);
    ASSERT_EQ(seen.size(), 2u);
    for (const CameraData& data : seen)
    {
        EXPECT_EQ(data.targetTexture, target);
        EXPECT_EQ(data.cameraTargetDescriptor,
                  RenderTextureDescriptor(16, 16, GraphicsFormat::R8G8B8A8_UNorm, 32));
    }
    m_Camera.targetTexture = nullptr;
    EXPECT_EQ(Render().output.rt()->name(), "limn_Output");
}

TEST_F(CameraStack, RefusesWhatCannotBeDrawn)
{
    const auto message = [&]
    {
        return ThrownMessage<ContractError>([&] { Render(); });
    };
    m_Camera.renderType = CameraRenderType::Overlay;
    EXPECT_THAT(message(), Mentions("RenderSingleCamera", "renderType is Overlay", "base camera",
                                    "cameraStack"));
    m_Camera.renderType = CameraRenderType::Base;
    m_Camera.cameraStack.push_back(nullptr);
    EXPECT_THAT(message(), Mentions("RenderSingleCamera", "cameraStack", "null"));
    m_Camera.cameraStack.clear();
    m_Camera.targetTexture = std::make_shared<const RenderTexture>(
        "shadows", RenderTextureDescriptor(8, 8, GraphicsFormat::D32_SFloat));
    EXPECT_THAT(message(), Mentions("RenderSingleCamera", "targetTexture 'shadows'",
                                    "depth texture", "colour"));
    const Camera* none[] = {&m_Camera, nullptr};
    EXPECT_THAT(
        ThrownMessage<ContractError>([&] { m_Pipeline.Render(m_Renderer, m_Request, none); }),
        Mentions("Render:", "cameras[1]", "null"));
}

TEST_F(CameraStack, IsCleanedUpWhereItsFirstCameraThrows)
{
    class Throwing final : public LoggingPass
    {
    public:
        using LoggingPass::LoggingPass;
        void Execute(ScriptableRenderContext&, RenderingData&) override
        {
            throw ContractError("no");
        }
        void OnFinishCameraStackRendering(CommandBuffer&) override
        {
            Write("OnFinishCameraStackRendering");
        }
    };
    Log log;
    Throwing pass("P", RenderPassEvent::AfterRenderingOpaques, log);
    m_Renderer.AddFeature(
        std::make_unique<LoggingFeature>("F", log, std::vector<ScriptableRenderPass*>{&pass}));
    AddOverlay();
    EXPECT_THROW(Render(), ContractError);
    EXPECT_EQ(log.back(), "P.OnFinishCameraStackRendering");
}

} // namespace
} // namespace limn::test

#include "port/Differs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/CurrentCamera.h>
#include <limn/core/RecordingDevice.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;

constexpr GraphicsFormat k_TargetFormat = GraphicsFormat::R8G8B8A8_UNorm;

class DiffersComponent final : public VolumeComponent
{
public:
    FloatParameter width{this, "m_Width", 2.0f};
};

/// Draws into a target of its own, and looks at its renderer meanwhile.
class LookingPass final : public ScriptableRenderPass
{
public:
    LookingPass() { ConfigureTarget(m_Target); }
    void Execute(ScriptableRenderContext& context, RenderingData& data) override
    {
        const ScriptableRenderer& renderer = *data.cameraData.renderer;
        EXPECT_TRUE(renderer.cameraColorTargetHandle().rt());
        EXPECT_TRUE(renderer.cameraDepthTargetHandle().rt());
        EXPECT_EQ(renderer.cameraColorTarget(),
                  RenderTargetIdentifier(BuiltinRenderTextureType::CameraColor));
        EXPECT_EQ(renderer.cameraDepthTarget(), renderer.cameraDepthTargetHandle().nameID());
        EXPECT_EQ(renderer.rendererFeatures().size(), 1u);
        EXPECT_EQ(data.cameraData.aspectRatio, 2.0f);
        EXPECT_EQ(data.cameraData.pixelWidth, 8);
        EXPECT_EQ(data.cameraData.pixelHeight, 4);
        EXPECT_EQ(data.cameraData.cameraTargetDescriptor.width, 4) << "of renderScale 0.5";
        EXPECT_EQ(data.cameraData.cameraTargetDescriptor.height, 2);
        EXPECT_EQ(data.volumeStack->GetComponent<DiffersComponent>()->width.value(), 2.0f)
            << "the stack is the renderingData's";
        const auto cmd = CommandBufferPool::Get();
        CoreUtils::DrawFullScreen(*cmd, std::make_shared<const Material>(DiffersShader()));
        context.ExecuteCommandBuffer(*cmd);
    }

private:
    const RTHandle m_Target = RTHandles::Alloc(RenderTextureDescriptor(8, 4, k_TargetFormat));
};

class LookingFeature final : public ScriptableRendererFeature
{
public:
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(pass);
    }
    LookingPass pass;
};

RenderResult RenderLooking()
{
    static RecordingDevice device;
    UniversalRenderPipeline pipeline(device);
    pipeline.renderScale = 0.5f;
    UniversalRenderer renderer(DiffersCompiler());
    renderer.AddFeature(std::make_unique<LookingFeature>());
    Scene scene;
    Camera camera;
    RenderRequest request;
    request.scene = &scene;
    request.camera = &camera;
    request.width = 8;
    request.height = 4;
    request.compile.leavesOut = false;
    return pipeline.RenderSingleCamera(renderer, request);
}

void ExpectPassesCalledAfterTheirClass()
{
    const RenderResult result = RenderLooking();
    const auto isLooking = [](const ExecutedPassReport& pass)
    {
        return pass.name.name() == "LookingPass";
    };
    EXPECT_TRUE(std::ranges::any_of(result.report.passes, isLooking));
}

void ExpectARendererToHaveItsTargetsWhileItRenders()
{
    RenderLooking(); // the pass looks
}

void ExpectACamerasPictureToBeTheFrames()
{
    RenderLooking(); // the pass looks
}

void ExpectWhatAPassConfiguresByFunctions()
{
    LookingPass pass;
    const RTHandle a = RTHandles::Alloc(RenderTextureDescriptor(8, 4, k_TargetFormat));
    const RTHandle b = RTHandles::Alloc(RenderTextureDescriptor(8, 4, k_TargetFormat));
    const RTHandle depth =
        RTHandles::Alloc(RenderTextureDescriptor(8, 4, GraphicsFormat::None, 32));
    pass.ConfigureTarget(std::vector{a, b}, depth);
    pass.ConfigureClear(ClearFlag::Color, Color::white);
    pass.ConfigureInput(ScriptableRenderPassInput::Depth);
    EXPECT_EQ(pass.colorAttachmentHandle(), a);
    EXPECT_THAT(pass.colorAttachmentHandles(), ElementsAre(a, b));
    EXPECT_EQ(pass.depthAttachmentHandle(), depth);
    EXPECT_EQ(pass.clearFlag(), ClearFlag::Color);
    EXPECT_EQ(pass.clearColor(), Color::white);
    EXPECT_EQ(pass.input(), ScriptableRenderPassInput::Depth);
    // Are taken, and change none of that.
    pass.ConfigureColorStoreAction(RenderBufferStoreAction::DontCare);
    pass.ConfigureDepthStoreAction(RenderBufferStoreAction::DontCare);
    EXPECT_THAT(pass.colorAttachmentHandles(), ElementsAre(a, b));
}

class PeekingRenderer final : public ScriptableRenderer
{
public:
    using ScriptableRenderer::activeRenderPassQueue;

private:
    void Setup(ScriptableRenderContext&, RenderingData&) override {}
};

void ExpectTheQueueOfPassesByAFunction()
{
    PeekingRenderer renderer;
    LookingPass pass;
    EXPECT_TRUE(renderer.activeRenderPassQueue().empty());
    renderer.EnqueuePass(pass);
    EXPECT_THAT(renderer.activeRenderPassQueue(), ElementsAre(&pass));
}

template <typename Pass>
concept AsksForAnIntermediateTexture = requires(Pass& pass)
{
    pass.requiresIntermediateTexture;
};

void ExpectNothingToAskForAnIntermediateTexture()
{
    EXPECT_FALSE(AsksForAnIntermediateTexture<ScriptableRenderPass>);
    RenderLooking(); // its targets are textures all the same
}

void ExpectAFeatureToBeSwitchedByAFunction()
{
    LookingFeature feature;
    EXPECT_TRUE(feature.isActive());
    feature.SetActive(false);
    EXPECT_FALSE(feature.isActive());
}

void ExpectAFilterThatMatchesAll()
{
    const FilteringSettings all;
    EXPECT_EQ(all.renderQueueRange, RenderQueueRange::all);
    EXPECT_EQ(all.layerMask, LayerMask::Everything());
    EXPECT_EQ(RenderQueueRange::opaque.lowerBound(), 0);
    EXPECT_EQ(RenderQueueRange::opaque.upperBound(), 2500);
}

void ExpectParametersByFunctions()
{
    DiffersComponent component;
    EXPECT_EQ(component.width.value(), 2.0f);
    EXPECT_FALSE(component.width.overrideState());
    component.width.SetValue(3.0f);
    EXPECT_EQ(component.width.value(), 3.0f);
    EXPECT_FALSE(component.width.overrideState());
    component.width.SetOverrideState(true);
    EXPECT_TRUE(component.width.overrideState());
}

/// Counts who lives: a constructor in place of OnEnable, a destructor in place of OnDisable.
struct LivingComponent final : VolumeComponent
{
    LivingComponent() { ++living; }
    ~LivingComponent() override { --living; }
    static inline int living = 0;
};

void ExpectComponentsAndStacksToGoByThemselves()
{
    VolumeComponentRegistry registry;
    registry.Register<LivingComponent>("Living");
    VolumeManager volumes(registry); // there is none but those that are made
    const int before = LivingComponent::living;
    {
        VolumeStack stack = volumes.CreateStack();
        EXPECT_EQ(LivingComponent::living, before + 1);
        EXPECT_NE(stack.GetComponent<LivingComponent>(), nullptr);
    }
    EXPECT_EQ(LivingComponent::living, before);
}

class ParameterComponent final : public VolumeComponent
{
public:
    FloatParameter width{this, "width", 1.0f};
};

void ExpectTheStackOfTheCameraThatIsRendered()
{
    VolumeComponentRegistry registry;
    registry.Register<ParameterComponent>("Parameter");
    VolumeManager volumes(registry);
    const VolumeStack stack = volumes.CreateStack();
    RenderingData data;
    data.volumeStack = &stack;
    {
        const CurrentCamera camera(data);
        EXPECT_EQ(VolumeManager::stack()->GetComponent<ParameterComponent>(),
                  stack.GetComponent<ParameterComponent>());
    }
    EXPECT_EQ(&*VolumeManager::stack(), &VolumeStack::Defaults());
    EXPECT_EQ(&*VolumeManager::instance().stack(), &VolumeStack::Defaults());
    ParameterComponent component;
    ASSERT_EQ(component.parameters().size(), 1u);
    EXPECT_EQ(component.parameters()[0], &component.width);
}

template <typename Renderer>
concept Executes = requires(Renderer& renderer, ScriptableRenderContext& context,
                            RenderingData& data)
{
    renderer.Execute(context, data);
};
template <typename Renderer>
concept SetsUp = requires(Renderer& renderer, ScriptableRenderContext& context, RenderingData& data)
{
    renderer.Setup(context, data);
};
template <typename Renderer>
concept ConfiguresTarget = requires(Renderer& renderer)
{
    renderer.ConfigureCameraTarget(RTHandle(), RTHandle());
};

void ExpectARendererThatIsLeftToThePipeline()
{
    EXPECT_FALSE(Executes<ScriptableRenderer>);
    EXPECT_FALSE(SetsUp<ScriptableRenderer>);
    EXPECT_FALSE(ConfiguresTarget<ScriptableRenderer>);
}

void ExpectASamplersNameByAFunction()
{
    EXPECT_EQ(ProfilingSampler("Blur").name(), "Blur");
}

} // namespace

DiffersChecks PipelineDiffers()
{
    return {{{"ScriptableRenderPass.profilingSampler"}, ExpectPassesCalledAfterTheirClass},
            {Members("ScriptableRenderer",
                     {"cameraColorTarget", "cameraColorTargetHandle", "cameraDepthTarget",
                      "cameraDepthTargetHandle", "rendererFeatures"}),
             ExpectARendererToHaveItsTargetsWhileItRenders},
            {Members("Camera", {"aspect", "pixelWidth", "pixelHeight", "scaledPixelWidth",
                                "scaledPixelHeight"}),
             ExpectACamerasPictureToBeTheFrames},
            {Members("ScriptableRenderPass",
                     {"clearColor", "clearFlag", "colorAttachmentHandle", "colorAttachmentHandles",
                      "depthAttachmentHandle", "input", "ConfigureTarget",
                      "ConfigureColorStoreAction", "ConfigureDepthStoreAction"}),
             ExpectWhatAPassConfiguresByFunctions},
            {{"ScriptableRenderer.activeRenderPassQueue"}, ExpectTheQueueOfPassesByAFunction},
            {{"ScriptableRenderPass.requiresIntermediateTexture"},
             ExpectNothingToAskForAnIntermediateTexture},
            {{"ScriptableRendererFeature.isActive"}, ExpectAFeatureToBeSwitchedByAFunction},
            {{"FilteringSettings.defaultValue", "RenderQueueRange.lowerBound",
              "RenderQueueRange.upperBound"},
             ExpectAFilterThatMatchesAll},
            {Members("VolumeParameter", {"value", "overrideState", "GetValue"}),
             ExpectParametersByFunctions},
            {{"VolumeComponent.OnEnable", "VolumeComponent.OnDisable", "VolumeStack.Dispose",
              "VolumeStack.GetComponent", "VolumeManager.instance"},
             ExpectComponentsAndStacksToGoByThemselves},
            {{"VolumeManager.stack", "VolumeComponent.parameters"},
             ExpectTheStackOfTheCameraThatIsRendered},
            {Members("ScriptableRenderer", {"ConfigureCameraTarget", "Setup", "Execute"}),
             ExpectARendererThatIsLeftToThePipeline},
            {{"ProfilingSampler.name"}, ExpectASamplersNameByAFunction}};
}

} // namespace limn::test

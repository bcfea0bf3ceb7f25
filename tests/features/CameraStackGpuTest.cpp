#include "features/color_edges/PictureRun.h"
#include "vulkan/GpuTestFrame.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

constexpr int k_StackSide = 16;
const glm::vec3 k_BaseColor{0.75f, 0.0f, 0.0f};
const glm::vec3 k_OverlayColor{0.0f, 0.5f, 0.0f};

/// 1 minus the camera's colour, of base cameras.
class InvertingFeature final : public ScriptableRendererFeature
{
public:
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& data) override
    {
        if (data.cameraData.renderType == CameraRenderType::Base)
        {
            renderer.EnqueuePass(m_Pass);
        }
    }

private:
    class Pass final : public ScriptableRenderPass
    {
    public:
        Pass() { renderPassEvent = RenderPassEvent::AfterRenderingPostProcessing; }
        void Execute(ScriptableRenderContext& context, RenderingData& data) override
        {
            const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
            Blit(*cmd, data, m_Material);
            context.ExecuteCommandBuffer(*cmd);
        }

    private:
        std::shared_ptr<Material> m_Material = std::make_shared<Material>(ShaderOf(
            "Shader \"Test/Invert\" { SubShader { Pass { ZTest Always ZWrite Off Cull Off\n"
            "HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n#include "
            "\"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n#include "
            "\"Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl\"\n"
            "float4 Frag(Varyings i) : SV_Target { return float4(1 - SAMPLE_TEXTURE2D_X("
            "_BlitTexture, sampler_PointClamp, i.texcoord).rgb, 1); }\nENDHLSL\n} } }"));
    };
    Pass m_Pass;
};

/// A red rectangle of the base at 5 m, and a green one of the overlay's further away. They overlap.
class CameraStackGpu : public GpuTest
{
protected:
    CameraStackGpu() : m_Flat(k_StackSide, k_StackSide)
    {
        m_Flat.Add({2, 2}, {10, 10}, 5.0f, Plain(k_BaseColor));
        m_Flat.Add({6, 6}, {14, 14}, 8.0f, Plain(k_OverlayColor)).layer = 1;
        m_Flat.camera.cullingMask = LayerMask::FromIndex(0);
        m_Flat.camera.backgroundColor = Color(0.0f, 0.0f, 1.0f, 1.0f);
        m_Overlay->orthographic = true;
        m_Overlay->orthographicSize = m_Flat.camera.orthographicSize;
        m_Overlay->nearClipPlane = m_Flat.camera.nearClipPlane;
        m_Overlay->farClipPlane = m_Flat.camera.farClipPlane;
        m_Overlay->cullingMask = LayerMask::FromIndex(1);
        m_Overlay->renderType = CameraRenderType::Overlay;
        m_Flat.camera.cameraStack.push_back(m_Overlay);
        m_Request.scene = &m_Flat.scene;
        m_Request.camera = &m_Flat.camera;
        m_Request.width = k_StackSide;
        m_Request.height = k_StackSide;
    }

    /// The output, twice over: every frame gives the same.
    /// @param leavesOut  what the frame compiler may do
    Image Draw(bool leavesOut)
    {
        m_Request.compile.leavesOut = leavesOut;
        m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        const RenderResult result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        return SharedDevice().ReadBack(*result.output.rt());
    }

    static bool IsIn(int x, int y, int low, int high)
    {
        return x >= low && x < high && y >= low && y < high;
    }
    static int Encoded(float linear)
    {
        const double x = static_cast<double>(linear);
        const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
        return static_cast<int>(std::lround(255.0 * encoded));
    }

    /// @param wanted  linear, by x and y
    template <typename Wanted>
    void ExpectPicture(Wanted&& wanted)
    {
        for (const bool leavesOut : {false, true})
        {
            const Image picture = Draw(leavesOut);
            for (int y = 0; y < k_StackSide; ++y)
            {
                for (int x = 0; x < k_StackSide; ++x)
                {
                    const glm::vec3 color = wanted(x, y);
                    const Rgba8 texel = Texel8(picture, x, y);
                    for (int channel = 0; channel < 3; ++channel)
                    {
                        ASSERT_NEAR(texel[static_cast<std::size_t>(channel)],
                                    Encoded(color[channel]), 1)
                            << x << ", " << y << ", channel " << channel << ", leavesOut "
                            << leavesOut;
                    }
                }
            }
        }
    }

    /// @param samples  a texel of the texture between the cameras
    void ExpectALaterCameraToReadTheTarget(int samples, bool allowMSAA)
    {
        const SamplerState point{FilterMode::Point, TextureWrapMode::Clamp, TextureWrapMode::Clamp,
                                 TextureWrapMode::Clamp, false};
        RenderTextureDescriptor descriptor(k_StackSide / 2, k_StackSide / 2,
                                           GraphicsFormat::R8G8B8A8_SRGB);
        descriptor.msaaSamples = samples;
        const auto mirror = std::make_shared<const RenderTexture>("mirror", descriptor, point);
        Camera seen = m_Flat.camera; // with its overlay
        seen.targetTexture = mirror;
        seen.allowMSAA = allowMSAA;
        seen.depth = -1.0f;
        const std::shared_ptr<Material> screen = Plain({1.0f, 1.0f, 1.0f});
        screen->SetTexture(ShaderPropertyId("_BaseMap"), mirror);
        m_Flat.Add({0, 0}, {k_StackSide, k_StackSide}, 9.0f, screen).layer = 2;
        Camera last = m_Flat.camera;
        last.cameraStack.clear();
        last.cullingMask = LayerMask::FromIndex(2);

        const Camera* cameras[] = {&last, &seen};
        for (int frame = 0; frame < 3; ++frame)
        {
            const auto results = m_Pipeline.Render(m_Renderer, m_Request, cameras);
            ASSERT_EQ(results.size(), 2u);
            EXPECT_EQ(results[0].output.rt(), mirror);
            const Image picture = SharedDevice().ReadBack(*results[1].output.rt());
            for (int y = 0; y < k_StackSide; ++y)
            {
                for (int x = 0; x < k_StackSide; ++x)
                {
                    // The mirror's texels are 2 x 2 of the picture's, and of the scene's: all edges
                    // are at even places.
                    const bool isRed = IsIn(x, y, 2, 10);
                    const glm::vec3 color = IsIn(x, y, 6, 14) ? k_OverlayColor
                                            : isRed           ? k_BaseColor
                                                              : glm::vec3(0, 0, 1);
                    const Rgba8 texel = Texel8(picture, x, y);
                    for (int channel = 0; channel < 3; ++channel)
                    {
                        ASSERT_NEAR(texel[static_cast<std::size_t>(channel)],
                                    Encoded(color[channel]), 1)
                            << x << ", " << y << ", frame " << frame;
                    }
                }
            }
        }
    }

    FlatScene m_Flat;
    const std::shared_ptr<Camera> m_Overlay = std::make_shared<Camera>();
    UniversalRenderPipeline m_Pipeline{SharedDevice()};
    UniversalRenderer m_Renderer{Compiler()};
    RenderRequest m_Request;
};

TEST_F(CameraStackGpu, AnOverlayIsInFrontOfAllThatTheBaseDrew)
{
    ExpectPicture(
        [](int x, int y)
        {
            const bool isRed = IsIn(x, y, 2, 10);
            return IsIn(x, y, 6, 14) ? k_OverlayColor : isRed ? k_BaseColor : glm::vec3(0, 0, 1);
        });
}

TEST_F(CameraStackGpu, AnOverlayThatKeepsTheDepthIsHiddenByWhatIsNearer)
{
    m_Overlay->clearDepth = false;
    ExpectPicture(
        [](int x, int y)
        {
            const bool isGreen = IsIn(x, y, 6, 14);
            return IsIn(x, y, 2, 10) ? k_BaseColor : isGreen ? k_OverlayColor : glm::vec3(0, 0, 1);
        });
}

TEST_F(CameraStackGpu, AnOverlayGoesOnWithTheColourThatABlitOfTheBaseLeft)
{
    m_Renderer.AddFeature(std::make_unique<InvertingFeature>());
    ExpectPicture(
        [](int x, int y)
        {
            const glm::vec3 base = IsIn(x, y, 2, 10) ? k_BaseColor : glm::vec3(0, 0, 1);
            return IsIn(x, y, 6, 14) ? k_OverlayColor : 1.0f - base;
        });
}

TEST_F(CameraStackGpu, SeveralSamplesATexelAreKeptFromCameraToCamera)
{
    m_Pipeline.msaaSampleCount = 4;
    m_Overlay->clearDepth = false;
    ExpectPicture(
        [](int x, int y)
        {
            const bool isGreen = IsIn(x, y, 6, 14);
            return IsIn(x, y, 2, 10) ? k_BaseColor : isGreen ? k_OverlayColor : glm::vec3(0, 0, 1);
        });
}

TEST_F(CameraStackGpu, CamerasFarFromEachOtherAreDrawnAtTheirPlaces)
{
    m_Flat.camera.transform.localPosition = {4096.0f, 0.0f, 0.0f};
    m_Flat.scene.objects()[0]->transform.localPosition.x += 4096.0f;
    ExpectPicture(
        [](int x, int y)
        {
            const bool isRed = IsIn(x, y, 2, 10);
            return IsIn(x, y, 6, 14) ? k_OverlayColor : isRed ? k_BaseColor : glm::vec3(0, 0, 1);
        });
}

TEST_F(CameraStackGpu, AnOverlayHasTheLightsThatItSeesItself)
{
    m_Flat.scene.mainLight.intensity = 0.0f;
    m_Flat.scene.ambientLight = Color::black;
    const auto lit = std::make_shared<Material>(FindBuiltinShader("Limn/Half Lambert", Compiler()));
    m_Flat.scene.objects()[1]->renderer->sharedMaterials = {lit};
    Light light; // in the base's view only
    light.type = LightType::Point;
    light.transform.localPosition = {0.0f, 0.0f, 4.0f};
    light.range = 3.9f;
    light.intensity = 5.0f;
    m_Flat.scene.additionalLights = {light};
    const glm::vec3 away{100.0f, 0.0f, 0.0f};
    m_Overlay->transform.localPosition = away;
    m_Flat.scene.objects()[1]->transform.localPosition += away;
    ExpectPicture(
        [](int x, int y)
        {
            const bool isRed = IsIn(x, y, 2, 10);
            return IsIn(x, y, 6, 14) ? glm::vec3(0) : isRed ? k_BaseColor : glm::vec3(0, 0, 1);
        });
}

TEST_F(CameraStackGpu, ALaterCameraReadsTheTargetTextureOfAnEarlierOne)
{
    ExpectALaterCameraToReadTheTarget(1, true);
}

TEST_F(CameraStackGpu, ATargetTextureOfSeveralSamplesIsDrawnWithThem)
{
    m_Pipeline.msaaSampleCount = 4;
    ExpectALaterCameraToReadTheTarget(4, true);
}

TEST_F(CameraStackGpu, ATargetTextureOfSeveralSamplesIsDrawnWithOneWhereTheCameraAllowsNoMore)
{
    m_Pipeline.msaaSampleCount = 4;
    ExpectALaterCameraToReadTheTarget(4, false);
}

} // namespace
} // namespace limn::test

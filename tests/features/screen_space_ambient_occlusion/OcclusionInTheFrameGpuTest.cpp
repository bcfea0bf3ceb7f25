#include "OcclusionScene.h"
#include "golden/GoldenImage.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

/// A floor and some boxes, whose picture shows what their shaders are told.
OcclusionScene Boxes(int width = 64, int height = 48)
{
    OcclusionScene scene(width, height, {0.5f, 2.0f, -6.0f}, 8.0f);
    scene.AddBoxes();
    scene.camera.backgroundColor = Color(1.0f, 0.0f, 1.0f, 1.0f);
    return scene;
}

SsaoSettings Strong()
{
    SsaoSettings settings;
    settings.Radius = 0.6f;
    settings.DirectLightingStrength = 0.25f;
    return settings;
}

class OcclusionInTheFrameGpu : public GpuTest
{
};

TEST_F(OcclusionInTheFrameGpu, DarkensIndirectLightByItsTextureAndDirectLightByAPartOfIt)
{
    for (const float strength : {0.0f, 0.25f, 1.0f})
    {
        const OcclusionScene scene = Boxes();
        SsaoSettings settings = Strong();
        settings.DirectLightingStrength = strength;
        OcclusionRun run(scene, settings);
        const Field left = run.Left();
        const Field picture = run.Color();
        for (int y = 0; y < scene.height; ++y)
        {
            for (int x = 0; x < scene.width; ++x)
            {
                if (scene.Cast(scene.RayThrough(x + 0.5, y + 0.5)) && picture.At(x, y, 2) == 0.0)
                {
                    const double light = left.At(x, y);
                    ASSERT_NEAR(picture.At(x, y, 0), light, 1e-3);
                    const double part = static_cast<double>(strength);
                    ASSERT_NEAR(picture.At(x, y, 1), 1.0 - part * (1.0 - light), 1e-3);
                }
            }
        }
        EXPECT_LT(Least(left), 0.6);
    }
}

TEST_F(OcclusionInTheFrameGpu, IsDarkAtTheFeetOfBoxesAndLightOnOpenGround)
{
    const OcclusionScene scene = Boxes(128, 96);
    for (const bool downsample : {false, true})
    {
        for (const SsaoBlur blur : {SsaoBlur::High, SsaoBlur::Medium, SsaoBlur::Low})
        {
            SsaoSettings settings = Strong();
            settings.Downsample = downsample;
            settings.BlurQuality = blur;
            OcclusionRun run(scene, settings);
            const Field left = run.Left();
            const auto at = [&](const glm::dvec3& place)
            {
                const glm::dvec2 pixel = scene.PixelOf(place);
                return left.At(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
            };
            EXPECT_LT(at({-2.5, 0.02, -0.03}), 0.75); // just before the first box
            EXPECT_GE(at({0.5, 0.0, -2.5}), 1.0 - 1.0 / 255.0);
            EXPECT_GE(at({-2.5, 1.2, 0.0}), 1.0 - 1.0 / 255.0); // the middle of its front
        }
    }
}

TEST_F(OcclusionInTheFrameGpu, LooksLikeTheGoldenOfClay)
{
    OcclusionScene scene = Boxes(320, 180);
    for (const auto& object : scene.scene.objects())
    {
        object->renderer->sharedMaterials = {Plain({0.8f, 0.75f, 0.7f})};
    }
    scene.camera.backgroundColor = Color(0.3f, 0.45f, 0.6f, 1.0f);
    SsaoSettings settings = Strong();
    settings.Intensity = 1.5f;
    settings.AfterOpaque = true;
    settings.Samples = SsaoSamples::High;
    OcclusionRun run(scene, settings);
    run.Render(nullptr);
    ExpectGolden("ambient_occlusion", SharedDevice().ReadBack(*run.result().output.rt()),
                 HasCoarseCorners());
}

TEST_F(OcclusionInTheFrameGpu, AfterOpaqueMultipliesThePictureAndLeavesShadersAndSkyAlone)
{
    for (const SsaoBlur blur : {SsaoBlur::High, SsaoBlur::Medium, SsaoBlur::Low})
    {
        for (const int samples : {1, 4})
        {
            const OcclusionScene scene = Boxes();
            SsaoSettings settings = Strong();
            settings.BlurQuality = blur;
            OcclusionRun before(scene, settings);
            before.SetSamples(samples);
            const Field left = before.Left();
            settings.AfterOpaque = true;
            OcclusionRun run(scene, settings);
            run.SetSamples(samples);
            const Field picture = run.Color(nullptr);
            int dark = 0;
            int sky = 0;
            for (int y = 0; y < scene.height; ++y)
            {
                for (int x = 0; x < scene.width; ++x)
                {
                    const double blue = picture.At(x, y, 2); // 1 of the sky only
                    if (blue == 0.0)
                    {
                        // The shaders' 1, once multiplied
                        EXPECT_NEAR(picture.At(x, y, 0), left.At(x, y), 1.0 / 255.0);
                        EXPECT_NEAR(picture.At(x, y, 1), left.At(x, y), 1.0 / 255.0);
                        dark += left.At(x, y) < 0.9 ? 1 : 0;
                    }
                    else if (picture.At(x, y, 1) == 0.0)
                    {
                        EXPECT_EQ(picture.At(x, y, 0), 1.0);
                        EXPECT_EQ(blue, 1.0);
                        ++sky;
                    }
                    EXPECT_EQ(picture.At(x, y, 3), 1.0);
                }
            }
            EXPECT_GT(dark, 50);
            EXPECT_GT(sky, 300);
        }
    }
}

TEST_F(OcclusionInTheFrameGpu, IsOffForACameraWhoseRendererHasItNot)
{
    const OcclusionScene scene = Boxes();
    UniversalRenderPipeline pipeline(SharedDevice());
    UniversalRenderer with(Compiler());
    with.AddFeature(std::make_unique<ScreenSpaceAmbientOcclusion>(Strong()));
    UniversalRenderer without(Compiler());
    RenderRequest request;
    request.scene = &scene.scene;
    request.camera = &scene.camera;
    request.width = scene.width;
    request.height = scene.height;
    const auto darkest = [&](UniversalRenderer& renderer)
    {
        const RenderResult result = pipeline.RenderSingleCamera(renderer, request);
        return Least(ToField(SharedDevice().ReadBack(*result.output.rt())));
    };
    EXPECT_LT(darkest(with), 0.9); // alpha and the sky aside, red is the least
    const Field plain = ToField(
        SharedDevice().ReadBack(*pipeline.RenderSingleCamera(without, request).output.rt()));
    int darkened = 0;
    for (int y = 0; y < plain.height; ++y)
    {
        for (int x = 0; x < plain.width; ++x)
        {
            darkened += plain.At(x, y, 0) < 1.0 ? 1 : 0;
        }
    }
    EXPECT_EQ(darkened, 0);
}

TEST_F(OcclusionInTheFrameGpu, OfAnOverlayCameraIsThatOfWhatItSees)
{
    OcclusionScene scene = Boxes();
    OcclusionRun alone(scene, Strong());
    const Field wanted = alone.Color(nullptr);
    const auto overlay = std::make_shared<Camera>(scene.camera);
    overlay->renderType = CameraRenderType::Overlay;
    scene.camera.cullingMask = LayerMask();
    scene.camera.cameraStack.push_back(overlay);
    OcclusionRun stack(scene, Strong());
    EXPECT_EQ(CountDifferent(stack.Color(nullptr), wanted), 0);
}

TEST_F(OcclusionInTheFrameGpu, FollowsTheRenderScale)
{
    const OcclusionScene scene = Boxes(64, 48);
    UniversalRenderPipeline pipeline(SharedDevice());
    pipeline.renderScale = 0.5f;
    UniversalRenderer renderer(Compiler());
    renderer.AddFeature(std::make_unique<ScreenSpaceAmbientOcclusion>(Strong()));
    RenderRequest request;
    request.scene = &scene.scene;
    request.camera = &scene.camera;
    request.width = 128;
    request.height = 96;
    const RenderResult result = pipeline.RenderSingleCamera(renderer, request);
    const Field scaled = ToField(SharedDevice().ReadBack(*result.output.rt()));
    OcclusionRun run(scene, Strong());
    const Field left = run.Left();
    // The output is sRGB: its order is that of the light that is left.
    double darkest = 1.0;
    glm::ivec2 where(0);
    for (int y = 0; y < left.height; ++y)
    {
        for (int x = 0; x < left.width; ++x)
        {
            if (left.At(x, y) < darkest)
            {
                darkest = left.At(x, y);
                where = {x, y};
            }
        }
    }
    EXPECT_LT(scaled.At(2 * where.x + 1, 2 * where.y + 1, 0), 0.9);
    EXPECT_EQ(scaled.At(60, 90, 0), 1.0); // the open ground before the camera
}

TEST_F(OcclusionInTheFrameGpu, LooksTheSameWhateverTheFrameCompilerLeavesOut)
{
    for (const bool afterOpaque : {false, true})
    {
        const OcclusionScene scene = Boxes();
        SsaoSettings settings = Strong();
        settings.AfterOpaque = afterOpaque;
        OcclusionRun run(scene, settings);
        const auto output = [&](bool leavesOut)
        {
            run.Render(nullptr, leavesOut);
            return ToField(SharedDevice().ReadBack(*run.result().output.rt()));
        };
        const Field whole = output(false);
        const Field lean = output(true);
        for (std::size_t i = 0; i < whole.values.size(); ++i)
        {
            // Without a picture of halves on the way, a value may be rounded to its neighbour.
            ASSERT_NEAR(whole.values[i], lean.values[i], 1.01 / 255.0);
        }
    }
}

} // namespace
} // namespace limn::test

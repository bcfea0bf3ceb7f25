#include "FloatOcclusion.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

SsaoSettings With(SsaoSource source, SsaoNormals quality, bool downsample)
{
    SsaoSettings settings;
    settings.AOMethod = SsaoMethod::InterleavedGradient;
    settings.Source = source;
    settings.NormalSamples = quality;
    settings.Downsample = downsample;
    settings.Falloff = 1e6f;
    return settings;
}

std::vector<SsaoSettings> AllSources()
{
    return {With(SsaoSource::Depth, SsaoNormals::Low, false),
            With(SsaoSource::Depth, SsaoNormals::Medium, true),
            With(SsaoSource::Depth, SsaoNormals::High, false),
            With(SsaoSource::DepthNormals, SsaoNormals::Low, true)};
}

void ExpectNumbers(const OcclusionScene& scene, const SsaoSettings& settings)
{
    PictureRun run(scene.scene, scene.camera, scene.width, scene.height);
    run.Add(std::make_unique<FloatOcclusion>(settings, scene.camera.orthographic));
    run.Render(nullptr);
    const Field floats = run.Texture("Floats");
    // The other channels hold half of a unit vector, whose parts floats may round beyond 1.
    constexpr double k_Rounding = 0x1p-23;
    for (std::size_t i = 0; i < floats.values.size(); ++i)
    {
        const double slack = i % static_cast<std::size_t>(floats.channels) == 0 ? 0.0 : k_Rounding;
        const double value = floats.values[i];
        ASSERT_TRUE(value >= -slack && value <= 1.0 + slack) << value;
    }
}

/// Boxes, a floor, its end, sky, all at once.
OcclusionScene Landscape(int width, int height)
{
    OcclusionScene scene(width, height, {0.5f, 2.0f, -6.0f}, 8.0f);
    scene.AddBoxes();
    return scene;
}

class OcclusionExtremesGpu : public GpuTest
{
};

TEST_F(OcclusionExtremesGpu, AreNumbersWhateverTheRadius)
{
    for (SsaoSettings settings : AllSources())
    {
        for (const float radius : {1e-30f, 1e-6f, 50.0f, 3e38f})
        {
            settings.Radius = radius;
            settings.Intensity = radius > 1e30f ? 3e38f : 3.0f;
            OcclusionScene scene = Landscape(33, 17);
            ExpectNumbers(scene, settings);
            scene.camera.orthographic = true;
            scene.camera.orthographicSize = 4.0f;
            ExpectNumbers(scene, settings);
        }
    }
}

TEST_F(OcclusionExtremesGpu, AreNumbersFromANearPlaneOfAMillimetreToAFarOneOfAMillionMetres)
{
    for (SsaoSettings settings : AllSources())
    {
        settings.Radius = 0.5f;
        OcclusionScene scene = Landscape(33, 17);
        scene.camera.nearClipPlane = 1e-3f;
        scene.camera.farClipPlane = 1e6f;
        ExpectNumbers(scene, settings);
        // A plane that is as far away as the near plane, to a tenth of a percent
        OcclusionScene close(33, 17, {0.0f, 1.001e-3f, 0.0f}, 90.0f);
        close.camera.nearClipPlane = 1e-3f;
        close.camera.farClipPlane = 1e6f;
        ExpectNumbers(close, settings);
        OcclusionRun run(close, settings);
        EXPECT_GE(Least(run.Left()), 1.0 - 1.0 / 255.0);
    }
}

TEST_F(OcclusionExtremesGpu, AreNumbersAndNoneOfAPlaneInPicturesOfFewAndOddPixels)
{
    for (SsaoSettings settings : AllSources())
    {
        settings.Radius = 0.3f;
        for (const glm::ivec2& size :
             {glm::ivec2(1, 1), glm::ivec2(1, 7), glm::ivec2(5, 1), glm::ivec2(3, 5)})
        {
            ExpectNumbers(Landscape(size.x, size.y), settings);
            for (const auto blur : {SsaoBlur::High, SsaoBlur::Medium, SsaoBlur::Low})
            {
                settings.BlurQuality = blur;
                const OcclusionScene plane(size.x, size.y, {0.0f, 3.0f, 0.0f}, 60.0f);
                OcclusionRun run(plane, settings);
                EXPECT_GE(Least(run.Left()), 1.0 - 1.0 / 255.0) << size.x << " x " << size.y;
            }
        }
    }
}

TEST_F(OcclusionExtremesGpu, OfTheSkyIsNone)
{
    for (SsaoSettings settings : AllSources())
    {
        settings.Radius = 2.0f;
        OcclusionScene scene = Landscape(64, 48);
        OcclusionRun run(scene, settings);
        const Field left = run.Left();
        int sky = 0;
        for (int y = 0; y < scene.height; ++y)
        {
            for (int x = 0; x < scene.width; ++x)
            {
                if (!scene.Cast(scene.RayThrough(x + 0.5, y + 0.5)))
                {
                    // The last blur mixes texels of half the size, whatever their normals.
                    EXPECT_GE(left.At(x, y), settings.Downsample ? 0.0 : 1.0 - 1.0 / 255.0);
                    ++sky;
                }
            }
        }
        EXPECT_GT(sky, 100);
        EXPECT_LT(Least(left), 0.7);
    }
}

} // namespace
} // namespace limn::test

#include "FloatOcclusion.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

OcclusionScene MeasuredBoxes()
{
    OcclusionScene scene(320, 180, {0.5f, 2.0f, -6.0f}, 8.0f);
    scene.AddBoxes();
    return scene;
}

SsaoSettings Measured(SsaoMethod method)
{
    SsaoSettings settings;
    settings.Radius = 0.5f;
    settings.Intensity = 1.5f;
    settings.AOMethod = method;
    return settings;
}

/// How far the light that is left is from what the estimator gives with 256 samples and no blur.
double RootMeanSquareError(const SsaoSettings& settings, const Field& reference)
{
    const OcclusionScene scene = MeasuredBoxes();
    OcclusionRun run(scene, settings);
    const Field left = run.Left();
    double sum = 0.0;
    for (int y = 0; y < left.height; ++y)
    {
        for (int x = 0; x < left.width; ++x)
        {
            const double error = left.At(x, y) - (1.0 - reference.At(x, y));
            sum += error * error;
        }
    }
    return std::sqrt(sum / (left.width * left.height));
}

class OcclusionErrorGpu : public GpuTest, public testing::WithParamInterface<SsaoMethod>
{
};

/// Prints the table of the feature's README.
TEST_P(OcclusionErrorGpu, IsSmallerWithMoreSamplesAndOfTheWholeSize)
{
    SsaoSettings settings = Measured(GetParam());
    const OcclusionScene scene = MeasuredBoxes();
    PictureRun exact(scene.scene, scene.camera, scene.width, scene.height);
    exact.Add(std::make_unique<FloatOcclusion>(settings, false, 256));
    exact.Render(nullptr);
    const Field reference = exact.Texture("Floats");
    double errors[2][3] = {};
    for (const bool downsample : {false, true})
    {
        for (const SsaoSamples samples : {SsaoSamples::High, SsaoSamples::Medium, SsaoSamples::Low})
        {
            settings.Downsample = downsample;
            settings.Samples = samples;
            const double error = RootMeanSquareError(settings, reference);
            errors[downsample ? 1 : 0][static_cast<int>(samples)] = error;
            std::printf("%s %s: %.4f\n", downsample ? "half" : "whole",
                        samples == SsaoSamples::High     ? "High"
                        : samples == SsaoSamples::Medium ? "Medium"
                                                         : "Low",
                        error);
        }
        EXPECT_LT(errors[downsample ? 1 : 0][0], errors[downsample ? 1 : 0][2]);
    }
    for (int samples = 0; samples < 3; ++samples)
    {
        EXPECT_LT(errors[0][samples], errors[1][samples]);
    }
    EXPECT_LT(errors[0][0], 0.05);
}

INSTANTIATE_TEST_SUITE_P(Methods, OcclusionErrorGpu,
                         testing::Values(SsaoMethod::BlueNoise, SsaoMethod::InterleavedGradient),
                         [](const auto& one) {
                             return std::string(one.param == SsaoMethod::BlueNoise ? "BlueNoise"
                                                                                   : "Gradient");
                         });

} // namespace
} // namespace limn::test

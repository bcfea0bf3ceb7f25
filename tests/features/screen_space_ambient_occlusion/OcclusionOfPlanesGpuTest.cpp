#include "OcclusionScene.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

constexpr double k_Step = 1.0 / 255.0;

struct PlaneCase
{
    const char* name;
    SsaoSource source;
    SsaoNormals quality;
    bool downsample;
};

class OcclusionOfAPlaneGpu : public GpuTest, public testing::WithParamInterface<PlaneCase>
{
protected:
    static SsaoSettings Settings()
    {
        SsaoSettings settings;
        settings.Source = GetParam().source;
        settings.NormalSamples = GetParam().quality;
        settings.Downsample = GetParam().downsample;
        settings.Falloff = 1e6f;
        return settings;
    }
};

TEST_P(OcclusionOfAPlaneGpu, IsNoneAtAnyAngleAndDistanceUpToThePicturesBorder)
{
    for (const bool isOrthographic : {false, true})
    {
        for (const float pitch : {90.0f, 60.0f, 25.0f, 8.0f, 2.0f})
        {
            for (const float height : {0.2f, 60.0f})
            {
                OcclusionScene plane(61, 34, {0.0f, height, 0.0f}, pitch);
                plane.camera.orthographic = isOrthographic;
                plane.camera.orthographicSize = height;
                SsaoSettings settings = Settings();
                settings.Radius = 0.15f * height;
                for (const auto method : {SsaoMethod::BlueNoise, SsaoMethod::InterleavedGradient})
                {
                    settings.AOMethod = method;
                    OcclusionRun run(plane, settings);
                    EXPECT_GE(Least(run.Left()), 1.0 - k_Step)
                        << pitch << " degrees, " << height << " m, "
                        << (isOrthographic ? "orthographic" : "perspective") << ", method "
                        << static_cast<int>(method);
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Sources, OcclusionOfAPlaneGpu,
    testing::Values(PlaneCase{"DepthLow", SsaoSource::Depth, SsaoNormals::Low, false},
                    PlaneCase{"DepthMedium", SsaoSource::Depth, SsaoNormals::Medium, false},
                    PlaneCase{"DepthHigh", SsaoSource::Depth, SsaoNormals::High, false},
                    PlaneCase{"DepthHighOfHalfTheSize", SsaoSource::Depth, SsaoNormals::High, true},
                    PlaneCase{"Normals", SsaoSource::DepthNormals, SsaoNormals::Low, false},
                    PlaneCase{"NormalsOfHalfTheSize", SsaoSource::DepthNormals, SsaoNormals::Low,
                              true}),
    [](const auto& one) { return std::string(one.param.name); });

} // namespace
} // namespace limn::test

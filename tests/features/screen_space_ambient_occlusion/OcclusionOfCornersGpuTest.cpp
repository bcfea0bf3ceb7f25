#include "OcclusionScene.h"

#include <gmock/gmock.h>
#include <numbers>
#include <numeric>
#include <random>

namespace limn::test
{
namespace
{

constexpr float k_Radius = 0.5f;
constexpr double k_WallAt = 3.0; ///< metres ahead of the camera

/// The estimator as its paper and URP's parameters define it, and the truth, both in double, by
/// rays through the scene.
class Reference
{
public:
    Reference(const OcclusionScene& scene, const SsaoSettings& settings)
        : m_Scene(scene), m_Settings(settings)
    {
    }

    /// The mean of what a pixel may come to, whichever way its samples lie.
    double Hidden(int x, int y)
    {
        constexpr int k_Trials = 24;
        const auto seen = Seen(x, y);
        double sum = 0.0;
        for (int trial = 0; seen && trial < k_Trials; ++trial)
        {
            sum += Estimate(*seen);
        }
        return sum / k_Trials;
    }

    /// The share of the light of a sky of even brightness that something within the radius hides.
    double Truth(int x, int y)
    {
        constexpr int k_Rays = 400;
        const auto seen = Seen(x, y);
        int hidden = 0;
        for (int ray = 0; seen && ray < k_Rays; ++ray)
        {
            // A point of a sphere that touches the surface: directions by their cosine.
            const glm::dvec3 way = glm::normalize(seen->normal * 1.000001 + Direction());
            const auto hit = m_Scene.Cast({seen->place + seen->normal * 1e-6, way});
            hidden += hit && hit->distance < static_cast<double>(k_Radius) ? 1 : 0;
        }
        return static_cast<double>(hidden) / k_Rays;
    }

    std::optional<glm::dvec3> Place(int x, int y) const
    {
        const auto seen = Seen(x, y);
        return seen ? std::optional(seen->place) : std::nullopt;
    }

private:
    struct Surface
    {
        glm::dvec3 place;
        glm::dvec3 normal;
        double depth = 0.0;
    };

    std::optional<Surface> Seen(int x, int y) const
    {
        const ShadowScene::Ray ray = m_Scene.RayThrough(x + 0.5, y + 0.5);
        const auto hit = m_Scene.Cast(ray);
        if (!hit)
        {
            return std::nullopt;
        }
        const glm::dvec3 place = ray.origin + ray.direction * hit->distance;
        return Surface{place, hit->normal, m_Scene.DepthOf(place)};
    }

    glm::dvec3 Direction()
    {
        const double z = 2.0 * Random() - 1.0;
        const double angle = 2.0 * std::numbers::pi * Random();
        const double across = std::sqrt(1.0 - z * z);
        return {across * std::cos(angle), across * std::sin(angle), z};
    }
    double Random() { return std::uniform_real_distribution<double>()(m_Random); }

    int SampleCount() const
    {
        constexpr int counts[] = {12, 8, 4};
        return counts[static_cast<int>(m_Settings.Samples)];
    }

    double Estimate(const Surface& surface)
    {
        const bool isBlue = m_Settings.AOMethod == SsaoMethod::BlueNoise;
        const double radius = static_cast<double>(m_Settings.Radius) * (isBlue ? 1.5 : 1.0);
        const int count = SampleCount();
        double sum = 0.0;
        for (int i = 0; i < count; ++i)
        {
            const double share = static_cast<double>(i) / count;
            const double size = isBlue ? 0.1 + 0.9 * share * share : std::sqrt((i + 1.0) / count);
            glm::dvec3 way = Direction();
            way *= glm::dot(way, surface.normal) < 0.0 ? -1.0 : 1.0;
            const glm::dvec3 sample = surface.place + way * size * radius;
            // The surface that stands at the sample's pixel
            glm::dvec2 pixel = m_Scene.PixelOf(sample);
            pixel = glm::clamp(pixel, glm::dvec2(0.0),
                               glm::dvec2(m_Scene.width - 1, m_Scene.height - 1));
            const auto there = Seen(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
            if (there && std::abs(there->depth - m_Scene.DepthOf(sample)) < radius)
            {
                const glm::dvec3 v = there->place - surface.place;
                sum += std::max(glm::dot(v, surface.normal) - 0.004 * surface.depth, 0.0) /
                       (glm::dot(v, v) + 1e-4);
            }
        }
        const double fade = 1.0 - surface.depth / static_cast<double>(m_Settings.Falloff);
        const double hidden = sum / count * radius * static_cast<double>(m_Settings.Intensity);
        return std::pow(std::clamp(hidden * fade * fade, 0.0, 1.0), 0.6);
    }

    const OcclusionScene& m_Scene;
    SsaoSettings m_Settings;
    std::mt19937 m_Random{7};
};

SsaoSettings CornerSettings()
{
    SsaoSettings settings;
    settings.Radius = k_Radius;
    settings.Intensity = 1.0f;
    settings.AOMethod = SsaoMethod::InterleavedGradient;
    settings.Samples = SsaoSamples::High;
    return settings;
}

/// A floor and a wall, at right angles, and nothing else.
OcclusionScene Corner(int width, int height, bool isOrthographic = false)
{
    OcclusionScene scene(width, height, {0.0f, 1.5f, 0.0f}, 22.0f);
    scene.Add({0.0f, 5.0f, k_WallAt + 5.0}, {60.0f, 10.0f, 10.0f});
    scene.camera.orthographic = isOrthographic;
    scene.camera.orthographicSize = 1.6f;
    return scene;
}

/// The mean of some columns in the middle, of a row.
template <typename Value>
double RowMean(int width, const Value& value)
{
    constexpr int k_Columns = 40;
    double sum = 0.0;
    for (int x = (width - k_Columns) / 2; x < (width + k_Columns) / 2; ++x)
    {
        sum += value(x);
    }
    return sum / k_Columns;
}

std::vector<double> RowMeans(const Field& field)
{
    std::vector<double> rows;
    for (int y = 0; y < field.height; ++y)
    {
        rows.push_back(RowMean(field.width, [&](int x) { return field.At(x, y); }));
    }
    return rows;
}

class OcclusionOfACornerGpu : public GpuTest
{
};

struct EstimateCase
{
    const char* name;
    bool isOrthographic;
    SsaoMethod method;
    SsaoSamples samples;
    double allowed; ///< of a row's mean
};

class OcclusionEstimateGpu : public GpuTest, public testing::WithParamInterface<EstimateCase>
{
};

TEST_P(OcclusionEstimateGpu, IsWhatThePapersFormulaSaysInDouble)
{
    const OcclusionScene scene = Corner(64, 48, GetParam().isOrthographic);
    SsaoSettings settings = CornerSettings();
    settings.AOMethod = GetParam().method;
    settings.Samples = GetParam().samples;
    OcclusionRun run(scene, settings);
    const std::vector<double> drawn = RowMeans(run.Hidden());
    Reference reference(scene, settings);
    double darkest = 0.0;
    for (int y = 0; y < scene.height; ++y)
    {
        const double wanted = RowMean(scene.width, [&](int x) { return reference.Hidden(x, y); });
        EXPECT_NEAR(drawn[static_cast<std::size_t>(y)], wanted, GetParam().allowed) << "row " << y;
        darkest = std::max(darkest, wanted);
    }
    EXPECT_GT(darkest, 0.8);
}

// URP's four samples of interleaved gradient noise lie on four curves of the sphere, not all over
// it.
INSTANTIATE_TEST_SUITE_P(
    Samples, OcclusionEstimateGpu,
    testing::Values(
        EstimateCase{"BlueNoiseHigh", false, SsaoMethod::BlueNoise, SsaoSamples::High, 0.06},
        EstimateCase{"BlueNoiseLow", false, SsaoMethod::BlueNoise, SsaoSamples::Low, 0.06},
        EstimateCase{"GradientHigh", false, SsaoMethod::InterleavedGradient, SsaoSamples::High,
                     0.06},
        EstimateCase{"GradientLow", false, SsaoMethod::InterleavedGradient, SsaoSamples::Low, 0.22},
        EstimateCase{"OrthographicBlueNoise", true, SsaoMethod::BlueNoise, SsaoSamples::High, 0.06},
        EstimateCase{"OrthographicGradient", true, SsaoMethod::InterleavedGradient,
                     SsaoSamples::High, 0.06}),
    [](const auto& one) { return std::string(one.param.name); });

TEST_F(OcclusionOfACornerGpu, GrowsTowardsTheEdgeAsTheShareOfHiddenSkyDoes)
{
    const OcclusionScene scene = Corner(48, 144);
    const SsaoSettings settings = CornerSettings();
    OcclusionRun run(scene, settings);
    const std::vector<double> drawn = RowMeans(run.Hidden());
    Reference reference(scene, settings);
    double before = 0.0;
    int inReach = 0;
    for (int y = scene.height - 1; y >= 0; --y) // from the camera's feet on
    {
        const glm::dvec3 place = reference.Place(scene.width / 2, y).value();
        const double apart = k_WallAt - place.z;
        if (apart < 1e-6)
        {
            break; // the wall
        }
        const double now = drawn[static_cast<std::size_t>(y)];
        const double truth = RowMean(scene.width, [&](int x) { return reference.Truth(x, y); });
        EXPECT_GE(now, before - 0.03) << apart << " m from the edge";
        if (apart > static_cast<double>(k_Radius))
        {
            EXPECT_EQ(truth, 0.0);
            EXPECT_LT(now, 0.12) << apart << " m from the edge";
        }
        if (apart > 2.0 * static_cast<double>(k_Radius)) // samples and what is near them
        {
            EXPECT_EQ(now, 0.0) << apart << " m from the edge";
        }
        if (truth > 0.2)
        {
            EXPECT_GT(now, 0.2) << apart << " m from the edge";
            ++inReach;
        }
        before = now;
    }
    EXPECT_GE(inReach, 4);
}

TEST_F(OcclusionOfACornerGpu, IsTheSameByTheDepthAloneAsByNormals)
{
    const OcclusionScene scene = Corner(64, 48);
    SsaoSettings settings = CornerSettings();
    OcclusionRun normals(scene, settings);
    const Field wanted = normals.Hidden();
    settings.Source = SsaoSource::Depth;
    settings.NormalSamples = SsaoNormals::High;
    OcclusionRun depth(scene, settings);
    const Field drawn = depth.Hidden();
    int differ = 0;
    for (int y = 0; y < scene.height; ++y)
    {
        for (int x = 0; x < scene.width; ++x)
        {
            differ += std::abs(wanted.At(x, y) - drawn.At(x, y)) > 4.0 / 255.0 ? 1 : 0;
        }
    }
    EXPECT_LE(differ, scene.width); // those along the edge
}

TEST_F(OcclusionOfACornerGpu, FadesOutUpToTheFalloff)
{
    const OcclusionScene scene = Corner(64, 48);
    SsaoSettings settings = CornerSettings();
    settings.Falloff = 1e6f;
    OcclusionRun unfaded(scene, settings);
    const Field full = unfaded.Hidden();
    settings.Falloff = 3.3f; // the edge is 3.3 m away
    OcclusionRun run(scene, settings);
    const Field faded = run.Hidden();
    const Reference reference(scene, settings);
    int beyond = 0;
    int nearer = 0;
    for (int y = 0; y < scene.height; ++y)
    {
        const double depth = scene.DepthOf(reference.Place(scene.width / 2, y).value());
        const double fade = std::max(1.0 - depth / 3.3, 0.0);
        for (int x = 0; x < scene.width; ++x)
        {
            const double was = full.At(x, y);
            if (depth > 3.3)
            {
                EXPECT_EQ(faded.At(x, y), 0.0) << x << ", " << y;
                beyond += was > 0.0 ? 1 : 0;
            }
            else if (was > 0.0 && was < 1.0)
            {
                EXPECT_NEAR(faded.At(x, y), was * std::pow(fade * fade, 0.6), 1.5 / 255.0);
                ++nearer;
            }
        }
    }
    EXPECT_GT(beyond, 20);
    EXPECT_GT(nearer, 20);
}

TEST_F(OcclusionOfACornerGpu, OfAThinPoleFarBeforeAWallIsNone)
{
    for (const float apart : {0.3f, 2.0f}) // less than the radius, and four times as much
    {
        OcclusionScene scene(64, 48, {0.0f, 30.0f, 0.0f}, 0.0f);
        scene.Add({0.0f, 30.0f, 8.0f}, {60.0f, 60.0f, 2.0f}); // its front is 7 m away
        scene.Add({0.0f, 30.0f, 7.0f - apart}, {0.3f, 60.0f, 0.05f});
        OcclusionRun run(scene, CornerSettings());
        const Reference reference(scene, CornerSettings());
        const Field left = run.Left();
        EXPECT_LT(reference.Place(32, 24)->z, 7.0); // the pole is in the middle
        if (apart < k_Radius)
        {
            EXPECT_LT(Least(left), 0.85);
        }
        else
        {
            EXPECT_GE(Least(left), 1.0 - 1.0 / 255.0);
        }
    }
}

} // namespace
} // namespace limn::test

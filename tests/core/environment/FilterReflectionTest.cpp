#include "environment/CubeLight.h"
#include "environment/LightOfTest.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace limn::test
{
namespace
{

/// Returns what a surface of this roughness mirrors, by the sum over all texels of GGX for half
/// vectors between the normal, from which it is seen, and the texel, times the cosine.
glm::dvec3 Mirrored(const CubeLight& light, const glm::dvec3& normal, double perceptualRoughness)
{
    const double alpha2 = std::pow(perceptualRoughness, 4.0);
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    ForEachTexel(light,
                 [&](const glm::dvec3& direction, const glm::dvec3& color, double area)
                 {
                     const double cosine = glm::dot(direction, normal);
                     if (cosine <= 0.0)
                     {
                         return;
                     }
                     const double half = glm::dot(glm::normalize(direction + normal), normal);
                     const double spread = half * half * (alpha2 - 1.0) + 1.0;
                     const double weight = alpha2 / (spread * spread) * cosine * area;
                     sum += color * weight;
                     weights += weight;
                 });
    return sum / weights;
}

/// Returns a sky with a horizon, a bright side and a spot of some degrees.
glm::dvec3 Sky(const glm::dvec3& d)
{
    const glm::dvec3 sun = glm::normalize(glm::dvec3(1, 2, -1));
    const double spot = std::exp(30.0 * (glm::dot(d, sun) - 1.0));
    const glm::dvec3 base =
        d.y > 0.0 ? glm::dvec3(0.2, 0.4, 0.9) * (1.0 - 0.5 * d.y) : glm::dvec3(0.3, 0.25, 0.2);
    return base * (1.2 + d.x) + glm::dvec3(4.0, 3.0, 2.0) * spot;
}

/// The largest difference of about 150 texels of a level from the sum over all texels of the light,
/// as a part of the mean light.
double LargestError(const CubeLight& light, const CubeLight& level, double perceptualRoughness)
{
    double largest = 0.0;
    const std::size_t step = level.texels.size() / 150 + 1;
    std::size_t index = 0;
    ForEachTexel(level,
                 [&](const glm::dvec3& normal, const glm::dvec3& color, double)
                 {
                     if (index++ % step != 0)
                     {
                         return;
                     }
                     const glm::dvec3 error =
                         glm::abs(color - Mirrored(light, normal, perceptualRoughness));
                     largest = std::max({largest, error.r, error.g, error.b});
                 });
    return largest / 0.6; // about the mean of Sky
}

glm::dvec3 MeanOf(const CubeLight& light)
{
    glm::dvec3 sum(0.0);
    double areas = 0.0;
    ForEachTexel(light,
                 [&](const glm::dvec3&, const glm::dvec3& color, double area)
                 {
                     sum += color * area;
                     areas += area;
                 });
    return sum / areas;
}

TEST(FilterReflection, HasTheRoughnessOfWhichTheShaderLibraryAsksForALevel)
{
    for (int level = 0; level <= 6; ++level)
    {
        const double roughness = PerceptualRoughnessOfLevel(level);
        EXPECT_NEAR(level, roughness * (1.7 - 0.7 * roughness) * 6.0, 1e-12);
    }
    EXPECT_NEAR(0.0, PerceptualRoughnessOfLevel(0), 1e-15);
    EXPECT_NEAR(1.0, PerceptualRoughnessOfLevel(6), 1e-12);
}

TEST(FilterReflection, HalvesTheWidthDownToTheRoughestLevelOrOneTexel)
{
    const auto widths = [](int width)
    {
        std::vector<int> result;
        for (const CubeLight& level : FilterReflection(CubeLight(width)))
        {
            result.push_back(level.width);
        }
        return result;
    };
    EXPECT_EQ((std::vector{128, 64, 32, 16, 8, 4, 2}), widths(128));
    EXPECT_EQ((std::vector{16, 8, 4, 2, 1}), widths(16));
    EXPECT_EQ((std::vector{2, 1}), widths(2));
    EXPECT_EQ((std::vector{1}), widths(1));
}

TEST(FilterReflection, KeepsOneColorInAllLevels)
{
    for (const int width : {1, 4, 64})
    {
        const glm::vec3 color(0.25f, 3.0f, 1000.0f);
        const auto levels =
            FilterReflection(LightOf(width, [&](const glm::dvec3&) { return glm::dvec3(color); }));
        for (const CubeLight& level : levels)
        {
            for (const glm::vec3& texel : level.texels)
            {
                ASSERT_NEAR(1.0f, texel.r / color.r, 1e-5f) << level.width;
                ASSERT_NEAR(1.0f, texel.g / color.g, 1e-5f) << level.width;
                ASSERT_NEAR(1.0f, texel.b / color.b, 1e-5f) << level.width;
            }
        }
    }
}

TEST(FilterReflection, IsTheLightItselfInLevelZero)
{
    const CubeLight light = LightOf(16, Sky);
    EXPECT_EQ(light.texels, FilterReflection(light).front().texels);
}

TEST(FilterReflection, IsTheSumOverAllDirectionsByGgxInEachLevel)
{
    const CubeLight light = LightOf(64, Sky);
    const std::vector<CubeLight> levels = FilterReflection(light);
    ASSERT_EQ(7U, levels.size());
    // Lobes of level 1 are as small as the light's texels, between which it jumps at the horizon.
    for (std::size_t i = 1; i < levels.size(); ++i)
    {
        const double error =
            LargestError(light, levels[i], PerceptualRoughnessOfLevel(static_cast<int>(i)));
        std::printf("level %zu: largest error %.4f of the mean light\n", i, error);
        EXPECT_LT(error, i == 1 ? 0.2 : 0.05) << i;
    }
    // Of roughness 1 GGX comes to the cosine alone.
    ForEachTexel(levels[6],
                 [&](const glm::dvec3& normal, const glm::dvec3& color, double)
                 {
                     glm::dvec3 sum(0.0);
                     ForEachTexel(light, [&](const glm::dvec3& d, const glm::dvec3& c, double area)
                                  { sum += c * std::max(glm::dot(d, normal), 0.0) * area; });
                     EXPECT_NEAR(sum.g / std::numbers::pi, color.g, 0.02 * color.g);
                 });
}

TEST(FilterReflection, KeepsTheLightOfOneBrightTexel)
{
    CubeLight light(64);
    light.texels[light.Index(0, 3, 60)] = glm::vec3(1e4f);
    const double mean = MeanOf(light).r;
    const std::vector<CubeLight> levels = FilterReflection(light);
    for (const CubeLight& level : levels)
    {
        if (level.width >= 8) // of fewer texels each has a lobe's middle or its side by chance
        {
            std::printf("width %d: %.3f of the mean\n", level.width, MeanOf(level).r / mean);
            EXPECT_NEAR(1.0, MeanOf(level).r / mean, 0.15) << level.width;
        }
        for (const glm::vec3& texel : level.texels)
        {
            ASSERT_TRUE(texel.r >= 0.0f && texel.r <= 1e4f);
        }
    }
}

TEST(FilterReflection, OfNothingIsBlack)
{
    for (const CubeLight& level : FilterReflection(CubeLight(16)))
    {
        EXPECT_EQ(level.texels, CubeLight(level.width).texels);
    }
}

} // namespace
} // namespace limn::test

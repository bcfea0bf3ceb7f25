#include "environment/LightOfTest.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace limn::test
{
namespace
{

constexpr double k_Pi = std::numbers::pi;

/// Expects these of the nine weights and 0 of the others, for green.
void ExpectWeights(const SphericalHarmonicsL2& light, const std::map<int, double>& wanted,
                   double tolerance)
{
    for (int i = 0; i < 9; ++i)
    {
        const auto found = wanted.find(i);
        EXPECT_NEAR(found == wanted.end() ? 0.0 : found->second, light(1, i), tolerance) << i;
    }
}

TEST(CubeLight, HasTexelsThatCoverTheSphere)
{
    for (const int width : {1, 2, 17, 64})
    {
        double sum = 0.0;
        for (int y = 0; y < width; ++y)
        {
            for (int x = 0; x < width; ++x)
            {
                sum += 6.0 * SolidAngle(width, x, y);
            }
        }
        EXPECT_NEAR(4.0 * k_Pi, sum, 1e-12) << width;
    }
    // A small texel by its area, cosine and distance.
    EXPECT_NEAR(4.0 / (512.0 * 512.0), SolidAngle(512, 256, 256), 1e-9);
    EXPECT_NEAR(4.0 / (512.0 * 512.0) / std::pow(3.0, 1.5), SolidAngle(512, 511, 0), 2e-8);
}

TEST(CubeLight, OfOneColorIsAmbientLightOfThatColor)
{
    for (const int width : {1, 2, 32})
    {
        const SphericalHarmonicsL2 light =
            ProjectLight(LightOf(width, [](const glm::dvec3&) { return glm::dvec3(0, 0.7, 0); }));
        ExpectWeights(light, {{0, 0.7}}, width < 32 ? 1e-6 : 5e-5);
        EXPECT_EQ(0.0f, light(0, 0));
    }
}

TEST(CubeLight, OfAGradientLightsByTwoThirdsOfIt)
{
    const glm::dvec3 slope(0.3, -0.2, 0.5);
    const SphericalHarmonicsL2 light = ProjectLight(
        LightOf(64, [&](const glm::dvec3& d) { return glm::dvec3(1.0 + glm::dot(slope, d)); }));
    ExpectWeights(
        light,
        {{0, 1.0}, {1, slope.y * 2.0 / 3.0}, {2, slope.z * 2.0 / 3.0}, {3, slope.x * 2.0 / 3.0}},
        3e-4);
}

TEST(CubeLight, OfACosineLobeHasItsClosedForm)
{
    // Integrals of cos, cos^2 and cos (3 cos^2 - 1) over the half sphere: pi, 2 pi/3 and pi/2.
    const SphericalHarmonicsL2 light = ProjectLight(
        LightOf(64, [](const glm::dvec3& d) { return glm::dvec3(std::max(d.z, 0.0)); }));
    ExpectWeights(light, {{0, 0.25}, {2, 1.0 / 3.0}, {6, 5.0 / 128.0}}, 3e-4);

    // Turned, it lights its own side as much.
    const glm::dvec3 axis = glm::normalize(glm::dvec3(-2, 1, 3));
    const SphericalHarmonicsL2 turned = ProjectLight(LightOf(
        64, [&](const glm::dvec3& d) { return glm::dvec3(std::max(glm::dot(d, axis), 0.0)); }));
    EXPECT_NEAR(0.25 + 1.0 / 3.0 + 2.0 * 5.0 / 128.0, turned.Evaluate(glm::vec3(axis)).g, 5e-4);
    EXPECT_NEAR(0.25 - 1.0 / 3.0 + 2.0 * 5.0 / 128.0, turned.Evaluate(glm::vec3(-axis)).g, 5e-4);
}

TEST(CubeLight, OfEachSecondOrderFunctionKeepsAQuarter)
{
    const SphericalHarmonicsL2 light =
        ProjectLight(LightOf(64,
                             [](const glm::dvec3& d)
                             {
                                 return glm::dvec3(0.3 * d.x * d.y - 0.7 * d.y * d.z +
                                                   0.4 * (3.0 * d.z * d.z - 1.0) + 0.9 * d.x * d.z -
                                                   0.2 * (d.x * d.x - d.y * d.y));
                             }));
    ExpectWeights(light, {{4, 0.075}, {5, -0.175}, {6, 0.1}, {7, 0.225}, {8, -0.05}}, 3e-4);
}

TEST(CubeLight, OfOneBrightTexelIsAKernelAroundIt)
{
    CubeLight cube(32);
    cube.texels[cube.Index(2, 20, 5)] = glm::vec3(1e4f);
    const glm::dvec3 place = glm::normalize(glm::dvec3(cube.Direction(2, 20, 5)));
    const double power = 1e4 * SolidAngle(32, 20, 5);
    const SphericalHarmonicsL2 light = ProjectLight(cube);
    for (const glm::dvec3& direction : {glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), -place, place})
    {
        const double c = glm::dot(place, direction);
        const double kernel = (1.0 + 2.0 * c + 1.25 * (1.5 * c * c - 0.5)) / (4.0 * k_Pi);
        EXPECT_NEAR(power * kernel, light.Evaluate(glm::vec3(direction)).r, 1e-5 * power);
    }
}

TEST(CubeLight, OfNothingIsBlack)
{
    EXPECT_EQ(SphericalHarmonicsL2(), ProjectLight(CubeLight(8)));
}

/// Returns six faces of 2x2 texels, all the same but for one.
std::array<Image, 6> Faces(const glm::vec4& color, const glm::vec4& other)
{
    std::array<Image, 6> faces;
    for (Image& face : faces)
    {
        face = {2, 2, GraphicsFormat::R16G16B16A16_SFloat, std::vector<std::byte>(32)};
        for (std::size_t i = 0; i < 4; ++i)
        {
            const bool isOther = &face == &faces[4] && i == 1;
            const std::uint64_t half = glm::packHalf4x16(isOther ? other : color);
            std::memcpy(face.texels.data() + 8 * i, &half, 8);
        }
    }
    return faces;
}

TEST(CubeLight, IsReadFaceByFaceFromTheTop)
{
    std::size_t notNumbers = 0;
    const CubeLight light = ReadCubeLight(Faces({1, 2, 3, 0}, {4, 5, 6, 0}), notNumbers);
    EXPECT_EQ(0U, notNumbers);
    ASSERT_EQ(24U, light.texels.size());
    EXPECT_EQ(glm::vec3(4, 5, 6), light.texels[light.Index(4, 1, 0)]);
    EXPECT_EQ(23, std::ranges::count(light.texels, glm::vec3(1, 2, 3)));
}

TEST(CubeLight, IsBlackWhereTheSkyIsNoNumberAndHeldWhereItHasNoEnd)
{
    std::size_t notNumbers = 0;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CubeLight light = ReadCubeLight(Faces({1, 1, 1, nan}, {1, nan, 1, 1}), notNumbers);
    EXPECT_EQ(1U, notNumbers) << "alpha is no light";
    EXPECT_EQ(glm::vec3(0.0f), light.texels[light.Index(4, 1, 0)]);
    EXPECT_NEAR(23.0 / 24.0, ProjectLight(light)(0, 0), 1e-6);

    const float infinity = std::numeric_limits<float>::infinity();
    light = ReadCubeLight(Faces({1, 1, 1, 1}, {infinity, -infinity, -3, 1}), notNumbers);
    EXPECT_EQ(1U, notNumbers);
    EXPECT_EQ(glm::vec3(65504.0f, 0.0f, 0.0f), light.texels[light.Index(4, 1, 0)]);
}

TEST(CubeLight, BecomesACubemapWithItsLevels)
{
    std::vector<CubeLight> levels{CubeLight(2), CubeLight(1)};
    levels[0].texels[5] = {0.5f, 2.0f, 0.25f};
    levels[1].texels[3] = {8.0f, 0.0f, 1.0f};
    const auto cube = MakeCubemap("light", levels);
    EXPECT_EQ(2, cube->mipmapCount());
    EXPECT_EQ(2, cube->levelsOfTexels());
    ASSERT_EQ((24U + 6U) * 8U, cube->texels().size());
    const auto texel = [&](std::size_t index)
    {
        std::uint64_t half = 0;
        std::memcpy(&half, cube->texels().data() + 8 * index, 8);
        return glm::unpackHalf4x16(half);
    };
    EXPECT_EQ(glm::vec4(0.5f, 2.0f, 0.25f, 1.0f), texel(5));
    EXPECT_EQ(glm::vec4(8.0f, 0.0f, 1.0f, 1.0f), texel(24 + 3));
}

} // namespace
} // namespace limn::test

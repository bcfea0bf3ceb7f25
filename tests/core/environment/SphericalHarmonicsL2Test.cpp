#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limn/core/SphericalHarmonicsL2.h>

namespace limn::test
{
namespace
{

/// Nine weights of each colour, no two the same.
SphericalHarmonicsL2 AnyLight()
{
    SphericalHarmonicsL2 light;
    for (int rgb = 0; rgb < 3; ++rgb)
    {
        for (int i = 0; i < 9; ++i)
        {
            light(rgb, i) = 0.1f + 0.37f * std::sin(1.0f + static_cast<float>(9 * rgb + i));
        }
    }
    return light;
}

TEST(SphericalHarmonicsL2, IsTheSumOfItsFunctions)
{
    const SphericalHarmonicsL2 light = AnyLight();
    for (const glm::vec3& direction :
         {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(2, -3, 5), glm::vec3(-1, 4, 0.5f)})
    {
        const glm::vec3 n = glm::normalize(direction);
        const glm::vec3 color = light.Evaluate(n);
        for (int rgb = 0; rgb < 3; ++rgb)
        {
            const float sum = light(rgb, 0) + light(rgb, 1) * n.y + light(rgb, 2) * n.z +
                              light(rgb, 3) * n.x + light(rgb, 4) * n.x * n.y +
                              light(rgb, 5) * n.y * n.z +
                              light(rgb, 6) * (3.0f * n.z * n.z - 1.0f) +
                              light(rgb, 7) * n.x * n.z + light(rgb, 8) * (n.x * n.x - n.y * n.y);
            EXPECT_NEAR(sum, color[rgb], 1e-6f) << rgb;
        }
    }
}

TEST(SphericalHarmonicsL2, GivesShadersConstantsWhoseSumIsTheSame)
{
    const SphericalHarmonicsL2 light = AnyLight();
    const std::array<glm::vec4, 7> c = light.shaderConstants();
    for (const glm::vec3& direction : {glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0),
                                       glm::vec3(2, -3, 5), glm::vec3(-1, 4, 0.5f)})
    {
        const glm::vec3 n = glm::normalize(direction);
        // Written out from limn/SphericalHarmonics.hlsl.
        const glm::vec4 linear(n, 1.0f);
        const glm::vec4 products(n.x * n.y, n.y * n.z, n.z * n.z, n.z * n.x);
        for (int rgb = 0; rgb < 3; ++rgb)
        {
            const auto row = static_cast<std::size_t>(rgb);
            const float sum = glm::dot(c[row], linear) + glm::dot(c[3 + row], products) +
                              c[6][rgb] * (n.x * n.x - n.y * n.y);
            EXPECT_NEAR(light.Evaluate(n)[rgb], sum, 2e-6f) << rgb;
        }
    }
}

TEST(SphericalHarmonicsL2, IsOneColorOfAmbientLightOnly)
{
    SphericalHarmonicsL2 light;
    light.AddAmbientLight({0.25f, 0.5f, 2.0f});
    light.AddAmbientLight({0.25f, 0.0f, 1.0f});
    EXPECT_EQ(glm::vec3(0.5f, 0.5f, 3.0f), light.Evaluate({0, 0, 1}));
    EXPECT_EQ(glm::vec3(0.5f, 0.5f, 3.0f), light.Evaluate({0.6f, -0.8f, 0}));
    light *= 0.5f;
    EXPECT_EQ(0.25f, light(0, 0));
    light.Clear();
    EXPECT_EQ(SphericalHarmonicsL2(), light);
}

} // namespace
} // namespace limn::test

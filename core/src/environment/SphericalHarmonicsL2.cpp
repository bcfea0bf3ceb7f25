#include <limn/core/SphericalHarmonicsL2.h>

namespace limn
{

void SphericalHarmonicsL2::AddAmbientLight(const Color& color)
{
    const glm::vec4 light = color.vector();
    for (int rgb = 0; rgb < k_Channels; ++rgb)
    {
        (*this)(rgb, 0) += light[rgb];
    }
}

glm::vec3 SphericalHarmonicsL2::Evaluate(const glm::vec3& normal) const
{
    const auto [x, y, z] = std::array{normal.x, normal.y, normal.z};
    const std::array<float, k_Coefficients> functions{
        1.0f, y, z, x, x * y, y * z, 3.0f * z * z - 1.0f, x * z, x * x - y * y};
    glm::vec3 sum(0.0f);
    for (int rgb = 0; rgb < k_Channels; ++rgb)
    {
        for (int i = 0; i < k_Coefficients; ++i)
        {
            sum[rgb] += (*this)(rgb, i) * functions[static_cast<std::size_t>(i)];
        }
    }
    return sum;
}

std::array<glm::vec4, 7> SphericalHarmonicsL2::shaderConstants() const
{
    std::array<glm::vec4, 7> constants{};
    constants[6].w = 1.0f;
    for (int rgb = 0; rgb < k_Channels; ++rgb)
    {
        const auto c = [&](int coefficient)
        {
            return (*this)(rgb, coefficient);
        };
        const auto row = static_cast<std::size_t>(rgb);
        // Shaders have z^2 where the weight is that of 3z^2 - 1.
        constants[row] = {c(3), c(1), c(2), c(0) - c(6)};
        constants[3 + row] = {c(4), c(5), 3.0f * c(6), c(7)};
        constants[6][rgb] = c(8);
    }
    return constants;
}

SphericalHarmonicsL2& SphericalHarmonicsL2::operator*=(float scale)
{
    for (float& weight : weights)
    {
        weight *= scale;
    }
    return *this;
}

} // namespace limn

#include "environment/CubeLight.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <numbers>

namespace limn
{

namespace
{

constexpr float k_MostLight = 65504.0f; ///< the largest half

/// The signed area on the unit sphere between a face's middle and a corner at (x, y) of it.
double CornerArea(double x, double y)
{
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1.0));
}

glm::vec3 Sanitized(const glm::vec3& color, std::size_t& notNumbers)
{
    if (std::isnan(color.r) || std::isnan(color.g) || std::isnan(color.b))
    {
        ++notNumbers;
        return glm::vec3(0.0f);
    }
    return glm::clamp(color, glm::vec3(0.0f), glm::vec3(k_MostLight));
}

} // namespace

CubeLight::CubeLight(int width_)
    : width(width_), texels(static_cast<std::size_t>(k_CubeFaces * width_ * width_))
{
}

std::size_t CubeLight::Index(int face, int x, int y) const
{
    return static_cast<std::size_t>((face * width + y) * width + x);
}

glm::vec3 CubeLight::Direction(int face, int x, int y) const
{
    const CubeFace& axes = k_FacesOfCube[static_cast<std::size_t>(face)];
    const auto size = static_cast<float>(width);
    const float right = static_cast<float>(2 * x + 1) / size - 1.0f;
    const float up = 1.0f - static_cast<float>(2 * y + 1) / size;
    return axes.forward + right * axes.right + up * axes.up;
}

CubeLight ReadCubeLight(const std::array<Image, k_CubeFaces>& faces, std::size_t& notNumbers)
{
    CubeLight light(faces.front().width);
    std::size_t index = 0;
    for (const Image& face : faces)
    {
        for (std::size_t at = 0; at < face.texels.size(); at += sizeof(std::uint64_t))
        {
            std::uint64_t packed = 0;
            std::memcpy(&packed, face.texels.data() + at, sizeof packed);
            light.texels[index++] = Sanitized(glm::vec3(glm::unpackHalf4x16(packed)), notNumbers);
        }
    }
    return light;
}

double SolidAngle(int width, int x, int y)
{
    const auto edge = [width](int i)
    {
        return 2.0 * i / width - 1.0;
    };
    return CornerArea(edge(x), edge(y)) - CornerArea(edge(x + 1), edge(y)) -
           CornerArea(edge(x), edge(y + 1)) + CornerArea(edge(x + 1), edge(y + 1));
}

SphericalHarmonicsL2 ProjectLight(const CubeLight& light)
{
    constexpr int k_Count = SphericalHarmonicsL2::k_Coefficients;
    // Each factor is the square of what makes its function orthonormal, times the cosine's
    // convolution over pi, which is 1, 2/3 and 1/4 for orders 0, 1 and 2.
    constexpr double k_Pi = std::numbers::pi;
    constexpr std::array<double, k_Count> k_Scales{
        1.0 / (4.0 * k_Pi),  2.0 / (4.0 * k_Pi),   2.0 / (4.0 * k_Pi),
        2.0 / (4.0 * k_Pi),  15.0 / (16.0 * k_Pi), 15.0 / (16.0 * k_Pi),
        5.0 / (64.0 * k_Pi), 15.0 / (16.0 * k_Pi), 15.0 / (64.0 * k_Pi)};
    std::array<glm::dvec3, k_Count> sums{};
    for (int y = 0; y < light.width; ++y)
    {
        for (int x = 0; x < light.width; ++x)
        {
            const double area = SolidAngle(light.width, x, y); // the same on each face
            for (int face = 0; face < k_CubeFaces; ++face)
            {
                const glm::dvec3 n = glm::normalize(glm::dvec3(light.Direction(face, x, y)));
                const std::array<double, k_Count> functions{1.0,
                                                            n.y,
                                                            n.z,
                                                            n.x,
                                                            n.x * n.y,
                                                            n.y * n.z,
                                                            3.0 * n.z * n.z - 1.0,
                                                            n.x * n.z,
                                                            n.x * n.x - n.y * n.y};
                const glm::dvec3 color(light.texels[light.Index(face, x, y)]);
                for (std::size_t i = 0; i < functions.size(); ++i)
                {
                    sums[i] += color * (area * functions[i]);
                }
            }
        }
    }
    SphericalHarmonicsL2 result;
    for (int i = 0; i < k_Count; ++i)
    {
        const auto at = static_cast<std::size_t>(i);
        for (int rgb = 0; rgb < SphericalHarmonicsL2::k_Channels; ++rgb)
        {
            result(rgb, i) = static_cast<float>(sums[at][rgb] * k_Scales[at]);
        }
    }
    return result;
}

std::shared_ptr<const Cubemap> MakeCubemap(const std::string& name,
                                           const std::vector<CubeLight>& levels)
{
    std::vector<CubemapFaces> packed(levels.size());
    for (std::size_t level = 0; level < levels.size(); ++level)
    {
        const CubeLight& light = levels[level];
        const std::size_t texelsOfFace = light.texels.size() / k_CubeFaces;
        auto texel = light.texels.begin();
        for (std::vector<std::byte>& face : packed[level])
        {
            face.resize(texelsOfFace * sizeof(std::uint64_t));
            for (std::size_t i = 0; i < texelsOfFace; ++i)
            {
                const std::uint64_t half = glm::packHalf4x16(glm::vec4(*texel++, 1.0f));
                std::memcpy(face.data() + i * sizeof half, &half, sizeof half);
            }
        }
    }
    const SamplerState sampler{FilterMode::Trilinear, TextureWrapMode::Clamp,
                               TextureWrapMode::Clamp, TextureWrapMode::Clamp};
    return std::make_shared<const Cubemap>(name, levels.front().width,
                                           GraphicsFormat::R16G16B16A16_SFloat, std::move(packed),
                                           sampler);
}

} // namespace limn

#include "environment/CubeLight.h"

#include "support/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace limn
{

namespace
{

/// A smaller picture of a light, each face with a border of one texel of its neighbours, so that
/// what lies between texels is found without asking on which face they are.
class BorderedLight
{
public:
    explicit BorderedLight(const CubeLight& light) : m_Width(light.width), m_Row(light.width + 2)
    {
        m_Texels.resize(static_cast<std::size_t>(k_CubeFaces * m_Row * m_Row));
        for (int face = 0; face < k_CubeFaces; ++face)
        {
            for (int y = -1; y <= m_Width; ++y)
            {
                for (int x = -1; x <= m_Width; ++x)
                {
                    m_Texels[Index(face, x, y)] = NearestTexel(light, face, x, y);
                }
            }
        }
    }

    /// Returns the light from a direction of any length, between the four texels around.
    glm::vec3 Sample(const glm::vec3& direction) const
    {
        const float size = static_cast<float>(m_Width) / 2.0f;
        const Place place = Find(direction);
        const float x = (place.right + 1.0f) * size - 0.5f; // from -0.5 to m_Width - 0.5
        const float y = (1.0f - place.up) * size - 0.5f;
        const int left = std::clamp(static_cast<int>(x + 1.0f) - 1, -1, m_Width - 1);
        const int top = std::clamp(static_cast<int>(y + 1.0f) - 1, -1, m_Width - 1);
        const float partX = x - static_cast<float>(left);
        const float partY = y - static_cast<float>(top);
        const glm::vec3* first = &m_Texels[Index(place.face, left, top)];
        const glm::vec3* next = first + m_Row;
        return (first[0] * (1.0f - partX) + first[1] * partX) * (1.0f - partY) +
               (next[0] * (1.0f - partX) + next[1] * partX) * partY;
    }

private:
    struct Place
    {
        int face;
        float right; ///< from -1 to 1, as `up`
        float up;
    };

    /// Looks a direction up by k_FacesOfCube, written out since each sample takes it.
    static Place Find(const glm::vec3& d)
    {
        const float x = std::abs(d.x);
        const float y = std::abs(d.y);
        const float z = std::abs(d.z);
        if (x >= y && x >= z)
        {
            return {d.x > 0.0f ? 0 : 1, (d.x > 0.0f ? -d.z : d.z) / x, d.y / x};
        }
        if (y >= z)
        {
            return {d.y > 0.0f ? 2 : 3, d.x / y, (d.y > 0.0f ? -d.z : d.z) / y};
        }
        return {d.z > 0.0f ? 4 : 5, (d.z > 0.0f ? d.x : -d.x) / z, d.y / z};
    }

    static glm::vec3 NearestTexel(const CubeLight& light, int face, int x, int y)
    {
        const Place place = Find(light.Direction(face, x, y));
        const float size = static_cast<float>(light.width) / 2.0f;
        const auto texel = [&](float at)
        {
            return std::clamp(static_cast<int>(at * size), 0, light.width - 1);
        };
        return light
            .texels[light.Index(place.face, texel(place.right + 1.0f), texel(1.0f - place.up))];
    }

    std::size_t Index(int face, int x, int y) const
    {
        return static_cast<std::size_t>((face * m_Row + y + 1) * m_Row + x + 1);
    }

    int m_Width;
    int m_Row; ///< texels with the border
    std::vector<glm::vec3> m_Texels;
};

/// Returns the light half as wide: of four texels the mean by their solid angles.
CubeLight Halve(const CubeLight& light)
{
    CubeLight half(light.width / 2);
    for (int y = 0; y < half.width; ++y)
    {
        for (int x = 0; x < half.width; ++x)
        {
            double areas = 0.0;
            std::array<glm::dvec3, k_CubeFaces> sums{};
            for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}})
            {
                const double area = SolidAngle(light.width, 2 * x + dx, 2 * y + dy);
                areas += area;
                for (int face = 0; face < k_CubeFaces; ++face)
                {
                    sums[static_cast<std::size_t>(face)] +=
                        area * glm::dvec3(light.texels[light.Index(face, 2 * x + dx, 2 * y + dy)]);
                }
            }
            for (int face = 0; face < k_CubeFaces; ++face)
            {
                half.texels[half.Index(face, x, y)] =
                    glm::vec3(sums[static_cast<std::size_t>(face)] / areas);
            }
        }
    }
    return half;
}

/// A direction that a surface mirrors.
struct Sample
{
    glm::vec3 direction; ///< z along the normal, unit length
    float weight;        ///< of all samples together 1
    std::size_t level;   ///< how much smaller a picture of the light stands for what is around it
};

/// Returns the base-2 radical inverse of `index`: Hammersley's second coordinate.
double RadicalInverse(std::uint32_t index)
{
    double result = 0.0;
    for (double digit = 0.5; index != 0; index >>= 1U, digit /= 2.0)
    {
        result += (index & 1U) != 0 ? digit : 0.0;
    }
    return result;
}

/// Returns directions by the GGX distribution of half vectors, viewed along the normal.
/// @param width   texels along an edge of the light
/// @param levels  how many smaller pictures there are
std::vector<Sample> MakeSamples(double perceptualRoughness, int count, int width,
                                std::size_t levels)
{
    constexpr double k_Pi = std::numbers::pi;
    const double alpha2 = std::pow(perceptualRoughness, 4.0);
    const double texel = 4.0 * k_Pi / (6.0 * width * width);
    std::vector<Sample> samples;
    double weights = 0.0;
    for (int i = 0; i < count; ++i)
    {
        const double u = (i + 0.5) / count;
        const double cosine2 = (1.0 - u) / (1.0 + (alpha2 - 1.0) * u); // of half vector and normal
        const double z = 2.0 * cosine2 - 1.0;
        if (z <= 0.0)
        {
            continue;
        }
        const double spread = cosine2 * (alpha2 - 1.0) + 1.0;
        const double density = alpha2 / (4.0 * k_Pi * spread * spread); // in directions mirrored
        // This level's texels are just as large as what the sample stands for, or larger.
        const double level = std::ceil(0.5 * std::log2(1.0 / (count * density * texel)));
        const double side = std::sqrt(std::max(1.0 - z * z, 0.0));
        const double angle = 2.0 * k_Pi * RadicalInverse(static_cast<std::uint32_t>(i));
        samples.push_back(
            {{side * std::cos(angle), side * std::sin(angle), z},
             static_cast<float>(z),
             static_cast<std::size_t>(std::clamp(level, 0.0, static_cast<double>(levels - 1)))});
        weights += z;
    }
    for (Sample& sample : samples)
    {
        sample.weight = static_cast<float>(static_cast<double>(sample.weight) / weights);
    }
    return samples;
}

glm::vec3 Mirrored(const glm::vec3& normal, const std::vector<Sample>& samples,
                   const std::vector<BorderedLight>& pictures)
{
    const glm::vec3 other = std::abs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(other, normal));
    const glm::vec3 up = glm::cross(normal, right);
    glm::vec3 sum(0.0f);
    for (const Sample& sample : samples)
    {
        const glm::vec3& d = sample.direction;
        sum += sample.weight * pictures[sample.level].Sample(d.x * right + d.y * up + d.z * normal);
    }
    return sum;
}

/// Sets each texel of a level, some rows in each of the machine's cores.
void FilterLevel(CubeLight& level, const std::vector<Sample>& samples,
                 const std::vector<BorderedLight>& pictures)
{
    static const std::size_t cores =
        std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, k_MostParts);
    const auto rows = static_cast<std::size_t>(k_CubeFaces * level.width);
    ForEachPart(rows, std::min(rows, cores),
                [&](std::size_t, std::size_t begin, std::size_t end)
                {
                    for (std::size_t row = begin; row < end; ++row)
                    {
                        const int face = static_cast<int>(row) / level.width;
                        const int y = static_cast<int>(row) % level.width;
                        for (int x = 0; x < level.width; ++x)
                        {
                            level.texels[level.Index(face, x, y)] = Mirrored(
                                glm::normalize(level.Direction(face, x, y)), samples, pictures);
                        }
                    }
                });
}

/// Returns the light and smaller and smaller pictures of it down to one texel a face.
std::vector<BorderedLight> MakePictures(const CubeLight& light)
{
    std::vector<BorderedLight> pictures{BorderedLight(light)};
    for (CubeLight smaller = light; smaller.width > 1;)
    {
        smaller = Halve(smaller);
        pictures.emplace_back(smaller);
    }
    return pictures;
}

} // namespace

double PerceptualRoughnessOfLevel(int level)
{
    const double part = static_cast<double>(level) / k_RoughestLevel;
    return (1.7 - std::sqrt(2.89 - 2.8 * part)) / 1.4;
}

std::vector<CubeLight> FilterReflection(const CubeLight& light)
{
    // The rougher, the fewer texels and the more samples for each.
    constexpr std::array k_Samples{0, 32, 128, 256, 512, 512, 1024};
    std::vector<CubeLight> levels{light};
    if (light.width == 1)
    {
        return levels;
    }
    const std::vector<BorderedLight> pictures = MakePictures(light);
    for (int level = 1; level <= k_RoughestLevel && (light.width >> level) > 0; ++level)
    {
        const std::vector<Sample> samples =
            MakeSamples(PerceptualRoughnessOfLevel(level),
                        k_Samples[static_cast<std::size_t>(level)], light.width, pictures.size());
        levels.emplace_back(light.width >> level);
        FilterLevel(levels.back(), samples, pictures);
    }
    return levels;
}

} // namespace limn

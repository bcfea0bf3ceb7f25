#include "cull/ObjectLights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limn/core/CoreUtils.h>

namespace limn
{

namespace
{

const ShaderPropertyId limn_LightCount{"limn_LightCount"};
const ShaderPropertyId unity_LightIndices{"unity_LightIndices"};

/// A list of lights, and the same list in the form that shaders take.
struct LightList
{
    glm::vec4 number{0.0f};
    std::array<glm::vec4, 2> indices{glm::vec4(0.0f), glm::vec4(0.0f)};

    explicit LightList(ObjectLights::Set lights)
    {
        std::size_t count = 0;
        for (int i = 0; lights != 0; ++i, lights >>= 1)
        {
            if ((lights & 1u) != 0)
            {
                indices[count / 4][static_cast<int>(count % 4)] = static_cast<float>(i);
                ++count;
            }
        }
        number.x = static_cast<float>(count);
    }
};

/// The square of the least distance, as shaders have it.
constexpr double k_NearestSquared = 6.103515625e-5; // HALF_MIN

} // namespace

ObjectLights::Place ObjectLights::PlaceOf(const Light& light)
{
    const glm::dmat4 world = light.transform.worldMatrix();
    const Color color = CoreUtils::ConvertSRGBToActiveColorSpace(light.color);
    const double angle = glm::radians(static_cast<double>(light.spotAngle)) * 0.5;
    const bool isSpot = light.type == LightType::Spot;
    return {glm::dvec3(world[3]),
            glm::normalize(glm::dvec3(world[2])),
            std::abs(static_cast<double>(light.intensity)) *
                static_cast<double>(std::max({color.r, color.g, color.b})),
            light.type == LightType::Directional ? -1.0 : static_cast<double>(light.range),
            std::sin(angle),
            isSpot ? std::cos(angle) : -1.0};
}

void ObjectLights::Begin(std::span<const Light* const> lights, int limit)
{
    constexpr std::size_t k_MostSets = 4096;
    m_IsNeeded = static_cast<int>(lights.size()) > limit && limit > 0;
    m_Limit = limit;
    m_Lights.clear();
    if (m_Values.size() > k_MostSets)
    {
        m_Values.clear();
    }
    if (m_IsNeeded)
    {
        std::ranges::transform(lights, std::back_inserter(m_Lights),
                               [](const Light* light) { return PlaceOf(*light); });
    }
}

double ObjectLights::Brightness(const Place& light, const glm::dvec3& center,
                                const glm::dvec3& extent)
{
    if (light.range < 0.0)
    {
        return light.intensity;
    }
    const glm::dvec3 offset = center - light.position;
    const glm::dvec3 gap = glm::max(glm::abs(offset) - extent, glm::dvec3(0.0));
    const double squared = std::max(glm::dot(gap, gap), k_NearestSquared);
    const double part = squared / (light.range * light.range);
    if (part >= 1.0)
    {
        return 0.0;
    }
    if (light.cosine > -1.0)
    {
        const double along = glm::dot(offset, light.direction);
        const double across = std::sqrt(std::max(glm::dot(offset, offset) - along * along, 0.0));
        // The nearest place of the cone is on its side, or its tip.
        const bool isBehind = across * light.sine + along * light.cosine < 0.0;
        const double distance =
            isBehind ? glm::length(offset) : across * light.cosine - along * light.sine;
        if (distance > glm::length(extent))
        {
            return 0.0;
        }
    }
    const double window = 1.0 - part * part;
    return light.intensity * window * window / squared;
}

ObjectLights::Set ObjectLights::Find(const glm::dvec3& center, const glm::dvec3& extent)
{
    m_Found.clear();
    for (std::size_t i = 0; i < m_Lights.size(); ++i)
    {
        const double brightness = Brightness(m_Lights[i], center, extent);
        if (brightness > 0.0)
        {
            m_Found.emplace_back(-brightness, static_cast<int>(i));
        }
    }
    const auto count = std::min(m_Found.size(), static_cast<std::size_t>(m_Limit));
    std::ranges::partial_sort(m_Found, m_Found.begin() + static_cast<std::ptrdiff_t>(count));
    Set set = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        set |= Set{1} << m_Found[i].second;
    }
    return set;
}

const MaterialPropertyBlock& ObjectLights::ValuesOf(Set lights)
{
    const auto [known, isNew] = m_Values.try_emplace(lights);
    if (isNew)
    {
        const LightList list(lights);
        known->second.SetVector(limn_LightCount, list.number);
        known->second.Set(unity_LightIndices,
                          PropertyArray(std::span<const glm::vec4>(list.indices)));
    }
    return known->second;
}

bool ReadsObjectLights(const ShaderProgram& program)
{
    return std::ranges::any_of(program.layout.buffers, [](const UniformBuffer& buffer)
                               { return buffer.name == "limn_ObjectLights"; });
}

void SetObjectLights(CommandBuffer& cmd, ObjectLights::Set lights)
{
    const LightList list(lights);
    cmd.SetGlobalVector(limn_LightCount, list.number);
    cmd.SetGlobalVectorArray(unity_LightIndices, std::span<const glm::vec4>(list.indices));
}

} // namespace limn

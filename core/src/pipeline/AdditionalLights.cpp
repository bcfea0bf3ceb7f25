#include "pipeline/AdditionalLights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limn/core/Light.h>

namespace limn
{

namespace
{

const ShaderPropertyId _AdditionalLightsCount{"_AdditionalLightsCount"};
const ShaderPropertyId _AdditionalLightsPosition{"_AdditionalLightsPosition"};
const ShaderPropertyId limn_AdditionalLightsPosition{"limn_AdditionalLightsPosition"};
const ShaderPropertyId _AdditionalLightsColor{"_AdditionalLightsColor"};
const ShaderPropertyId _AdditionalLightsAttenuation{"_AdditionalLightsAttenuation"};
const ShaderPropertyId _AdditionalLightsSpotDir{"_AdditionalLightsSpotDir"};
const GlobalKeyword _ADDITIONAL_LIGHTS{"_ADDITIONAL_LIGHTS"};

/// Whether a ball is not outside of one of the four sides of what the camera sees.
bool IsSeen(const glm::dvec3& center, double radius, const glm::dmat4& viewProjection)
{
    const glm::dmat4 rows = glm::transpose(viewProjection);
    for (int axis = 0; axis < 2; ++axis)
    {
        for (const double sign : {1.0, -1.0})
        {
            const glm::dvec4 plane = rows[3] + sign * rows[axis];
            const double distance = glm::dot(plane, glm::dvec4(center, 1.0));
            if (distance < -radius * glm::length(glm::dvec3(plane)))
            {
                return false;
            }
        }
    }
    return true;
}

struct LightArrays
{
    std::vector<glm::vec4> position;
    std::vector<glm::vec4> relativePosition; // to the camera's renderOrigin
    std::vector<glm::vec4> color;
    std::vector<glm::vec4> attenuation;
    std::vector<glm::vec4> spotDirection;

    /// @param origin  what relative positions are relative to
    void Add(const Light& light, const glm::dmat4& world, const glm::dvec3& origin)
    {
        const glm::vec4 forward(glm::vec3(glm::normalize(glm::dvec3(world[2]))), 0.0f);
        const bool isDirectional = light.type == LightType::Directional;
        position.push_back(isDirectional ? -forward : glm::vec4(world[3]));
        const glm::vec4 relative(glm::dvec4(glm::dvec3(world[3]) - origin, 1.0));
        relativePosition.push_back(isDirectional ? -forward : relative);
        color.emplace_back(glm::vec3(light.color.linear().vector()) * light.intensity, 1.0f);
        glm::vec4 fades(0.0f, 1.0f, 0.0f, 1.0f); // with neither distance nor angle
        if (!isDirectional)
        {
            fades.x = 1.0f / std::max(light.range * light.range, 1e-4f);
        }
        if (light.type == LightType::Spot)
        {
            const float outer = std::cos(glm::radians(light.spotAngle) * 0.5f);
            const float inner = std::cos(glm::radians(light.innerSpotAngle) * 0.5f);
            fades.z = 1.0f / std::max(inner - outer, 1e-3f);
            fades.w = -outer * fades.z;
        }
        attenuation.push_back(fades);
        spotDirection.push_back(-forward);
    }
};

} // namespace

void ForgetAdditionalLights(CommandBuffer& cmd)
{
    cmd.SetGlobalVector(_AdditionalLightsCount, glm::vec4(0.0f));
    cmd.DisableKeyword(_ADDITIONAL_LIGHTS);
}

void SetAdditionalLightUniforms(CommandBuffer& cmd, const RenderingData& renderingData,
                                std::vector<std::string>& notes)
{
    const CameraData& camera = renderingData.cameraData;
    const std::vector<Light>& lights = renderingData.scene->additionalLights;
    if (lights.empty())
    {
        return;
    }
    LightArrays arrays;
    const glm::dmat4 viewProjection = camera.reversedViewProjection();
    std::size_t seen = 0;
    for (const Light& light : lights)
    {
        const glm::dmat4 world = light.transform.worldMatrix();
        const bool isOn = light.intensity != 0.0f;
        const bool reaches =
            light.type == LightType::Directional ||
            (light.range > 0.0f &&
             IsSeen(glm::dvec3(world[3]), static_cast<double>(light.range), viewProjection));
        if (isOn && reaches && ++seen <= k_MaxVisibleAdditionalLights)
        {
            arrays.Add(light, world, camera.renderOrigin);
        }
    }
    if (seen == 0)
    {
        return;
    }
    if (seen > k_MaxVisibleAdditionalLights)
    {
        notes.push_back(std::to_string(seen) +
                        " lights reach into the picture, of which the first " +
                        std::to_string(k_MaxVisibleAdditionalLights) +
                        " are drawn: shaders have no room for more");
    }
    cmd.SetGlobalVector(_AdditionalLightsCount,
                        glm::vec4(static_cast<float>(arrays.position.size()), 0, 0, 0));
    cmd.SetGlobalVectorArray(_AdditionalLightsPosition, std::move(arrays.position));
    cmd.SetGlobalVectorArray(limn_AdditionalLightsPosition, std::move(arrays.relativePosition));
    cmd.SetGlobalVectorArray(_AdditionalLightsColor, std::move(arrays.color));
    cmd.SetGlobalVectorArray(_AdditionalLightsAttenuation, std::move(arrays.attenuation));
    cmd.SetGlobalVectorArray(_AdditionalLightsSpotDir, std::move(arrays.spotDirection));
    cmd.EnableKeyword(_ADDITIONAL_LIGHTS);
}

} // namespace limn

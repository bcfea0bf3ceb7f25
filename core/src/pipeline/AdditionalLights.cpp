#include "pipeline/AdditionalLights.h"

#include "cull/ObjectLights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limn/core/CoreUtils.h>
#include <limn/core/FixedList.h>
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

/// Returns whether a ball is within the four sides of the camera's view, or touches one.
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

Color Bright(const Color& color, float intensity)
{
    const Color active = CoreUtils::ConvertSRGBToActiveColorSpace(color);
    return {active.r * intensity, active.g * intensity, active.b * intensity, 1.0f};
}

struct LightArrays
{
    using Vectors = FixedList<glm::vec4, k_MaxVisibleAdditionalLights>;
    Vectors position;
    Vectors relativePosition; // to the camera's renderOrigin
    Vectors color;
    Vectors attenuation;
    Vectors spotDirection;

    /// @param origin  what relative positions are relative to
    void Add(const Light& light, const glm::dmat4& world, const glm::dvec3& origin)
    {
        const glm::vec4 forward(glm::vec3(glm::normalize(glm::dvec3(world[2]))), 0.0f);
        const bool isDirectional = light.type == LightType::Directional;
        position.push_back(isDirectional ? -forward : glm::vec4(world[3]));
        const glm::vec4 relative(glm::dvec4(glm::dvec3(world[3]) - origin, 1.0));
        relativePosition.push_back(isDirectional ? -forward : relative);
        color.push_back(Bright(light.color, light.intensity).vector());
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

std::span<const glm::vec4> Span(const LightArrays::Vectors& vectors)
{
    return {vectors.begin(), vectors.size()};
}

/// Left-handed axes of which z is the direction, and x level.
glm::dmat3 LookAlong(const glm::dvec3& direction)
{
    const glm::dvec3 z = glm::normalize(direction);
    const bool isUpright = std::abs(z.y) > 0.999;
    const glm::dvec3 x =
        glm::normalize(glm::cross(isUpright ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0), z));
    return {x, glm::cross(z, x), z};
}

} // namespace

void ForgetAdditionalLights(CommandBuffer& cmd)
{
    cmd.SetGlobalVector(_AdditionalLightsCount, glm::vec4(0.0f)); // shaders look at the smaller one
    cmd.DisableKeyword(_ADDITIONAL_LIGHTS);
}

void FindAdditionalLights(const Scene& scene, const CameraData& camera,
                          std::vector<const Light*>& lights, std::vector<std::string>& notes)
{
    lights.clear();
    if (scene.additionalLights.empty())
    {
        return;
    }
    const glm::dmat4 viewProjection = camera.reversedViewProjection();
    for (const Light& light : scene.additionalLights)
    {
        const bool isOn = light.intensity != 0.0f;
        const bool reaches =
            light.type == LightType::Directional ||
            (light.range > 0.0f && IsSeen(glm::dvec3(light.transform.worldMatrix()[3]),
                                          static_cast<double>(light.range), viewProjection));
        if (isOn && reaches)
        {
            lights.push_back(&light);
        }
    }
    if (lights.size() > k_MaxVisibleAdditionalLights)
    {
        notes.push_back(std::to_string(lights.size()) +
                        " lights reach into the picture, but only the first " +
                        std::to_string(k_MaxVisibleAdditionalLights) +
                        " light it: shaders have room for no more");
        lights.resize(k_MaxVisibleAdditionalLights);
    }
}

void SetAdditionalLightUniforms(ScriptableRenderContext& context, CommandBuffer& cmd,
                                const RenderingData& renderingData)
{
    const std::span<const Light* const> lights = renderingData.lightData.additionalLights;
    const int limit = renderingData.lightData.maxPerObjectAdditionalLightsCount;
    context.SetObjectLights(lights, limit);
    if (lights.empty() || limit == 0)
    {
        return;
    }
    LightArrays arrays;
    for (const Light* light : lights)
    {
        arrays.Add(*light, light->transform.worldMatrix(), renderingData.cameraData.renderOrigin);
    }
    cmd.SetGlobalVector(_AdditionalLightsCount, glm::vec4(static_cast<float>(limit), 0, 0, 0));
    SetObjectLights(cmd, ObjectLights::FirstOf(std::min(static_cast<int>(lights.size()), limit)));
    cmd.SetGlobalVectorArray(_AdditionalLightsPosition, Span(arrays.position));
    cmd.SetGlobalVectorArray(limn_AdditionalLightsPosition, Span(arrays.relativePosition));
    cmd.SetGlobalVectorArray(_AdditionalLightsColor, Span(arrays.color));
    cmd.SetGlobalVectorArray(_AdditionalLightsAttenuation, Span(arrays.attenuation));
    cmd.SetGlobalVectorArray(_AdditionalLightsSpotDir, Span(arrays.spotDirection));
    cmd.EnableKeyword(_ADDITIONAL_LIGHTS);
}

std::vector<VisibleLight> LightData::visibleLights() const
{
    std::vector<VisibleLight> visible;
    if (mainLightIndex >= 0)
    {
        const DirectionalLight& main = scene->mainLight;
        VisibleLight light;
        light.finalColor = Bright(main.color, main.intensity);
        light.localToWorldMatrix = glm::dmat4(LookAlong(glm::dvec3(main.direction)));
        visible.push_back(light);
    }
    for (const Light* light : additionalLights)
    {
        const bool isDirectional = light->type == LightType::Directional;
        const bool isSpot = light->type == LightType::Spot;
        visible.push_back({light, light->type, Bright(light->color, light->intensity),
                           light->transform.worldMatrix(), isDirectional ? 0.0f : light->range,
                           isSpot ? light->spotAngle : 0.0f});
    }
    return visible;
}

} // namespace limn

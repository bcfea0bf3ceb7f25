#include "shadows/AdditionalLightsShadowCasterPass.h"

#include "passes/CameraUniforms.h"
#include "shadows/ShadowCascades.h"
#include "texture/ScaledTexture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <limn/core/Camera.h>
#include <limn/core/CommandBuffer.h>
#include <limn/core/CoreUtils.h>

namespace limn
{

namespace
{

const GlobalKeyword _ADDITIONAL_LIGHT_SHADOWS{"_ADDITIONAL_LIGHT_SHADOWS"};
const GlobalKeyword _CASTING_PUNCTUAL_LIGHT_SHADOW{"_CASTING_PUNCTUAL_LIGHT_SHADOW"};
const GlobalKeyword k_SoftShadows{"_SHADOWS_SOFT"};
const ShaderPropertyId _AdditionalLightsShadowmapTexture{"_AdditionalLightsShadowmapTexture"};
const ShaderPropertyId _AdditionalLightsWorldToShadow{"_AdditionalLightsWorldToShadow"};
const ShaderPropertyId limn_OriginToAdditionalShadow{"limn_OriginToAdditionalShadow"};
const ShaderPropertyId _AdditionalShadowParams{"_AdditionalShadowParams"};
const ShaderPropertyId _AdditionalShadowOffset0{"_AdditionalShadowOffset0"};
const ShaderPropertyId _AdditionalShadowOffset1{"_AdditionalShadowOffset1"};
const ShaderPropertyId _AdditionalShadowFadeParams{"_AdditionalShadowFadeParams"};
const ShaderPropertyId _AdditionalShadowmapSize{"_AdditionalShadowmapSize"};
const ShaderPropertyId k_ShadowBias{"_ShadowBias"};
const ShaderPropertyId _LightPosition{"_LightPosition"};
const ShaderPropertyId limn_LightPosition{"limn_LightPosition"};

/// The number of squares for which shaders have room.
constexpr std::size_t k_MostSlices = 64;
constexpr std::size_t k_CubeSides = 6;
// Squares smaller than these, texels along a side, do not look like shadows (URP's).
constexpr int k_LeastOfHard = 8;
constexpr int k_LeastOfSoft = 16;

bool ThrowsShadows(const Light& light)
{
    return light.type != LightType::Directional && light.shadows != LightShadows::None &&
           light.shadowStrength > 0.0f && GivesLight(light);
}

bool ReceivesAdditionalShadows(const Shader& shader)
{
    return shader.HasKeyword(_ADDITIONAL_LIGHT_SHADOWS.name());
}

/// Returns whether a visible object that is near enough to camera and light can show the light's
/// shadow.
bool HasReceiverOf(const Light& light, const RendererItems& items, const glm::dvec3& camera,
                   double shadowDistance)
{
    const glm::dvec3 place(light.transform.worldMatrix()[3]);
    const auto isNear = [&](const RendererTable& table, std::uint32_t row)
    {
        const glm::dvec3 middle = table.origin() + glm::dvec3(table.center(row));
        const auto reaches = [&](const glm::dvec3& from, double distance)
        {
            const glm::dvec3 gap =
                glm::max(glm::abs(middle - from) - glm::dvec3(table.extent(row)), 0.0);
            return glm::length(gap) <= distance;
        };
        return reaches(place, static_cast<double>(light.range)) && reaches(camera, shadowDistance);
    };
    return HasReceiver(items, ReceivesAdditionalShadows, isNear);
}

/// World to light space, right-handed, looking along -z.
glm::dmat4 LookAlong(const glm::dvec3& place, const glm::dvec3& forward, const glm::dvec3& up)
{
    const glm::dvec3 right = glm::normalize(glm::cross(up, forward));
    const glm::dmat3 axes = glm::transpose(glm::dmat3(right, glm::cross(forward, right), -forward));
    glm::dmat4 view(axes);
    view[3] = glm::dvec4(-(axes * place), 1.0);
    return view;
}

glm::dmat4 SpotView(const Light& light)
{
    const glm::dmat4 world = light.transform.worldMatrix();
    return LookAlong(glm::dvec3(world[3]), glm::normalize(glm::dvec3(world[2])),
                     glm::dvec3(world[1]));
}
/// @param side  of a cube: +X, -X, +Y, -Y, +Z, -Z
glm::dmat4 SideView(const Light& light, std::size_t side)
{
    glm::dvec3 forward(0.0);
    forward[static_cast<int>(side / 2)] = side % 2 == 0 ? 1.0 : -1.0;
    const glm::dvec3 up = side / 2 == 1 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    return LookAlong(glm::dvec3(light.transform.worldMatrix()[3]), forward, up);
}

/// Light space to clip space.
/// @param slope  of what is seen at the side, metres across per metre away
glm::dmat4 Projection(const Light& light, double slope, bool usesReversedZBuffer)
{
    const auto farthest = static_cast<double>(light.range);
    const double nearest =
        std::min(std::max(static_cast<double>(light.shadowNearPlane), 0.01), farthest * 0.5);
    const double depth = farthest - nearest;
    glm::dmat4 projection(0.0);
    projection[0][0] = projection[1][1] = 1.0 / slope;
    projection[2][2] = usesReversedZBuffer ? nearest / depth : -farthest / depth;
    projection[3][2] = (usesReversedZBuffer ? 1.0 : -1.0) * farthest * nearest / depth;
    projection[2][3] = -1.0;
    return projection;
}

} // namespace

AdditionalLightsShadowCasterPass::AdditionalLightsShadowCasterPass()
{
    profilingSampler = ProfilingSampler("AdditionalLightsShadow");
    renderPassEvent = RenderPassEvent::BeforeRenderingShadows;
}

bool AdditionalLightsShadowCasterPass::Setup(const RenderingData& renderingData)
{
    m_Slices.clear();
    const ShadowSettings& settings = renderingData.shadowSettings;
    const auto lights = renderingData.lightData.additionalLights;
    const bool mayThrow =
        settings.additionalLightShadowsSupported &&
        renderingData.lightData.maxPerObjectAdditionalLightsCount > 0 &&
        std::ranges::any_of(lights, [](const Light* light) { return ThrowsShadows(*light); });
    if (mayThrow)
    {
        ExpectValid(settings);
        FindSlices(renderingData);
        PlaceSlices(renderingData);
    }
    if (m_Slices.empty())
    {
        m_ShadowMap = {};
        return false;
    }
    const int size = settings.additionalLightsShadowmapResolution;
    AllocateTransient(m_ShadowMap, {size, size, GraphicsFormat::D32_SFloat},
                      "_AdditionalLightsShadowmapTexture", FilterMode::Bilinear);
    ConfigureTarget(m_ShadowMap);
    ConfigureClear(ClearFlag::Depth, Color::black);
    return true;
}

/// Lights of which a square sees something that throws shadows, in their order.
void AdditionalLightsShadowCasterPass::FindSlices(const RenderingData& renderingData)
{
    const auto lights = renderingData.lightData.additionalLights;
    const Camera& camera = *renderingData.cameraData.camera;
    const glm::dvec3 cameraPlace(camera.transform.worldMatrix()[3]);
    const double distance = ShadowDistance(camera, renderingData.shadowSettings);
    std::size_t leftOut = 0;
    for (std::size_t i = 0; i < lights.size(); ++i)
    {
        const Light& light = *lights[i];
        if (!ThrowsShadows(light) ||
            !HasReceiverOf(light, renderingData.cullResults.items, cameraPlace, distance))
        {
            continue;
        }
        const bool isSpot = light.type == LightType::Spot;
        const std::size_t count = isSpot ? 1 : k_CubeSides;
        const std::size_t first = m_Slices.size();
        bool hasCasters = false;
        for (std::size_t side = 0; side < count; ++side)
        {
            Slice& slice = m_Slices.emplace_back();
            slice.light = i;
            slice.view = isSpot ? SpotView(light) : SideView(light, side);
            slice.halfAngle =
                glm::radians(isSpot ? static_cast<double>(light.spotAngle) * 0.5 : 45.0);
            const double slope = std::tan(slice.halfAngle);
            const glm::dmat4 toLight = Projection(light, slope, true) * slice.view;
            slice.casters = FindShadowCasters(renderingData.cullResults, camera, toLight);
            hasCasters = hasCasters || !slice.casters.isEmpty();
        }
        if (!hasCasters || m_Slices.size() > k_MostSlices)
        {
            leftOut += hasCasters ? 1 : 0;
            m_Slices.resize(first);
        }
    }
    if (leftOut > 0)
    {
        renderingData.report->notes.push_back(
            (leftOut == 1 ? "1 light throws no shadows: shaders"
                          : std::to_string(leftOut) + " lights throw no shadows: shaders") +
            " have room for " + std::to_string(k_MostSlices) +
            " squares; a spot takes 1 and a point 6");
    }
}

/// Each sees a few texels more than its light, so that filters find what they look for within it
/// (URP's bias of a point's field of view).
void AdditionalLightsShadowCasterPass::PlaceSlices(const RenderingData& renderingData)
{
    const ShadowSettings& settings = renderingData.shadowSettings;
    const auto lights = renderingData.lightData.additionalLights;
    m_Requests.clear();
    for (std::size_t i = 0; i < m_Slices.size(); ++i)
    {
        if (i > 0 && m_Slices[i].light == m_Slices[i - 1].light)
        {
            ++m_Requests.back().count;
            continue;
        }
        const Light& light = *lights[m_Slices[i].light];
        const bool isSoft = SoftnessOf(LookOf(light), settings) > 0;
        m_Requests.push_back(
            {ResolutionOf(light, TiersOf(settings)), isSoft ? k_LeastOfSoft : k_LeastOfHard, 1});
    }
    PlaceShadowSquares(m_Requests, settings.additionalLightsShadowmapResolution, m_Tiles);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < m_Slices.size(); ++i)
    {
        const int side = m_Tiles[i].width;
        if (side == 0)
        {
            continue;
        }
        if (kept != i)
        {
            m_Slices[kept] = std::move(m_Slices[i]);
        }
        Slice& slice = m_Slices[kept++];
        const Light& light = *lights[slice.light];
        slice.tile = m_Tiles[i];
        const double margin = SoftnessOf(LookOf(light), settings) + 1.5; // texels
        slice.slope = std::tan(slice.halfAngle) / (1.0 - 2.0 * margin / std::max(side, 16));
        slice.texelSize = slice.slope * static_cast<double>(light.range) / side;
    }
    if (kept < m_Slices.size())
    {
        renderingData.report->notes.push_back(
            "some lights throw no shadows: the shadow map of " +
            std::to_string(settings.additionalLightsShadowmapResolution) +
            " texels has room for only " + std::to_string(kept) + " of " +
            std::to_string(m_Slices.size()) + " squares of the least size");
        m_Slices.resize(kept);
    }
}

void AdditionalLightsShadowCasterPass::Forget(CommandBuffer& cmd)
{
    cmd.DisableKeyword(_ADDITIONAL_LIGHT_SHADOWS);
}

void AdditionalLightsShadowCasterPass::Execute(ScriptableRenderContext& context,
                                               RenderingData& renderingData)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    SetOriginUniforms(*cmd, renderingData.cameraData);
    // Lighter than light, as MainLightShadowCasterPass does it.
    cmd->SetGlobalDepthBias(1.0f, 2.5f);
    cmd->EnableKeyword(_CASTING_PUNCTUAL_LIGHT_SHADOW);
    context.ExecuteCommandBuffer(*cmd);
    for (const Slice& slice : m_Slices)
    {
        DrawSlice(context, renderingData, slice);
    }
    cmd->Clear();
    cmd->SetGlobalDepthBias(0.0f, 0.0f);
    cmd->DisableKeyword(_CASTING_PUNCTUAL_LIGHT_SHADOW);
    SetReceiverConstants(*cmd, renderingData);
    context.ExecuteCommandBuffer(*cmd);
    m_Slices.clear();
}

void AdditionalLightsShadowCasterPass::DrawSlice(ScriptableRenderContext& context,
                                                 RenderingData& renderingData,
                                                 const Slice& slice) const
{
    const CameraData& data = renderingData.cameraData;
    const Light& light = *renderingData.lightData.additionalLights[slice.light];
    const glm::dvec3 place(light.transform.worldMatrix()[3]);
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    cmd->SetViewport(slice.tile);
    RenderingUtils::SetViewAndProjectionMatrices(
        *cmd, slice.view,
        WithFlippedY(glm::mat4(Projection(light, slice.slope, data.usesReversedZBuffer))), false);
    cmd->SetGlobalVector(k_ShadowBias,
                         ShadowBias(LookOf(light), renderingData.shadowSettings, slice.texelSize));
    cmd->SetGlobalVector(_LightPosition, glm::vec4(glm::vec3(place), 1.0f));
    cmd->SetGlobalVector(limn_LightPosition, glm::vec4(glm::vec3(place - data.renderOrigin), 1.0f));
    context.ExecuteCommandBuffer(*cmd);
    DrawShadowCasters(context, renderingData, slice.casters);
}

void AdditionalLightsShadowCasterPass::SetReceiverConstants(
    CommandBuffer& cmd, const RenderingData& renderingData) const
{
    const ShadowSettings& settings = renderingData.shadowSettings;
    const CameraData& data = renderingData.cameraData;
    const auto size = static_cast<float>(settings.additionalLightsShadowmapResolution);
    std::array<glm::mat4, k_MostSlices> matrices;
    std::array<glm::vec4, k_MostSlices> fromOrigin;
    std::array<glm::vec4, k_MaxVisibleAdditionalLights> params;
    params.fill(glm::vec4(0.0f, 0.0f, 0.0f, -1.0f));
    bool isSoft = false;
    for (std::size_t i = m_Slices.size(); i-- > 0;) // a point's first one last
    {
        const Slice& slice = m_Slices[i];
        const Light& light = *renderingData.lightData.additionalLights[slice.light];
        const glm::dmat4 toShadow = ToTexture(slice.tile, glm::dvec2(size)) *
                                    Projection(light, slice.slope, data.usesReversedZBuffer) *
                                    slice.view;
        matrices[i] = glm::mat4(toShadow);
        fromOrigin[i] = glm::vec4(toShadow * glm::dvec4(data.renderOrigin, 1.0));
        const int softness = SoftnessOf(LookOf(light), settings);
        isSoft = isSoft || softness > 0;
        params[slice.light] = {light.shadowStrength, static_cast<float>(softness),
                               light.type == LightType::Point ? 1.0f : 0.0f, static_cast<float>(i)};
    }
    cmd.SetGlobalTexture(_AdditionalLightsShadowmapTexture, m_ShadowMap);
    cmd.SetGlobalMatrixArray(_AdditionalLightsWorldToShadow,
                             std::span<const glm::mat4>(matrices.data(), m_Slices.size()));
    cmd.SetGlobalVectorArray(limn_OriginToAdditionalShadow,
                             std::span<const glm::vec4>(fromOrigin.data(), m_Slices.size()));
    cmd.SetGlobalVectorArray(
        _AdditionalShadowParams,
        std::span<const glm::vec4>(params.data(), renderingData.lightData.additionalLights.size()));
    const glm::vec2 fade = FadeScaleAndBias(ShadowDistance(*data.camera, settings),
                                            static_cast<double>(settings.cascadeBorder));
    cmd.SetGlobalVector(_AdditionalShadowFadeParams, {fade.x, fade.y, 0.0f, 0.0f});
    const float half = 0.5f / size;
    cmd.SetGlobalVector(_AdditionalShadowOffset0, {-half, -half, half, -half});
    cmd.SetGlobalVector(_AdditionalShadowOffset1, {-half, half, half, half});
    cmd.SetGlobalVector(_AdditionalShadowmapSize, {1.0f / size, 1.0f / size, size, size});
    cmd.EnableKeyword(_ADDITIONAL_LIGHT_SHADOWS);
    if (isSoft)
    {
        cmd.EnableKeyword(k_SoftShadows);
    }
}

} // namespace limn

#include "shadows/MainLightShadowCasterPass.h"

#include "passes/CameraUniforms.h"
#include "scene/PerDraw.h"
#include "texture/ScaledTexture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limn/core/Camera.h>
#include <limn/core/CommandBuffer.h>
#include <limn/core/CoreUtils.h>

namespace limn
{

namespace
{

const GlobalKeyword _MAIN_LIGHT_SHADOWS{"_MAIN_LIGHT_SHADOWS"};
const GlobalKeyword _MAIN_LIGHT_SHADOWS_CASCADE{"_MAIN_LIGHT_SHADOWS_CASCADE"};
const GlobalKeyword _SHADOWS_SOFT{"_SHADOWS_SOFT"};
const ShaderPropertyId _MainLightShadowmapTexture{"_MainLightShadowmapTexture"};
const ShaderPropertyId _MainLightWorldToShadow{"_MainLightWorldToShadow"};
const ShaderPropertyId limn_OriginToShadow{"limn_OriginToShadow"};
const ShaderPropertyId _MainLightShadowParams{"_MainLightShadowParams"};
const ShaderPropertyId _MainLightShadowOffset0{"_MainLightShadowOffset0"};
const ShaderPropertyId _MainLightShadowOffset1{"_MainLightShadowOffset1"};
const ShaderPropertyId _MainLightShadowmapSize{"_MainLightShadowmapSize"};
const ShaderPropertyId _CascadeShadowSplitSphereRadii{"_CascadeShadowSplitSphereRadii"};
const ShaderPropertyId limn_CascadeCenters{"limn_CascadeCenters"};
const ShaderPropertyId _ShadowBias{"_ShadowBias"};
const ShaderPropertyId _LightDirection{"_LightDirection"};

const ShaderPropertyId k_SplitSpheres[k_MostCascades] = {
    ShaderPropertyId("_CascadeShadowSplitSpheres0"),
    ShaderPropertyId("_CascadeShadowSplitSpheres1"),
    ShaderPropertyId("_CascadeShadowSplitSpheres2"),
    ShaderPropertyId("_CascadeShadowSplitSpheres3")};

/// The greatest distance before the ball from which shadows are thrown. Casters that lie farther
/// away are moved there, because the depth would become coarse.
constexpr double k_MostBallsAhead = 64.0;

bool ReceivesShadows(const Shader& shader)
{
    return shader.HasKeyword(_MAIN_LIGHT_SHADOWS.name()) ||
           shader.HasKeyword(_MAIN_LIGHT_SHADOWS_CASCADE.name());
}

/// The distance along the light, from the view's origin, at which the first of them begins.
double NearestOf(const CullingResults& casters, const glm::dmat4& view)
{
    double nearest = 0.0;
    if (casters.items.empty())
    {
        return nearest;
    }
    const RendererTable& table = *casters.items.table();
    const glm::dmat4 relative = RelativeTo(table.origin(), view);
    const glm::dvec3 along = -glm::dvec3(relative[0][2], relative[1][2], relative[2][2]);
    for (const std::uint32_t row : casters.items.rows())
    {
        const double middle = glm::dot(along, glm::dvec3(table.center(row))) - relative[3][2];
        const double reach = glm::dot(glm::abs(along), glm::dvec3(table.extent(row)));
        nearest = std::min(nearest, middle - reach);
    }
    return nearest;
}

} // namespace

MainLightShadowCasterPass::MainLightShadowCasterPass()
{
    profilingSampler = ProfilingSampler("MainLightShadow");
    renderPassEvent = RenderPassEvent::BeforeRenderingShadows;
}

bool MainLightShadowCasterPass::Setup(const RenderingData& renderingData)
{
    m_Cascades.clear();
    m_Casters = {};
    if (!FindCascades(renderingData))
    {
        m_Cascades.clear();
        m_ShadowMap = {};
        return false;
    }
    const glm::ivec2 size = ShadowMapSize(renderingData.shadowSettings);
    AllocateTransient(m_ShadowMap, {size.x, size.y, GraphicsFormat::D32_SFloat},
                      "_MainLightShadowmapTexture", FilterMode::Bilinear);
    ConfigureTarget(m_ShadowMap);
    ConfigureClear(ClearFlag::Depth, Color::black);
    return true;
}

/// Returns whether something throws shadows into a cascade, onto something that is seen.
bool MainLightShadowCasterPass::FindCascades(const RenderingData& renderingData)
{
    const ShadowSettings& settings = renderingData.shadowSettings;
    const Scene* scene = renderingData.scene;
    if (scene == nullptr || scene->mainLight.shadows == LightShadows::None ||
        !settings.mainLightShadowsSupported || scene->mainLight.shadowStrength <= 0.0f ||
        !GivesLight(scene->mainLight))
    {
        return false;
    }
    ExpectValid(settings);
    const CameraData& data = renderingData.cameraData;
    const Camera& camera = *data.camera;
    const glm::dvec3 position(camera.transform.worldMatrix()[3]);
    const auto distance = static_cast<float>(ShadowDistance(camera, settings));
    const RendererItems& items = renderingData.cullResults.items;
    const glm::vec3 from(items.empty() ? position : position - items.table()->origin());
    const auto isNear = [&](const RendererTable& table, std::uint32_t row)
    {
        return glm::distance(table.center(row), from) - glm::length(table.extent(row)) <= distance;
    };
    if (!HasReceiver(items, ReceivesShadows, isNear))
    {
        return false;
    }
    const float aspect = static_cast<float>(data.cameraTargetDescriptor.width) /
                         static_cast<float>(data.cameraTargetDescriptor.height);
    m_Cascades =
        MakeShadowCascades(camera, aspect, glm::dvec3(scene->mainLight.direction), settings);
    bool hasCasters = false;
    for (std::size_t i = 0; i < m_Cascades.size(); ++i)
    {
        ShadowCascade& cascade = m_Cascades[i];
        ShadowCasters& casters = m_Casters[i];
        const glm::dmat4 toLight = cascade.Projection(true) * cascade.view;
        casters = FindShadowCasters(renderingData.cullResults, camera, toLight);
        hasCasters = hasCasters || !casters.isEmpty();
        const double first = std::min(NearestOf(casters.plain, cascade.view),
                                      NearestOf(casters.twoSided, cascade.view));
        cascade.nearest =
            std::max(std::min(cascade.nearest, first * 1.01), -k_MostBallsAhead * cascade.radius);
    }
    return hasCasters;
}

void MainLightShadowCasterPass::Forget(CommandBuffer& cmd)
{
    cmd.DisableKeyword(_MAIN_LIGHT_SHADOWS);
    cmd.DisableKeyword(_MAIN_LIGHT_SHADOWS_CASCADE);
}

void MainLightShadowCasterPass::Execute(ScriptableRenderContext& context,
                                        RenderingData& renderingData)
{
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    SetOriginUniforms(*cmd, renderingData.cameraData);
    // Lighter than light: of the slope across a texel, and one step, as URP has it.
    cmd->SetGlobalDepthBias(1.0f, 2.5f);
    context.ExecuteCommandBuffer(*cmd);
    for (std::size_t i = 0; i < m_Cascades.size(); ++i)
    {
        DrawCascade(context, renderingData, i);
    }
    cmd->Clear();
    cmd->SetGlobalDepthBias(0.0f, 0.0f);
    SetReceiverConstants(*cmd, renderingData);
    context.ExecuteCommandBuffer(*cmd);
    m_Casters = {};
}

void MainLightShadowCasterPass::DrawCascade(ScriptableRenderContext& context,
                                            RenderingData& renderingData, std::size_t index) const
{
    const ShadowCascade& cascade = m_Cascades[index];
    const CameraData& data = renderingData.cameraData;
    const DirectionalLight& light = renderingData.scene->mainLight;
    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    cmd->SetViewport(cascade.tile);
    RenderingUtils::SetViewAndProjectionMatrices(
        *cmd, cascade.view, WithFlippedY(glm::mat4(cascade.Projection(data.usesReversedZBuffer))),
        false);
    cmd->SetGlobalVector(
        _ShadowBias, ShadowBias(LookOf(light), renderingData.shadowSettings, cascade.TexelSize()));
    cmd->SetGlobalVector(_LightDirection, glm::vec4(-light.direction, 0.0f));
    context.ExecuteCommandBuffer(*cmd);
    DrawShadowCasters(context, renderingData, m_Casters[index]);
}

void MainLightShadowCasterPass::SetReceiverConstants(CommandBuffer& cmd,
                                                     const RenderingData& renderingData) const
{
    const ShadowSettings& settings = renderingData.shadowSettings;
    const DirectionalLight& light = renderingData.scene->mainLight;
    const Camera& camera = *renderingData.cameraData.camera;
    const glm::dvec3& origin = renderingData.cameraData.renderOrigin;
    const glm::ivec2 size = ShadowMapSize(settings);

    std::array<glm::mat4, k_MostCascades + 1> matrices; // the last one: no shadow
    matrices.fill(glm::mat4(0.0f));
    std::array<glm::vec4, k_MostCascades + 1> fromOrigin{};
    std::array<glm::vec4, k_MostCascades> centers{};
    glm::vec4 radii(0.0f);
    for (std::size_t i = 0; i < m_Cascades.size(); ++i)
    {
        const ShadowCascade& cascade = m_Cascades[i];
        const glm::dmat4 toShadow =
            ToTexture(cascade.tile, glm::dvec2(size)) *
            cascade.Projection(renderingData.cameraData.usesReversedZBuffer) * cascade.view;
        matrices[i] = glm::mat4(toShadow);
        fromOrigin[i] = glm::vec4(toShadow * glm::dvec4(origin, 1.0));
        centers[i] = glm::vec4(glm::vec3(cascade.center - origin), 0.0f);
        radii[static_cast<int>(i)] = static_cast<float>(cascade.radius * cascade.radius);
        cmd.SetGlobalVector(k_SplitSpheres[i],
                            glm::vec4(glm::vec3(cascade.center), radii[static_cast<int>(i)]));
    }
    cmd.SetGlobalTexture(_MainLightShadowmapTexture, m_ShadowMap);
    cmd.SetGlobalMatrixArray(_MainLightWorldToShadow, std::span<const glm::mat4>(matrices));
    cmd.SetGlobalVectorArray(limn_OriginToShadow, std::span<const glm::vec4>(fromOrigin));
    cmd.SetGlobalVectorArray(limn_CascadeCenters, std::span<const glm::vec4>(centers));
    cmd.SetGlobalVector(_CascadeShadowSplitSphereRadii, radii);

    const int softness = SoftnessOf(LookOf(light), settings);
    const glm::vec2 fade = FadeScaleAndBias(ShadowDistance(camera, settings),
                                            static_cast<double>(settings.cascadeBorder));
    cmd.SetGlobalVector(_MainLightShadowParams,
                        {light.shadowStrength, static_cast<float>(softness), fade.x, fade.y});
    const glm::vec2 texel = 1.0f / glm::vec2(size);
    const glm::vec2 half = 0.5f * texel;
    cmd.SetGlobalVector(_MainLightShadowOffset0, {-half.x, -half.y, half.x, -half.y});
    cmd.SetGlobalVector(_MainLightShadowOffset1, {-half.x, half.y, half.x, half.y});
    cmd.SetGlobalVector(_MainLightShadowmapSize, {texel.x, texel.y, size.x, size.y});
    cmd.EnableKeyword(m_Cascades.size() > 1 ? _MAIN_LIGHT_SHADOWS_CASCADE : _MAIN_LIGHT_SHADOWS);
    cmd.SetKeyword(_SHADOWS_SOFT, softness > 0);
}

} // namespace limn

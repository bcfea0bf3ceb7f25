#include <algorithm>
#include <limn/core/Inspector.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/Features.h>
#include <limn/features/RenderObjects.h>
#include <limn/features/RenderObjectsPass.h>

namespace limn
{

namespace
{

constexpr EnumEntry k_OverrideModes[] = {{"None", 0}, {"Material", 1}, {"Shader", 2}};
constexpr ValueRange k_PassIndices{0, 255};
constexpr std::size_t k_MaxPassNames = 16; ///< of DrawingSettings
constexpr float k_MaxOffset = 1e9f;        ///< metres; as far as scenes go

void DescribeOverrides(RenderObjectsSettings& settings, Inspector& inspector)
{
    inspector.Header("Overrides");
    inspector.Field("overrideMode", settings.overrideMode, k_OverrideModes,
                    "The choice between the objects' own materials, one material, and one shader");
    inspector.Field("overrideMaterial", settings.overrideMaterial,
                    "Mode Material: the material that replaces each object's own; without one "
                    "nothing is replaced");
    inspector.Field("overrideMaterialPassIndex", settings.overrideMaterialPassIndex, k_PassIndices,
                    "The index of the material's pass, from 0");
    inspector.Field(
        "overrideShader", settings.overrideShader,
        "Mode Shader: the shader, which gets the properties of each object's own material");
    inspector.Field("overrideShaderPassIndex", settings.overrideShaderPassIndex, k_PassIndices,
                    "The index of the shader's pass, from 0");
    inspector.Field("overrideDepthState", settings.overrideDepthState,
                    "Replaces the passes' ZTest and ZWrite with the next two settings");
    inspector.Field("depthCompareFunction", settings.depthCompareFunction, CompareFunctionEntries(),
                    "ZTest");
    inspector.Field("enableWrite", settings.enableWrite, "ZWrite");
}

void DescribeCamera(RenderObjectsSettings::CustomCameraSettings& camera, Inspector& inspector)
{
    inspector.BeginGroup("cameraSettings");
    inspector.Field("overrideCamera", camera.overrideCamera,
                    "Draws the objects through a camera of their own");
    inspector.Field("restoreCamera", camera.restoreCamera,
                    "Gives later passes the scene's camera again");
    inspector.Field("offset", camera.offset,
                    "The shift in view space, in metres; +z brings the objects nearer");
    inspector.Field("cameraFieldOfView", camera.cameraFieldOfView, {4, 179},
                    "The vertical field of view in degrees");
    inspector.EndGroup();
}

void ExpectFilterAndCamera(const std::string& feature, const RenderObjectsSettings& settings)
{
    const std::size_t names = settings.filterSettings.PassNames.size();
    if (names > k_MaxPassNames)
    {
        throw ContractError(feature + ": filterSettings.PassNames has " + std::to_string(names) +
                            " names; at most " + std::to_string(k_MaxPassNames) + " are drawn");
    }
    if (glm::any(
            glm::greaterThan(glm::abs(settings.cameraSettings.offset), glm::vec4(k_MaxOffset))))
    {
        throw ContractError(
            feature +
            ": cameraSettings.offset is more than 1e9 m; no picture shows objects so far away");
    }
}

void ExpectPass(const std::string& feature, const char* setting, int index, const Shader& shader)
{
    if (index < 0 || index >= shader.passCount())
    {
        throw ContractError(feature + ": " + setting + " is " + std::to_string(index) +
                            ", but the shader '" + shader.name() + "' has the passes 0..." +
                            std::to_string(shader.passCount() - 1));
    }
}

} // namespace

std::span<const EnumEntry> RenderQueueTypeEntries()
{
    static constexpr EnumEntry k_Entries[] = {{"Opaque", 0}, {"Transparent", 1}};
    return k_Entries;
}

void StencilStateData::Describe(Inspector& inspector)
{
    inspector.Field("overrideStencilState", overrideStencilState,
                    "Replaces the passes' whole Stencil block with these settings");
    inspector.Field("stencilReference", stencilReference, {0, 255}, "Ref");
    inspector.Field("stencilCompareFunction", stencilCompareFunction, CompareFunctionEntries(),
                    "Comp: the comparison of the reference with the stored value");
    inspector.Field("passOperation", passOperation, StencilOpEntries(),
                    "The operation where stencil and depth test pass");
    inspector.Field("failOperation", failOperation, StencilOpEntries(),
                    "The operation where the stencil test fails");
    inspector.Field("zFailOperation", zFailOperation, StencilOpEntries(),
                    "The operation where only the depth test fails");
}

void RenderObjectsSettings::Describe(Inspector& inspector)
{
    inspector.Field("passTag", passTag, "The name of the pass in captures and timings");
    inspector.Field("Event", Event, "The event of the frame at which the objects are drawn");

    inspector.Header("Filters");
    inspector.BeginGroup("filterSettings");
    inspector.Field("RenderQueueType", filterSettings.RenderQueueType, RenderQueueTypeEntries(),
                    "Opaque: queues up to 2500; Transparent: the ones above");
    inspector.Field("LayerMask", filterSettings.LayerMask,
                    "The layers of the objects that are drawn");
    inspector.Field(
        "PassNames", filterSettings.PassNames,
        "The LightMode tags of the passes to draw; an empty list takes URP's forward tags");
    inspector.EndGroup();

    DescribeOverrides(*this, inspector);
    inspector.Header("Stencil");
    inspector.BeginGroup("stencilSettings");
    stencilSettings.Describe(inspector);
    inspector.EndGroup();
    inspector.Header("Camera");
    DescribeCamera(cameraSettings, inspector);
}

RenderObjects::RenderObjects(RenderObjectsSettings renderObjectsSettings)
    : settings(std::move(renderObjectsSettings))
{
    name = "RenderObjects";
}

RenderObjects::~RenderObjects() = default;

void RenderObjects::Create()
{
    using Mode = RenderObjectsSettings::OverrideMaterialMode;
    settings.Event = std::max(settings.Event, RenderPassEvent::BeforeRenderingPrePasses);
    const RenderObjectsSettings::FilterSettings& filter = settings.filterSettings;
    ExpectFilterAndCamera(name, settings);
    m_RenderObjectsPass = std::make_unique<RenderObjectsPass>(
        settings.passTag, settings.Event, filter.PassNames, filter.RenderQueueType,
        filter.LayerMask, settings.cameraSettings);
    if (settings.overrideMode == Mode::Material && settings.overrideMaterial)
    {
        ExpectPass(name, "overrideMaterialPassIndex", settings.overrideMaterialPassIndex,
                   *settings.overrideMaterial->shader());
        m_RenderObjectsPass->overrideMaterial = settings.overrideMaterial;
        m_RenderObjectsPass->overrideMaterialPassIndex = settings.overrideMaterialPassIndex;
    }
    if (settings.overrideMode == Mode::Shader && settings.overrideShader)
    {
        ExpectPass(name, "overrideShaderPassIndex", settings.overrideShaderPassIndex,
                   *settings.overrideShader);
        m_RenderObjectsPass->overrideShader = settings.overrideShader;
        m_RenderObjectsPass->overrideShaderPassIndex = settings.overrideShaderPassIndex;
    }
    if (settings.overrideDepthState)
    {
        m_RenderObjectsPass->SetDepthState(settings.enableWrite, settings.depthCompareFunction);
    }
    if (settings.stencilSettings.overrideStencilState)
    {
        const StencilStateData& stencil = settings.stencilSettings;
        m_RenderObjectsPass->SetStencilState(stencil.stencilReference,
                                             stencil.stencilCompareFunction, stencil.passOperation,
                                             stencil.failOperation, stencil.zFailOperation);
    }
}

void RenderObjects::AddRenderPasses(ScriptableRenderer& renderer, RenderingData&)
{
    renderer.EnqueuePass(*m_RenderObjectsPass);
}

void RegisterRenderObjects(FeatureRegistry& features, VolumeComponentRegistry&)
{
    features.Register<RenderObjects>("RenderObjects");
}

} // namespace limn

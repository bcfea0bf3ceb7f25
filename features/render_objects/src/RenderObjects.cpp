#include <algorithm>
#include <limn/core/Inspector.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/RenderObjects.h>
#include <limn/features/RenderObjectsPass.h>

namespace limn
{

namespace
{

constexpr EnumEntry k_RenderQueueTypes[] = {{"Opaque", 0}, {"Transparent", 1}};
constexpr EnumEntry k_OverrideModes[] = {{"None", 0}, {"Material", 1}, {"Shader", 2}};
constexpr ValueRange k_PassIndices{0, 255};
constexpr std::size_t k_MaxPassNames = 16; ///< of DrawingSettings
constexpr float k_MaxOffset = 1e9f;        ///< metres; as far as scenes go

void DescribeOverrides(RenderObjectsSettings& settings, Inspector& inspector)
{
    inspector.Header("Overrides");
    inspector.Field(
        "overrideMode", settings.overrideMode, k_OverrideModes,
        "Whether objects keep their materials, or are drawn with one material or shader");
    inspector.Field("overrideMaterial", settings.overrideMaterial,
                    "In mode Material: drawn instead of each object's own; none = no override");
    inspector.Field("overrideMaterialPassIndex", settings.overrideMaterialPassIndex, k_PassIndices,
                    "Which pass of the material, counted from 0");
    inspector.Field("overrideShader", settings.overrideShader,
                    "In mode Shader: drawn with the properties of each object's own material");
    inspector.Field("overrideShaderPassIndex", settings.overrideShaderPassIndex, k_PassIndices,
                    "Which pass of the shader, counted from 0");
    inspector.Field("overrideDepthState", settings.overrideDepthState,
                    "Whether the next two settings replace the passes' ZTest and ZWrite");
    inspector.Field("depthCompareFunction", settings.depthCompareFunction, CompareFunctionEntries(),
                    "ZTest");
    inspector.Field("enableWrite", settings.enableWrite, "ZWrite");
}

void DescribeStencil(StencilStateData& stencil, Inspector& inspector)
{
    inspector.BeginGroup("stencilSettings");
    inspector.Field("overrideStencilState", stencil.overrideStencilState,
                    "Whether the settings here replace the passes' whole Stencil block");
    inspector.Field("stencilReference", stencil.stencilReference, {0, 255}, "Ref");
    inspector.Field("stencilCompareFunction", stencil.stencilCompareFunction,
                    CompareFunctionEntries(), "Comp: reference against stored value");
    inspector.Field("passOperation", stencil.passOperation, StencilOpEntries(),
                    "What becomes of the value where stencil and depth test pass");
    inspector.Field("failOperation", stencil.failOperation, StencilOpEntries(),
                    "What becomes of the value where the stencil test fails");
    inspector.Field("zFailOperation", stencil.zFailOperation, StencilOpEntries(),
                    "What becomes of the value where only the depth test fails");
    inspector.EndGroup();
}

void DescribeCamera(RenderObjectsSettings::CustomCameraSettings& camera, Inspector& inspector)
{
    inspector.BeginGroup("cameraSettings");
    inspector.Field("overrideCamera", camera.overrideCamera,
                    "Whether the objects are seen through a camera of their own");
    inspector.Field("restoreCamera", camera.restoreCamera,
                    "Whether later passes see through the scene's camera again");
    inspector.Field("offset", camera.offset,
                    "Added in view space, in metres: +z brings the objects nearer");
    inspector.Field("cameraFieldOfView", camera.cameraFieldOfView, {4, 179},
                    "Vertical field of view in degrees");
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
        throw ContractError(feature + ": cameraSettings.offset is more than 1e9 m; what is so far "
                                      "away is in no picture");
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

void RenderObjectsSettings::Describe(Inspector& inspector)
{
    inspector.Field("passTag", passTag, "What captures and timings call the pass");
    inspector.Field("Event", Event, "When in the frame the objects are drawn");

    inspector.Header("Filters");
    inspector.BeginGroup("filterSettings");
    inspector.Field("RenderQueueType", filterSettings.RenderQueueType, k_RenderQueueTypes,
                    "Opaque: queues up to 2500; Transparent: the ones above");
    inspector.Field("LayerMask", filterSettings.LayerMask, "Layers whose objects are drawn");
    inspector.Field("PassNames", filterSettings.PassNames,
                    "LightMode tags of the passes to draw; none = URP's forward tags");
    inspector.EndGroup();

    DescribeOverrides(*this, inspector);
    inspector.Header("Stencil");
    DescribeStencil(stencilSettings, inspector);
    inspector.Header("Camera");
    DescribeCamera(cameraSettings, inspector);
}

RenderObjects::RenderObjects() : RenderObjects(RenderObjectsSettings()) {}

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

} // namespace limn

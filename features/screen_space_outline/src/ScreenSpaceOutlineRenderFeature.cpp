#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/OutlineDrawingRenderPass.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>
#include <limn/volume/VolumeStack.h>

namespace limn
{

namespace
{

constexpr EnumEntry k_RenderQueueRanges[] = {{"All", 0}, {"Opaque", 1}, {"Transparent", 2}};

/// Why the blended component leaves the outline off.
std::string WhyInactive(const ScreenSpaceOutline* volumeComponent)
{
    if (volumeComponent == nullptr)
    {
        return "ScreenSpaceOutline was not registered when the camera's volume stack was made";
    }
    return volumeComponent->m_Enable.overrideState()
               ? "a volume sets ScreenSpaceOutline.m_Enable to false"
               : "no volume at the camera sets ScreenSpaceOutline.m_Enable, which is false by "
                 "default";
}

} // namespace

void ScreenSpaceOutlineSettings::Describe(Inspector& inspector)
{
    inspector.Header("Basic Settings");
    inspector.Field("m_RenderPassEvent", m_RenderPassEvent,
                    "The event of the frame at which the outline is drawn");
    inspector.Field(
        "m_ScreenSpaceOutlineShader", m_ScreenSpaceOutlineShader,
        "The shader with the mask, edge and composite passes: Hidden/ScreenSpaceOutline");

    inspector.Header("Filtering Settings");
    inspector.Field("m_RenderQueueRange", m_RenderQueueRange, k_RenderQueueRanges,
                    "The render queues of the objects that are outlined");
    inspector.Field("m_LayerMask", m_LayerMask, "The layers of the objects that are outlined");
    inspector.RenderingLayerIndex("m_RenderingLayerMask", m_RenderingLayerMask,
                                  "The rendering layer that marks an object as selected");
}

ScreenSpaceOutlineRenderFeature::ScreenSpaceOutlineRenderFeature()
    : ScreenSpaceOutlineRenderFeature(ScreenSpaceOutlineSettings())
{
}

ScreenSpaceOutlineRenderFeature::ScreenSpaceOutlineRenderFeature(
    ScreenSpaceOutlineSettings settings)
    : m_Settings(std::move(settings))
{
    name = "ScreenSpaceOutlineRenderFeature";
}

ScreenSpaceOutlineRenderFeature::~ScreenSpaceOutlineRenderFeature() = default;

void ScreenSpaceOutlineRenderFeature::Create()
{
    mPass.reset();
    if (!m_Settings.m_ScreenSpaceOutlineShader)
    {
        return;
    }
    mPass = std::make_unique<OutlineDrawingRenderPass>(name, m_Settings);
}

void ScreenSpaceOutlineRenderFeature::AddRenderPasses(ScriptableRenderer& renderer,
                                                      RenderingData& renderingData)
{
    const ScreenSpaceOutline* volumeComponent =
        renderingData.volumeStack->GetComponent<ScreenSpaceOutline>();
    if (volumeComponent == nullptr || !volumeComponent->IsActive())
    {
        renderingData.report->notes.push_back(name + ": it is not drawn; " +
                                              WhyInactive(volumeComponent));
        return;
    }
    if (!mPass)
    {
        renderingData.report->notes.push_back(name +
                                              ": it is not drawn; m_ScreenSpaceOutlineShader is "
                                              "not assigned; assign Hidden/ScreenSpaceOutline");
        return;
    }
    mPass->Setup(*volumeComponent);
    renderer.EnqueuePass(*mPass);
}

} // namespace limn

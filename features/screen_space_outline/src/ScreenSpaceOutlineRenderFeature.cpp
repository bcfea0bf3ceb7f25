#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/Features.h>
#include <limn/features/OutlineComponent.h>
#include <limn/features/OutlineDrawingRenderPass.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>
#include <limn/volume/VolumeStack.h>

namespace limn
{

void ScreenSpaceOutlineSettings::Describe(Inspector& inspector)
{
    inspector.Header("Basic Settings");
    inspector.Field("m_RenderPassEvent", m_RenderPassEvent,
                    "The event of the frame at which the outline is drawn");
    inspector.Field(
        "m_ScreenSpaceOutlineShader", m_ScreenSpaceOutlineShader,
        "The shader with the mask, edge and composite passes: Hidden/ScreenSpaceOutline");
    DescribeFilter(inspector, m_RenderQueueRange, m_LayerMask, m_RenderingLayerMask);
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
    if (m_Settings.m_ScreenSpaceOutlineShader)
    {
        mPass = std::make_unique<OutlineDrawingRenderPass>(name, m_Settings);
    }
}

void ScreenSpaceOutlineRenderFeature::AddRenderPasses(ScriptableRenderer& renderer,
                                                      RenderingData& renderingData)
{
    const ScreenSpaceOutline* volumeComponent =
        renderingData.volumeStack->GetComponent<ScreenSpaceOutline>();
    const bool isActive = volumeComponent != nullptr && volumeComponent->IsActive();
    std::string why = WhyOff(volumeComponent != nullptr ? &volumeComponent->m_Enable : nullptr,
                             isActive, "ScreenSpaceOutline");
    if (isActive && !mPass)
    {
        why = "m_ScreenSpaceOutlineShader is not assigned; assign Hidden/ScreenSpaceOutline";
    }
    if (!why.empty())
    {
        renderingData.report->notes.push_back(name + ": it is not drawn; " + why);
        return;
    }
    mPass->Setup(*volumeComponent);
    renderer.EnqueuePass(*mPass);
}

void RegisterScreenSpaceOutline(FeatureRegistry& features, VolumeComponentRegistry& components)
{
    features.Register<ScreenSpaceOutlineRenderFeature>(
        "ScreenSpaceOutlineRenderFeature",
        {{.name = "Screen space",
          .summary = "the first article: mask of half the size, Roberts cross",
          .isArticle = true,
          .place = 60,
          .component = "ScreenSpaceOutline",
          .settings = {"Outline.m_ScreenSpaceOutlineShader=Hidden/ScreenSpaceOutline",
                       "Outline.m_LayerMask=Everything"},
          .widestOutline = 10.0}});
    components.Register<ScreenSpaceOutline>("ScreenSpaceOutline");
}

} // namespace limn

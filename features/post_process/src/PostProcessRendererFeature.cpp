#include "FinalPostProcessPass.h"
#include "PostProcessPass.h"

#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

namespace
{

/// The last camera of a stack smooths what all of them have drawn.
bool isSmoothed(const RenderingData& renderingData)
{
    const CameraData& camera = renderingData.cameraData;
    return camera.antialiasing == AntialiasingMode::FastApproximateAntialiasing &&
           camera.resolveFinalTarget && renderingData.postProcessingEnabled;
}

constexpr EnumEntry k_ColorGradingModes[] = {{"LowDynamicRange", 0}, {"HighDynamicRange", 1}};

} // namespace

PostProcessRendererFeature::PostProcessRendererFeature()
{
    name = "PostProcessRendererFeature";
}

PostProcessRendererFeature::~PostProcessRendererFeature() = default;

void PostProcessRendererFeature::Create()
{
    m_Pass.reset();
    m_FinalPass.reset();
}

void PostProcessRendererFeature::AddRenderPasses(ScriptableRenderer& renderer,
                                                 RenderingData& renderingData)
{
    AddEffects(renderer, renderingData);
    if (isSmoothed(renderingData))
    {
        if (!m_FinalPass)
        {
            m_FinalPass = std::make_unique<FinalPostProcessPass>(
                name, FindTechniqueShader(renderer, "Hidden/Universal Render Pipeline/FinalPost"));
        }
        renderer.EnqueuePass(*m_FinalPass);
    }
}

void PostProcessRendererFeature::AddEffects(ScriptableRenderer& renderer,
                                            RenderingData& renderingData)
{
    const ActiveEffects effects(renderingData.volumeStack);
    const bool isEnabled = renderingData.cameraData.postProcessEnabled;
    if (!effects.any() && (!isEnabled || isSmoothed(renderingData)))
    {
        return; // nobody asks for more
    }
    if (!effects.any() || !isEnabled)
    {
        renderingData.report->notes.push_back(
            name + ": it is not drawn; " +
            (isEnabled ? "no volume switches Bloom, Vignette, ColorAdjustments or Tonemapping on"
                       : "the camera's renderPostProcessing is off"));
        return;
    }
    if (!m_Pass)
    {
        m_Pass = std::make_unique<PostProcessPass>(
            name, FindTechniqueShader(renderer, "Hidden/Universal Render Pipeline/Bloom"),
            FindTechniqueShader(renderer, "Hidden/Universal Render Pipeline/UberPost"));
    }
    m_Pass->Setup(effects, m_ColorGradingMode, renderingData.cameraData);
    renderer.EnqueuePass(*m_Pass);
}

void PostProcessRendererFeature::Describe(Inspector& inspector)
{
    inspector.Field("m_ColorGradingMode", m_ColorGradingMode, k_ColorGradingModes,
                    "The place of colour grading: before or after tonemapping");
}

} // namespace limn

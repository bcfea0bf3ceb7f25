#pragma once

#include <limn/core/ScriptableRendererFeature.h>
#include <memory>

namespace limn
{

class FinalPostProcessPass;
class PostProcessPass;

/// The place at which colours are graded. Unity: ColorGradingMode (URP 14).
enum class ColorGradingMode
{
    LowDynamicRange = 0, ///< after tonemapping, in 0...1
    HighDynamicRange = 1 ///< before it; a camera without HDR has LowDynamicRange
};

/// Applies Bloom, Vignette, ColorAdjustments and Tonemapping, where volumes switch them on, to
/// cameras with renderPostProcessing, and smooths the picture of cameras with antialiasing. Effects
/// that are off cost nothing; if all are off, there is no pass. Unity's renderers have this built
/// in; in limn it must be added as the last feature. Unity: PostProcessPass, PostProcessData and
/// the pipeline asset's ColorGradingMode (URP 14).
class PostProcessRendererFeature final : public ScriptableRendererFeature
{
public:
    PostProcessRendererFeature();
    ~PostProcessRendererFeature() override;

    ColorGradingMode m_ColorGradingMode = ColorGradingMode::LowDynamicRange;

    void Create() override;
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override;
    void Describe(Inspector& inspector) override;

private:
    void AddEffects(ScriptableRenderer& renderer, RenderingData& renderingData);

    // Each is made by the first frame that needs it.
    std::unique_ptr<PostProcessPass> m_Pass;
    std::unique_ptr<FinalPostProcessPass> m_FinalPass;
};

} // namespace limn

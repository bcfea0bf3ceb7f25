#pragma once

#include <limn/core/ScriptableRendererFeature.h>
#include <memory>

namespace limn
{

class PostProcessPass;

/// Where colours are graded. Unity: ColorGradingMode (URP 14).
enum class ColorGradingMode
{
    LowDynamicRange = 0, ///< behind tonemapping, in 0...1
    HighDynamicRange = 1 ///< before it; a camera without HDR has LowDynamicRange
};

/// Bloom, Vignette, ColorAdjustments and Tonemapping, as volumes switch them on, for cameras with
/// renderPostProcessing. Effects that are off cost nothing; with all off there is no pass at all.
/// A renderer of Unity's has this built in; here it is added, as the last feature.
/// Unity: PostProcessPass, PostProcessData and the pipeline asset's ColorGradingMode (URP 14).
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
    std::unique_ptr<PostProcessPass> m_Pass; ///< made by the first frame that needs it
};

} // namespace limn

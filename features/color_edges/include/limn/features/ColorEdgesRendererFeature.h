#pragma once

#include <limn/core/RTHandle.h>
#include <limn/features/ColorEdges.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// The settings for when and where the lines are drawn.
struct ColorEdgesSettings : OutlineSettings
{
    /// Draws lines only where a filtered object is seen. If false, draws them all over the picture,
    /// whatever the filter.
    bool m_OnlyFilteredObjects = false;

    void Describe(Inspector& inspector);
};

/// Draws lines where the brightness of the picture so far changes.
///
/// _ColorEdgesBrightness [H, W], R16_SFloat, 0...1: the square root of the luminance of the picture
/// as the screen shows it, with components clipped at 1; NaN counts as 0. _ColorEdgesMask [H, W],
/// R8_UNorm, only where lines are limited to objects: 1 where one is seen.
class ColorEdgesPass final : public OutlineTechniquePass
{
public:
    static constexpr const char* k_Shader = "Hidden/Limn/ColorEdges";

    ColorEdgesPass(const std::string& featureName, const ColorEdgesSettings& settings,
                   std::shared_ptr<const Shader> shader)
        : OutlineTechniquePass(featureName, settings, std::move(shader)), m_Settings(settings)
    {
    }

    /// @return why nothing is drawn; "" = something is
    /// @throws ContractError if the component's operator is not one of EdgeOperator
    std::string Setup(const ColorEdges& component, const RenderingData& renderingData);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    void SetMaterial(const ColorEdges& component, const glm::vec4& taps);
    void DrawMask(ScriptableRenderContext& context, const RenderingData& renderingData) const;
    void BlitPart(CommandBuffer& cmd, const RTHandle& source, const RTHandle& target,
                  int shaderPass) const;

    const ColorEdgesSettings& m_Settings; ///< the feature's
    ViewportRect m_Part; ///< the part of the picture that lines can be in and come from
    RTHandle m_Mask;
    RTHandle m_Brightness;
};

/// Draws lines where the brightness of the picture changes, whatever the cause: silhouettes,
/// textures, shadows.
/// @source technique 3 of the introduction of the article on selection outlines
using ColorEdgesRendererFeature =
    OutlineRendererFeature<ColorEdges, ColorEdgesSettings, ColorEdgesPass>;

} // namespace limn

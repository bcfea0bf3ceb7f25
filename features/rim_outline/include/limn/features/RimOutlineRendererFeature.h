#pragma once

#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/RimOutline.h>

namespace limn
{

/// The settings for when and on which objects the rim is drawn. By default these are opaque
/// objects, whose depth shows which parts are seen, before transparent ones are drawn in front of
/// them.
using RimOutlineSettings = OpaqueOutlineSettings;

/// Draws the outlined objects once more where they are seen. The viewing angle decides how strong
/// the rim's colour is.
class RimOutlinePass final : public OutlineTechniquePass
{
public:
    static constexpr const char* k_Shader = "Hidden/Limn/RimOutline";

    RimOutlinePass(const std::string& featureName, const RimOutlineSettings& settings,
                   std::shared_ptr<const Shader> shader)
        : OutlineTechniquePass(featureName, settings, std::move(shader)), m_Settings(settings)
    {
    }

    /// @return why nothing is drawn; "" = something is
    /// @throws ContractError if the component's variant is not one of RimVariant
    std::string Setup(const RimOutline& component, const RenderingData& renderingData);

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    const RimOutlineSettings& m_Settings; ///< the feature's
};

/// Draws a glow along the inside of each object's silhouette, computed from the angle between
/// normal and line of sight. It needs no texture and no second picture, and has no exact width.
/// @source technique 2 of the introduction of the article on selection outlines
using RimOutlineRendererFeature =
    OutlineRendererFeature<RimOutline, RimOutlineSettings, RimOutlinePass>;

} // namespace limn

#pragma once

#include <limn/features/InflatedOutline.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// The settings for when and around which objects the outline is drawn. By default these are opaque
/// objects, before transparent ones are drawn in front of them, because the objects are drawn once
/// more.
struct InflatedOutlineSettings : OpaqueOutlineSettings
{
    OutlineGrouping m_Grouping = OutlineGrouping::PerGroup;

    void Describe(Inspector& inspector);
};

/// Draws the hull of each outlined object in one colour, and the object with its own material over
/// it. Draws group by group, the farthest first, so that the outline of a near group covers a far
/// one.
class InflatedOutlinePass final : public OutlineTechniquePass
{
public:
    static constexpr const char* k_Shader = "Hidden/Limn/InflatedOutline";

    InflatedOutlinePass(const std::string& featureName, const InflatedOutlineSettings& settings,
                        std::shared_ptr<const Shader> shader)
        : OutlineTechniquePass(featureName, settings, std::move(shader)), m_Settings(settings)
    {
    }

    /// @return why nothing is drawn; "" = something is
    /// @throws ContractError if the component's width unit is not one of InflatedWidthUnit
    std::string Setup(const InflatedOutline& component, const RenderingData& renderingData);

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    const InflatedOutlineSettings& m_Settings; ///< the feature's
    int m_HullPass = 0;
    std::vector<OutlinedGroup> m_Groups; ///< the groups of this frame, the farthest first
};

/// Draws a hull around each object before the object. This is the oldest outline, and the cheapest
/// where few pixels must be shaded.
/// @source technique 1 of the introduction of the article on selection outlines
using InflatedOutlineRendererFeature =
    OutlineRendererFeature<InflatedOutline, InflatedOutlineSettings, InflatedOutlinePass>;

} // namespace limn

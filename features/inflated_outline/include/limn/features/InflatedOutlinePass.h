#pragma once

#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/features/InflatedOutline.h>
#include <limn/features/OutlinedObjects.h>

namespace limn
{

struct InflatedOutlineSettings;

/// Draws the hull of each outlined object in one colour, and the object with its own material over
/// it. Draws group by group, the farthest first, so that the outline of a near group covers a far
/// one.
class InflatedOutlinePass final : public ScriptableRenderPass
{
public:
    static constexpr const char* k_Shader = "Hidden/Limn/InflatedOutline";

    InflatedOutlinePass(const std::string& featureName, const InflatedOutlineSettings& settings,
                        std::shared_ptr<const Shader> shader);

    /// @return why nothing is drawn; "" = something is
    /// @throws ContractError if the component's width unit is not one of InflatedWidthUnit
    std::string Setup(const InflatedOutline& component, const RenderingData& renderingData);

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    struct Group
    {
        std::span<const OutlinedObject> objects; ///< in m_Found
        double depth = 0.0; ///< of its nearest part, in metres before the camera
    };

    const InflatedOutlineSettings& m_Settings; ///< the feature's
    std::shared_ptr<Material> m_Material;
    int m_HullPass = 0;
    OutlinedObjects m_Found;     ///< of this frame, kept for its memory
    std::vector<Group> m_Groups; ///< the groups of this frame, the farthest first
};

} // namespace limn

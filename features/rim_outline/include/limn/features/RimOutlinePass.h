#pragma once

#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/features/OutlinedObjects.h>
#include <limn/features/RimOutline.h>

namespace limn
{

struct RimOutlineSettings;

/// Draws the outlined objects once more where they are seen. The viewing angle decides how strong
/// the rim's colour is.
class RimOutlinePass final : public ScriptableRenderPass
{
public:
    static constexpr const char* k_Shader = "Hidden/Limn/RimOutline";

    RimOutlinePass(const std::string& featureName, const RimOutlineSettings& settings,
                   std::shared_ptr<const Shader> shader);

    /// @return why nothing is drawn; "" = something is
    /// @throws ContractError if the component's variant is not one of RimVariant
    std::string Setup(const RimOutline& component, const RenderingData& renderingData);

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    const RimOutlineSettings& m_Settings; ///< the feature's
    OutlinedObjects m_Found;              ///< of this frame, kept for its memory
    std::shared_ptr<Material> m_Material;
};

} // namespace limn

#pragma once

#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/features/DepthNormalsOutline.h>
#include <limn/features/OutlineSettings.h>
#include <limn/features/OutlinedObjects.h>

namespace limn
{

/// Draws the filtered objects once more over themselves, in the outline's colour where depth or
/// normals change. Requires both textures of the camera.
class DepthNormalsOutlinePass final : public ScriptableRenderPass
{
public:
    static constexpr const char* k_Shader = "Hidden/Limn/DepthNormalsOutline";

    DepthNormalsOutlinePass(const std::string& featureName, const OutlineSettings& settings,
                            std::shared_ptr<const Shader> shader);

    /// @return why nothing is drawn; "" = something is
    /// @throws ContractError if the component's technique is not one of DepthNormalsTechnique
    std::string Setup(const DepthNormalsOutline& component, const RenderingData& renderingData);

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    const OutlineSettings& m_Settings; ///< the feature's
    OutlinedObjects m_Found;           ///< of this frame, kept for its memory
    std::shared_ptr<Material> m_Material;
    int m_MaterialPass = 0;
};

} // namespace limn

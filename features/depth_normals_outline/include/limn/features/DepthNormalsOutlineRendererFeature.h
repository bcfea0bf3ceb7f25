#pragma once

#include <limn/features/DepthNormalsOutline.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// The settings for which objects get lines: opaque ones, because others are in neither texture,
/// before transparent ones are drawn over them.
using DepthNormalsOutlineSettings = OpaqueOutlineSettings;

/// Draws the filtered objects once more over themselves, in the outline's colour where depth or
/// normals change. Requires both textures of the camera.
class DepthNormalsOutlinePass final : public OutlineTechniquePass
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
    int m_MaterialPass = 0;
};

/// Draws lines on chosen objects where the depth or the normals of the picture change: at
/// silhouettes and creases.
/// @source the article on outlining objects one by one, whose shader graph does it in their
/// material
using DepthNormalsOutlineRendererFeature =
    OutlineRendererFeature<DepthNormalsOutline, DepthNormalsOutlineSettings,
                           DepthNormalsOutlinePass>;

} // namespace limn

#pragma once

#include <limn/core/Material.h>
#include <limn/core/RTHandle.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/features/MaskDifferenceOutline.h>
#include <limn/features/OutlineRegion.h>

namespace limn
{

struct MaskDifferenceOutlineSettings;

/// Draws the filtered objects into a mask, and lines into the picture where the mask changes.
///
/// t_tex0 [H', W'] of the outline's region: linear colour and, in alpha, the object; 0 where there
/// is none. Its format is R16G16B16A16_SFloat, or R32G32B32A32_SFloat if objects are distinguished.
/// t_tex1 [H, W]: a copy of the picture, only without framebuffer fetch.
class MaskDifferenceOutlinePass final : public ScriptableRenderPass
{
public:
    static constexpr const char* k_Shader = "Hidden/Limn/MaskDifferenceOutline";

    MaskDifferenceOutlinePass(const std::string& featureName,
                              const MaskDifferenceOutlineSettings& settings,
                              std::shared_ptr<const Shader> shader);

    /// @return why nothing is drawn; "" = something is
    std::string Setup(const MaskDifferenceOutline& component, const RenderingData& renderingData);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    void DrawMask(CommandBuffer& cmd, const CameraData& camera);

    const MaskDifferenceOutlineSettings& m_Settings; ///< the feature's
    std::shared_ptr<Material> m_Material;
    std::shared_ptr<const Material> m_CopyMaterial;
    OutlinedObjects m_Objects;
    MaterialPropertyBlock m_Properties;
    OutlineRegion m_Region;
    Color m_Color; ///< sRGB
    RTHandle m_Mask;
    RTHandle m_MaskDepth;
    RTHandle m_SceneColor;
};

} // namespace limn

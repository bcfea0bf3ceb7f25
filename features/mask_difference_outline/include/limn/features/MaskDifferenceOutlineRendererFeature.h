#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <limn/features/MaskDifferenceOutline.h>
#include <limn/features/OutlineRegion.h>
#include <limn/features/OutlineRendererFeature.h>

namespace limn
{

/// Returns the number that distinguishes a group in the mask: its digits to the base 5 are 0 and 1.
/// The mean of four such numbers is one of them only if all four are equal, because no digit of
/// their sum carries; so the comparison with the mean of the neighbours overlooks no change. Sums
/// of four are whole numbers below 2^24, which a float holds exactly. There are 1023 numbers; then
/// they repeat.
constexpr float IdOfGroup(int group)
{
    int id = 0;
    int digit = 1;
    for (int bits = group % 1023 + 1; bits != 0; bits >>= 1)
    {
        id += (bits & 1) * digit;
        digit *= 5;
    }
    return static_cast<float>(id);
}

/// Returns a bright linear colour. The colours of consecutive groups differ strongly, because they
/// step around the circle of hues by the golden ratio.
inline glm::vec3 ColorOfGroup(int group)
{
    const double turn = 0.6180339887498949 * group;
    const double hue = 6.0 * (turn - std::floor(turn));
    const glm::dvec3 offsets(3.0, 2.0, 4.0);
    const glm::dvec3 signs(1.0, -1.0, -1.0);
    const glm::dvec3 starts(-1.0, 2.0, 2.0);
    return glm::vec3(
        glm::clamp(starts + signs * glm::abs(hue - offsets), glm::dvec3(0.0), glm::dvec3(1.0)));
}

/// The settings for when, around which objects and how lines are drawn.
struct MaskDifferenceOutlineSettings : OutlineSettings
{
    /// The grouping of objects; there is a line between objects of different groups that touch each
    /// other.
    OutlineGrouping m_Grouping = OutlineGrouping::PerObject;
    /// Gives each group a colour of its own, ColorOfGroup, in place of the component's.
    bool m_ColorByGroup = false;
    /// Adds the line in place, as a device with framebuffer fetch does. If false, the picture is
    /// copied and read as a texture. Both give the same picture.
    bool m_FramebufferFetch = true;

    void Describe(Inspector& inspector);
};

/// Draws the filtered objects into a mask, and lines into the picture where the mask changes.
///
/// t_tex0 [H', W'] of the outline's region: linear colour and, in alpha, the object; 0 where there
/// is none. Its format is R16G16B16A16_SFloat, or R32G32B32A32_SFloat if objects are distinguished.
/// t_tex1 [H, W]: a copy of the picture, only without framebuffer fetch.
class MaskDifferenceOutlinePass final : public OutlineTechniquePass
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
    std::shared_ptr<const Material> m_CopyMaterial;
    MaterialPropertyBlock m_Properties;
    OutlineRegion m_Region;
    Color m_Color; ///< sRGB
    RTHandle m_Mask;
    RTHandle m_MaskDepth;
    RTHandle m_SceneColor;
};

/// Draws lines around objects by comparing each texel of a mask with its four neighbours, up to a
/// depth.
/// @source the article on outlines as post-processing (mask, four neighbours, depth clip)
using MaskDifferenceOutlineRendererFeature =
    OutlineRendererFeature<MaskDifferenceOutline, MaskDifferenceOutlineSettings,
                           MaskDifferenceOutlinePass>;

} // namespace limn

#pragma once

#include <limn/features/OutlineRegion.h>
#include <limn/features/OutlineRendererFeature.h>
#include <limn/features/WideOutline.h>

namespace limn
{

/// The method that finds the nearest place on the edge.
enum class WideOutlineMethod
{
    Auto,      ///< the method that costs less for the width
    JumpFlood, ///< a pass for each doubling of the width
    Separable  ///< two passes that look as far as the width
};

enum class WideOutlineOcclusion
{
    All,    ///< whole objects have an outline, whatever stands in front of them
    Visible ///< the part of them that the camera sees has one
};

struct WideOutlineSettings : OutlineSettings
{
    WideOutlineMethod m_Method = WideOutlineMethod::Auto;
    WideOutlineOcclusion m_Occlusion = WideOutlineOcclusion::All;
    OutlineGrouping m_Grouping = OutlineGrouping::Together;

    void Describe(Inspector& inspector);
};

/// Draws the objects into a mask, finds places on its edge, spreads the nearest ones as far as the
/// outline reaches, and blends the pixels at the right distance into the camera's colour. Repeats
/// this for each group of objects.
///
/// Textures [region height, region width]: _WideOutlineMask, R8_UNorm of four samples (every Vulkan
/// device has them); _WideOutlineSeeds, R16G16B16A16_UNorm, see EdgeSeeds.hlsl; _WideOutlineFloodA
/// and B, R16G16_UNorm, or _WideOutlineColumns, R16G16B16A16_UNorm.
class WideOutlineRenderPass final : public OutlineTechniquePass
{
public:
    static constexpr const char* k_Shader = "Hidden/Limn/WideOutline";

    WideOutlineRenderPass(const std::string& featureName, const WideOutlineSettings& settings,
                          std::shared_ptr<const Shader> shader);

    /// @return why nothing is drawn, or ""
    /// @throws ContractError if a number is not finite
    std::string Setup(const WideOutline& component, RenderingData& renderingData);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

    /// Returns the method that the last Setup chose, never Auto.
    WideOutlineMethod method() const { return m_Method; }

private:
    struct Group
    {
        std::span<const OutlinedObject> objects; ///< in m_Found
        OutlineRegion region;
    };

    void SetBand(const WideOutline& component, const glm::ivec2& picture);
    void DrawMask(ScriptableRenderContext& context, CommandBuffer& cmd,
                  const RenderingData& renderingData, const Group& group);
    const RTHandle& Flood(CommandBuffer& cmd);
    void Composite(CommandBuffer& cmd, const RenderingData& renderingData, const Group& group,
                   const RTHandle& source, int pass);
    void DrawWhole(CommandBuffer& cmd, const RTHandle& source, const RTHandle& target, int pass,
                   float step);

    WideOutlineSettings m_Settings;
    MaterialPropertyBlock m_Properties;
    std::vector<Group> m_Groups;
    WideOutlineMethod m_Method = WideOutlineMethod::JumpFlood;
    /// The distance of the outline's end from the edge, on either side, in pixels.
    float m_Farthest = 0.0f;
    int m_Reach = 0; ///< pixels: no place on the edge that is farther away matters
    RTHandle m_Mask;
    RTHandle m_Seeds;
    RTHandle m_FloodA;
    RTHandle m_FloodB;
    RTHandle m_Columns;
};

/// Draws outlines of any width, as exact as the mask with four samples per pixel shows the
/// silhouette. Technique: B. Golus, "The Quest for Very Wide Outlines" (2020); columns and rows
/// after Felzenszwalb and Huttenlocher (2012), limited to the width.
using WideOutlineRendererFeature =
    OutlineRendererFeature<WideOutline, WideOutlineSettings, WideOutlineRenderPass>;

} // namespace limn

#pragma once

#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/features/PostProcessRendererFeature.h>
#include <vector>

namespace limn
{

class Bloom;
class ColorAdjustments;
class Tonemapping;
class Vignette;

/// The effects that the camera's stack switches on; null = off.
struct ActiveEffects
{
    const Bloom* bloom = nullptr;
    const Vignette* vignette = nullptr;
    const ColorAdjustments* colorAdjustments = nullptr;
    const Tonemapping* tonemapping = nullptr;

    explicit ActiveEffects(const VolumeStackPointer& stack);
    bool any() const { return bloom || vignette || colorAdjustments || tonemapping; }
};

/// Draws the active effects. Textures: _BloomMipDown<i>, _BloomMipUp<i> [H / 2^(i+1), W / 2^(i+1)],
/// B10G11R11_UFloatPack32; _UberPost [H, W], in the format of the camera's colour.
/// Unity: PostProcessPass (URP 14).
class PostProcessPass final : public ScriptableRenderPass
{
public:
    PostProcessPass(const std::string& featureName, std::shared_ptr<const Shader> bloom,
                    std::shared_ptr<const Shader> uber);

    /// @param effects  must have at least one effect
    void Setup(const ActiveEffects& effects, ColorGradingMode grading,
               const CameraData& cameraData);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    struct BloomMip
    {
        RTHandle down;
        RTHandle up;
    };

    void SetupBloom(const Bloom* bloom, const glm::ivec2& picture);
    void SetupDirt(const Bloom& bloom, const glm::ivec2& picture);
    void SetupVignette(const Vignette* vignette, const glm::ivec2& picture);
    void SetupGrading(const ActiveEffects& effects, bool isHdr);
    /// @return the texture with the glow
    const RTHandle& DrawBloom(CommandBuffer& cmd, const RTHandle& color) const;

    std::shared_ptr<Material> m_BloomMaterial;
    std::shared_ptr<Material> m_UberMaterial;
    std::vector<BloomMip> m_BloomMips; ///< from the largest on; kept while bloom is off
    std::size_t m_BloomMipCount = 0;   ///< the number of mips that are drawn; 0 without bloom
    glm::ivec2 m_BloomSize{0};         ///< the size of the largest
    RTHandle m_Result;
};

} // namespace limn

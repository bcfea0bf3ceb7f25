#pragma once

#include <limn/core/FilteringSettings.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>
#include <vector>

namespace limn
{

/// Draws the filtered objects into a mask, finds the mask's edges, and adds them to the camera's
/// colour.
///
/// _RendererDrawingTexture [H/2, W/2], R8_UNorm: 1 where a filtered object is, occluded or not.
/// _OutlineTexture [H/2, W/2], R8_UNorm: Roberts cross of the mask, 1 on an edge, clamped at 1.
/// @source nscTechArt/URP-Screen-Space-Outline, OutlineDrawingRenderPass (Unity 2022.3)
class OutlineDrawingRenderPass final : public ScriptableRenderPass
{
public:
    /// @throws ContractError if the settings lack a shader or the rendering layer index is outside
    ///         0...31
    OutlineDrawingRenderPass(const std::string& featureName,
                             const ScreenSpaceOutlineSettings& settings);

    void Setup(const ScreenSpaceOutline& volumeComponent);

    void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData) override;
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;

private:
    // basic variables
    ProfilingSampler mProfilingSampler;
    std::shared_ptr<Material> mPassMaterial;
    // render texture handles
    RTHandle mRendererDrawingTexture;
    RTHandle mOutlineTexture;
    RTHandle mCameraColorTexture;
    // renderer drawing related
    FilteringSettings mFilteringSettings;
    const std::vector<ShaderTagId> mShaderTagIDs = ForwardShaderTags();
};

} // namespace limn

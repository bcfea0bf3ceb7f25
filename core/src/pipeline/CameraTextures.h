#pragma once

#include "pipeline/BlitPass.h"
#include "pipeline/DrawObjectsPass.h"

#include <limn/core/ScriptableRenderer.h>
#include <optional>

namespace limn
{

/// The camera's textures that shaders read: _CameraDepthTexture, _CameraNormalsTexture,
/// _CameraOpaqueTexture, and the built-in pipeline's _CameraDepthNormalsTexture. Whether one is
/// made is known only when all passes are recorded. Then the pass that makes it is run at its
/// place, which follows from what passes asked for (ConfigureInput); the first pass that read the
/// depth counts as if it had asked.
///
///     150  DepthPrepass or DepthNormalPrepass: depth, if normals were asked for or depth by a pass
///          of event <= 250; normals; EncodeDepthNormals of both, if that is read
///          CopyDepth before the first pass that asked for depth, at 500 at the latest: depth
///     400  CopyColor: opaque colour
///
/// @source Unity: UniversalRenderer.GetRenderPassInputs and Setup (URP 14), but that textures that
///     nothing reads are not made, and those that shaders read without a pass asking are.
class CameraTextures
{
public:
    /// @param blit  the material of CoreBlit.shader
    explicit CameraTextures(const std::shared_ptr<const Material>& blit);

    /// Begins a frame, and notes what was asked for and cannot be made.
    void Setup(std::span<ScriptableRenderPass* const> queue, LayerMask opaqueLayers,
               const RenderTextureDescriptor& camera, std::vector<std::string>& notes);

    /// Sets the textures that are made at this place as globals for draws that follow.
    /// @param next   the event of the next pass, or one behind all
    /// @param color  the camera's colour at this place
    void BeforePass(ScriptableRenderContext& context, RenderPassEvent next,
                    const ScriptableRenderer::PassPlace& place, const RTHandle& color);

    struct LatePass
    {
        ScriptableRenderer::PassPlace place;
        ScriptableRenderPass* pass = nullptr; ///< never null
    };
    /// Returns the passes that make what was read, the last first; they are valid until the next
    /// call.
    std::span<const LatePass> Needed(const ScriptableRenderContext& context, const RTHandle& depth);

private:
    struct PlaceOfEvent
    {
        RenderPassEvent next;
        ScriptableRenderer::PassPlace place;
    };
    using OptionalPlace = std::optional<ScriptableRenderer::PassPlace>;

    void Allocate(const RenderTextureDescriptor& camera);
    bool TakesDepthFromPrepass(const ScriptableRenderContext& context) const;
    LatePass CopyDepth(const RTHandle& depth);

    /// Adds a pass that Needed returns, behind those of its place.
    void AddLate(const LatePass& pass);

    DrawObjectsPass m_DepthPrepass;
    DrawObjectsPass m_DepthNormalPrepass;
    BlitPass m_CopyDepth;
    BlitPass m_CopyColor;
    BlitPass m_EncodeDepthNormals;
    RTHandle m_PrepassDepth;
    RTHandle m_CopiedDepth;
    RTHandle m_Normals;
    RTHandle m_DepthNormals; ///< view space and eye depth, see EncodeDepthNormal of UnityCG.cginc
    RTHandle m_OpaqueColor;

    // These are of the frame:
    std::vector<LatePass> m_Late;
    bool m_AsksForNormals = false;
    RenderPassEvent m_FirstDepthEvent{}; ///< of the passes that asked or read
    bool m_IsDepthChosen = false;        ///< from prepass or copy
    RenderPassEvent m_LastEvent{};
    std::vector<PlaceOfEvent> m_Places;
    OptionalPlace m_PrepassPlace;
    OptionalPlace m_ColorPlace;
    RTHandle m_ColorThere; ///< the camera's colour at that place
};

} // namespace limn

#pragma once

#include <limn/core/ProfilingScope.h>
#include <limn/core/RenderPassEvent.h>
#include <limn/core/RenderingData.h>
#include <limn/core/ScriptableRenderContext.h>
#include <span>
#include <vector>

namespace limn
{

class ContextContainer;
class RenderGraph;

/// The name of a pass that was given none and not yet enqueued; Unity's.
inline constexpr std::string_view k_UnnamedPass = "Unnamed_ScriptableRenderPass";

/// One step of a frame: derive, set renderPassEvent, record in Execute.
/// Unity: UnityEngine.Rendering.Universal.ScriptableRenderPass (URP 14).
class ScriptableRenderPass
{
public:
    ScriptableRenderPass() = default;
    virtual ~ScriptableRenderPass() = default;
    ScriptableRenderPass(const ScriptableRenderPass&) = delete;
    ScriptableRenderPass& operator=(const ScriptableRenderPass&) = delete;

    RenderPassEvent renderPassEvent = RenderPassEvent::AfterRenderingOpaques;

    /// What reports, captures, timings and errors call the pass: one that is not set becomes the
    /// name of the class when the pass is enqueued.
    ProfilingSampler profilingSampler{std::string(k_UnnamedPass)};

    /// Once a camera, before any pass executes, in the order of enqueueing: make textures here.
    virtual void OnCameraSetup(CommandBuffer& cmd, RenderingData& renderingData);
    /// Once a camera, after all OnCameraSetup, in the order of execution.
    virtual void Configure(CommandBuffer& cmd,
                           const RenderTextureDescriptor& cameraTextureDescriptor);
    /// The pass's work. Its targets are bound and cleared already.
    virtual void Execute(ScriptableRenderContext& context, RenderingData& renderingData);
    /// The pass's work as Unity 6 has it: what is added to the graph runs when this returns. Of a
    /// pass that overrides Execute, too, this is what runs, unless the pipeline's
    /// enableRenderCompatibilityMode is on.
    /// Unity: ScriptableRenderPass.RecordRenderGraph (URP 17).
    virtual void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer& frameData);
    /// Once for each OnCameraSetup, after all passes have executed or one of them has thrown.
    virtual void OnCameraCleanup(CommandBuffer& cmd);
    /// What URP 7 to 9 call OnCameraCleanup, which this calls: override one of them.
    virtual void FrameCleanup(CommandBuffer& cmd) { OnCameraCleanup(cmd); }
    /// Behind the last camera of a stack, where this pass was enqueued; every camera is a stack of
    /// its own.
    virtual void OnFinishCameraStackRendering(CommandBuffer& /*cmd*/) {}

    ScriptableRenderPassInput input() const { return m_Input; }
    bool overrideCameraTarget() const { return m_OverrideCameraTarget; }
    /// The first of them; empty where the pass draws depth only, or into the camera's targets.
    const RTHandle& colorAttachmentHandle() const;
    std::span<const RTHandle> colorAttachmentHandles() const { return m_Colors; }
    const RTHandle& depthAttachmentHandle() const { return m_Depth; }
    ClearFlag clearFlag() const { return m_ClearFlag; }
    const Color& clearColor() const { return m_ClearColor; }

    /// Draw into these instead of the camera's targets, until ResetTarget. Without `depth` there is
    /// none: the camera's is not used. A depth texture in place of the colour is the depth.
    void ConfigureTarget(const RTHandle& color, const RTHandle& depth = {});
    /// Several colours at once. Empty handles behind the last colour are as good as none.
    /// @throws ContractError for more than 8 colours
    void ConfigureTarget(std::span<const RTHandle> colors, const RTHandle& depth = {});
    /// The same by what the identifiers stand for when the pass begins. Without a depth it is the
    /// one that belongs to the colour: the camera's, or the one that GetTemporaryRT made beside it.
    /// @throws ContractError for none, and for more than 8 colours
    /// @source Unity: ScriptableRenderPass.ConfigureTarget of identifiers (URP 14)
    void ConfigureTarget(RenderTargetIdentifier color);
    void ConfigureTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth);
    void ConfigureTarget(std::span<const RenderTargetIdentifier> colors);
    void ConfigureTarget(std::span<const RenderTargetIdentifier> colors,
                         RenderTargetIdentifier depth);
    /// Clear on binding. On the first binding of the camera's colour its background colour wins.
    void ConfigureClear(ClearFlag clearFlag, const Color& clearColor);
    /// Overwrites what was asked before (it does not add). Call it before the renderer's set-up
    /// reads it: in AddRenderPasses or earlier.
    void ConfigureInput(ScriptableRenderPassInput passInput) { m_Input = passInput; }
    void ResetTarget();
    // What is stored is worked out from what is read later: no less than is asked for.
    void ConfigureColorStoreAction(RenderBufferStoreAction, std::uint32_t /*attachmentIndex*/ = 0)
    {
    }
    void ConfigureColorStoreActions(std::span<const RenderBufferStoreAction>) {}
    void ConfigureDepthStoreAction(RenderBufferStoreAction) {}

    /// cmd.Blit, the source as _MainTex; the pass's ConfigureClear clears the colour first.
    /// @param material  null = a plain copy, whatever `passIndex` is
    /// @source Unity: ScriptableRenderPass.Blit of identifiers (URP 14)
    void Blit(CommandBuffer& cmd, RenderTargetIdentifier source, RenderTargetIdentifier destination,
              std::shared_ptr<const Material> material = nullptr, int passIndex = 0) const;
    /// Blitter::BlitCameraTexture, the source as _BlitTexture.
    /// @param material  null = a plain copy
    /// @throws ContractError as BlitCameraTexture does
    /// @source Unity: ScriptableRenderPass.Blit of handles (URP 14)
    void Blit(CommandBuffer& cmd, const RTHandle& source, const RTHandle& destination,
              std::shared_ptr<const Material> material = nullptr, int passIndex = 0) const;

    /// Draws the camera's colour, as _BlitTexture, over another texture, which is the camera's
    /// colour from then on: nothing is copied back. What cmd executes before that still means the
    /// old one by CameraTarget.
    /// @throws ContractError if the material is null, there is no such pass, or the renderer has
    /// one
    ///         colour only
    /// @source Unity: ScriptableRenderPass.Blit(cmd, ref data, material, passIndex) (URP 14)
    void Blit(CommandBuffer& cmd, RenderingData& data, std::shared_ptr<const Material> material,
              int passIndex = 0) const;

    /// Draw with these LightMode tags, sorted by these criteria from the current camera.
    /// @throws ContractError if `tags` is empty or longer than 16
    DrawingSettings CreateDrawingSettings(std::span<const ShaderTagId> tags,
                                          const RenderingData& renderingData,
                                          SortingCriteria sortingCriteria) const;
    DrawingSettings CreateDrawingSettings(ShaderTagId tag, const RenderingData& renderingData,
                                          SortingCriteria sortingCriteria) const;

private:
    friend class RenderGraphCamera;
    friend class ScriptableRenderer;

    bool m_RecordsGraph = true; ///< until RecordRenderGraph turns out not to be overridden
    ScriptableRenderPassInput m_Input = ScriptableRenderPassInput::None;
    bool m_OverrideCameraTarget = false;
    std::vector<RTHandle> m_Colors;
    RTHandle m_Depth;
    ClearFlag m_ClearFlag = ClearFlag::None;
    Color m_ClearColor = Color::black;
};

} // namespace limn

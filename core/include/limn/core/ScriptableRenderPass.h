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

/// The name of a pass that was given none and is not yet enqueued; it is Unity's.
inline constexpr std::string_view k_UnnamedPass = "Unnamed_ScriptableRenderPass";

/// One step of a frame: derive from it, set renderPassEvent, record in Execute.
/// Unity: UnityEngine.Rendering.Universal.ScriptableRenderPass (URP 14).
class ScriptableRenderPass
{
public:
    ScriptableRenderPass() = default;
    virtual ~ScriptableRenderPass() = default;
    ScriptableRenderPass(const ScriptableRenderPass&) = delete;
    ScriptableRenderPass& operator=(const ScriptableRenderPass&) = delete;

    RenderPassEvent renderPassEvent = RenderPassEvent::AfterRenderingOpaques;

    /// The name of the pass in reports, captures, timings and errors. If it is not set, it becomes
    /// the name of the class when the pass is enqueued.
    ProfilingSampler profilingSampler{std::string(k_UnnamedPass)};

    /// Makes the pass's textures. It is called once per camera, before any pass executes, in the
    /// order of enqueueing.
    virtual void OnCameraSetup(CommandBuffer& /*cmd*/, RenderingData& /*renderingData*/) {}
    /// Configures the pass. It is called once per camera, after all OnCameraSetup, in the order of
    /// execution.
    virtual void Configure(CommandBuffer& /*cmd*/,
                           const RenderTextureDescriptor& /*cameraTextureDescriptor*/)
    {
    }
    /// Does the pass's work. Its targets are already bound and cleared.
    virtual void Execute(ScriptableRenderContext& context, RenderingData& renderingData);
    /// Does the pass's work as in Unity 6: what it adds to the graph runs when it returns. If a
    /// pass overrides Execute, too, this is called instead, unless the pipeline's
    /// enableRenderCompatibilityMode is on. Unity: ScriptableRenderPass.RecordRenderGraph (URP 17).
    virtual void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer& frameData);
    /// Cleans up. It is called once for each OnCameraSetup, after all passes have executed or one
    /// of them has thrown.
    virtual void OnCameraCleanup(CommandBuffer& /*cmd*/) {}
    /// Calls OnCameraCleanup, and is its name in URP 7 to 9: override one of the two.
    virtual void FrameCleanup(CommandBuffer& cmd) { OnCameraCleanup(cmd); }
    /// Cleans up behind the last camera of a stack in which this pass was enqueued; every camera is
    /// a stack of its own.
    virtual void OnFinishCameraStackRendering(CommandBuffer& /*cmd*/) {}

    ScriptableRenderPassInput input() const { return m_Input; }
    bool overrideCameraTarget() const { return m_OverrideCameraTarget; }
    /// Returns the first of the colours; empty if the pass draws depth only, or into the camera's
    /// targets.
    const RTHandle& colorAttachmentHandle() const;
    std::span<const RTHandle> colorAttachmentHandles() const { return m_Colors; }
    const RTHandle& depthAttachmentHandle() const { return m_Depth; }
    ClearFlag clearFlag() const { return m_ClearFlag; }
    const Color& clearColor() const { return m_ClearColor; }

    /// Makes the pass draw into these instead of the camera's targets, until ResetTarget. Without
    /// `depth` it has none: the camera's is not used. A depth texture in place of the colour is the
    /// depth.
    void ConfigureTarget(const RTHandle& color, const RTHandle& depth = {});
    /// Sets several colours at once. Empty handles behind the last colour are ignored.
    /// @throws ContractError for more than 8 colours
    void ConfigureTarget(std::span<const RTHandle> colors, const RTHandle& depth = {});
    /// Sets the targets that the identifiers stand for when the pass begins. Without a depth, the
    /// one that belongs to the colour is used: the camera's, or the one that GetTemporaryRT made
    /// with it.
    /// @throws ContractError for none, and for more than 8 colours
    /// @source Unity: ScriptableRenderPass.ConfigureTarget of identifiers (URP 14)
    void ConfigureTarget(RenderTargetIdentifier color)
    {
        ConfigureTarget(RTHandles::Alloc(std::move(color)));
    }
    void ConfigureTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth);
    void ConfigureTarget(std::span<const RenderTargetIdentifier> colors);
    void ConfigureTarget(std::span<const RenderTargetIdentifier> colors,
                         RenderTargetIdentifier depth);
    /// Clears the targets when they are bound. On the first binding of the camera's colour its
    /// background colour is used instead.
    void ConfigureClear(ClearFlag clearFlag, const Color& clearColor);
    /// Replaces the inputs that were set before (it does not add). Call it before the renderer's
    /// set-up reads them: in AddRenderPasses or earlier.
    void ConfigureInput(ScriptableRenderPassInput passInput) { m_Input = passInput; }
    void ResetTarget();
    // These have no effect: limn derives what is stored from what is read later, and stores no less
    // than is requested.
    void ConfigureColorStoreAction(RenderBufferStoreAction, std::uint32_t /*attachmentIndex*/ = 0)
    {
    }
    void ConfigureColorStoreActions(std::span<const RenderBufferStoreAction>) {}
    void ConfigureDepthStoreAction(RenderBufferStoreAction) {}

    /// Calls cmd.Blit, with the source as _MainTex; the pass's ConfigureClear clears the colour
    /// first.
    /// @param material  null = a plain copy, whatever `passIndex` is
    /// @source Unity: ScriptableRenderPass.Blit of identifiers (URP 14)
    void Blit(CommandBuffer& cmd, RenderTargetIdentifier source, RenderTargetIdentifier destination,
              std::shared_ptr<const Material> material = nullptr, int passIndex = 0) const;
    /// Calls Blitter::BlitCameraTexture, with the source as _BlitTexture.
    /// @param material  null = a plain copy
    /// @throws ContractError as BlitCameraTexture does
    /// @source Unity: ScriptableRenderPass.Blit of handles (URP 14)
    void Blit(CommandBuffer& cmd, const RTHandle& source, const RTHandle& destination,
              std::shared_ptr<const Material> material = nullptr, int passIndex = 0) const;

    /// Draws the camera's colour, as _BlitTexture, over another texture, which is the camera's
    /// colour from then on: nothing is copied back. In commands that cmd executes before that,
    /// CameraTarget still stands for the old one.
    /// @throws ContractError if the material is null, there is no such pass, or the renderer has
    ///     only one colour
    /// @source Unity: ScriptableRenderPass.Blit(cmd, ref data, material, passIndex) (URP 14)
    void Blit(CommandBuffer& cmd, RenderingData& data, std::shared_ptr<const Material> material,
              int passIndex = 0) const;

    /// Returns settings that draw with these LightMode tags, sorted by these criteria from the
    /// current camera.
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

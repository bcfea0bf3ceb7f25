#pragma once

#include <limn/core/ScriptableRenderPass.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <memory>
#include <span>
#include <vector>

namespace limn
{

class RenderGraphCamera;
class ShaderCompiler;
class ShaderSource;

/// Runs features and passes for one camera after the other, in URP's order of calls:
/// AddRenderPasses of all features, Setup, SetupRenderPasses of all features, OnCameraSetup of all
/// passes as enqueued, Configure of all passes as sorted, Execute of all, OnCameraCleanup of all.
/// Unity: UnityEngine.Rendering.Universal.ScriptableRenderer (URP 14).
class ScriptableRenderer
{
public:
    ScriptableRenderer() = default;
    virtual ~ScriptableRenderer();
    ScriptableRenderer(const ScriptableRenderer&) = delete;
    ScriptableRenderer& operator=(const ScriptableRenderer&) = delete;

    /// Adds a feature behind the others and calls its Create.
    ScriptableRendererFeature& AddFeature(std::unique_ptr<ScriptableRendererFeature> feature);
    const std::vector<std::unique_ptr<ScriptableRendererFeature>>& rendererFeatures() const
    {
        return m_Features;
    }

    /// Appends a pass to this camera's queue; if it is enqueued twice, it runs twice. Passes run in
    /// the order of their events; those of equal events run in the order of enqueueing, features'
    /// passes before built-in ones.
    /// @param pass  kept until the camera is done
    void EnqueuePass(ScriptableRenderPass& pass);

    /// Sets the source in which Shader::Find of features and passes looks. Call it before features
    /// are added, whose Create may use it. At first it is limn's own shaders, in a
    /// UniversalRenderer.
    void SetShaderSource(std::shared_ptr<ShaderSource> source)
    {
        m_ShaderSource = std::move(source);
    }

    /// Returns the feature that enqueued a pass of this frame in its AddRenderPasses; null for
    /// other passes.
    const ScriptableRendererFeature* FeatureOf(const ScriptableRenderPass& pass) const;

    /// Returns the compiler of the shaders of passes and features; null for a renderer without one.
    virtual std::shared_ptr<ShaderCompiler> shaderCompiler() const { return nullptr; }

    /// Returns the largest culling margin of the active features, in pixels.
    float cullingMargin(const VolumeStackPointer& volumeStack) const;

    /// Returns the target that the camera draws into. @throws ContractError outside rendering: as
    /// in Unity it exists from SetupRenderPasses and OnCameraSetup on, not in AddRenderPasses.
    const RTHandle& cameraColorTargetHandle() const;
    const RTHandle& cameraDepthTargetHandle() const;

    /// Sets UNITY_MATRIX_V, UNITY_MATRIX_P and UNITY_MATRIX_VP for draws that follow.
    /// @source Unity: ScriptableRenderer.SetCameraMatrices (URP 14)
    static void SetCameraMatrices(CommandBuffer& cmd, const CameraData& cameraData,
                                  bool setInverseMatrices)
    {
        cmd.SetViewProjectionMatrices(cameraData.viewMatrix, cameraData.gpuProjectionMatrix,
                                      setInverseMatrices);
    }

    /// Returns an identifier of the camera's colour. It may be called at any time, in
    /// AddRenderPasses as well: the identifier stands for the colour at the time when a command is
    /// executed. It brings a depth along only for the values for which
    /// UniversalRenderPipeline::pipelineVersion documents that.
    /// @source Unity: ScriptableRenderer.cameraColorTarget (URP 8 to 14)
    RenderTargetIdentifier cameraColorTarget() const
    {
        return BuiltinRenderTextureType::CameraColor;
    }
    /// @throws ContractError outside rendering, as cameraDepthTargetHandle does
    RenderTargetIdentifier cameraDepthTarget() const { return cameraDepthTargetHandle().nameID(); }

    /// Runs steps 8 to 10 of a camera: features add passes, everything runs, the queue is empty
    /// again. If something throws, passes that were set up are cleaned up, and the queue is empty
    /// as well. An overlay camera follows the cameras of its stack, and draws onto their targets.
    void RenderCamera(ScriptableRenderContext& context, RenderingData& renderingData);

    /// A place between two passes of a frame.
    struct PassPlace
    {
        ScriptableRenderContext::Place commands;
        std::size_t pass = 0; ///< index in RenderReport::passes of the next pass
    };

protected:
    /// Makes the camera's targets (ConfigureCameraTarget) and enqueues built-in passes.
    virtual void Setup(ScriptableRenderContext& context, RenderingData& renderingData) = 0;
    /// Returns a texture like the camera's colour that is not in use, kept for SwapColorBuffer.
    /// @throws ContractError if the renderer has none
    virtual const RTHandle& GetCameraColorFrontBuffer();
    /// Makes the texture of GetCameraColorFrontBuffer the camera's colour, for `cmd` from here on.
    virtual void SwapColorBuffer(CommandBuffer& cmd);
    /// Makes another texture of the same size the camera's colour, for `cmd` from here on.
    virtual void SetCameraColor(CommandBuffer& cmd, const RTHandle& color);
    /// Returns the CameraTargets::copy of its cameras.
    virtual std::shared_ptr<const Material> copyMaterial() const { return nullptr; }
    void ConfigureCameraTarget(RTHandle color, RTHandle depth);
    /// Returns the passes enqueued so far.
    std::span<ScriptableRenderPass* const> activeRenderPassQueue() const { return m_Queue; }

    /// Prepares a pass. It is called before each pass is executed, in their order, and once behind
    /// the last.
    /// @param next  null behind the last
    virtual void BeforePass(ScriptableRenderContext& context, RenderingData& renderingData,
                            const ScriptableRenderPass* next, const PassPlace& place);
    /// Executes a pass at an earlier place, with the globals of that place. Places behind it must
    /// not be used any more.
    void ExecuteAt(const PassPlace& place, ScriptableRenderContext& context,
                   ScriptableRenderPass& pass, RenderingData& renderingData);

private:
    friend class ScriptableRenderPass; // Blit swaps

    /// Returns the index of the feature that added the pass; the number of features, or more, if
    /// none did.
    std::size_t FeatureIndexOf(const ScriptableRenderPass& pass) const;
    void RecordRenderGraph(ScriptableRenderPass& pass, ScriptableRenderContext& context,
                           RenderingData& renderingData);

    void AddRenderPasses(RenderingData& renderingData);
    void Execute(ScriptableRenderContext& context, RenderingData& renderingData);
    void ExecutePasses(ScriptableRenderContext& context, RenderingData& renderingData,
                       CommandBuffer& cmd);
    void ExecuteRenderPass(ScriptableRenderContext& context, ScriptableRenderPass& pass,
                           RenderingData& renderingData);
    void BindTargets(CommandBuffer& cmd, const ScriptableRenderPass& pass, const CameraData& data);
    void ClearApart(CommandBuffer& cmd, const ScriptableRenderPass& pass, const CameraData& data);

    std::vector<std::unique_ptr<ScriptableRendererFeature>> m_Features;
    std::vector<ScriptableRenderPass*> m_Queue;
    std::vector<ScriptableRenderPass*> m_FeaturePasses; ///< of these, as enqueued
    /// The end of each feature in m_FeaturePasses.
    std::vector<std::size_t> m_FeaturePassEnds;
    std::shared_ptr<ShaderSource> m_ShaderSource; ///< null = nowhere
    RTHandle m_CameraColor;
    RTHandle m_CameraDepth;
    std::shared_ptr<RenderGraphCamera> m_RenderGraph; ///< null until a pass records one
    bool m_Executing = false;
    bool m_FirstColor = true;
    bool m_FirstDepth = true;
};

} // namespace limn

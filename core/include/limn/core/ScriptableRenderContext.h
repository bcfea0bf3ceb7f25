#pragma once

#include <functional>
#include <limn/core/CommandBuffer.h>
#include <limn/core/Culling.h>
#include <limn/core/Light.h>
#include <limn/core/RenderReport.h>
#include <limn/core/RendererList.h>
#include <span>

namespace limn
{

class DrawRecorder;
class RenderTargetResolver;
class RenderTexturePool;

/// The targets that identifiers stand for while a camera is rendered.
struct CameraTargets
{
    RTHandle color;
    RTHandle depth;
    RenderTexturePool* temporaryTextures = nullptr; ///< null = none can be made
    /// The material that draws _BlitTexture over the whole target, with the nearest texel or
    /// bilinearly; null if the renderer has no shaders.
    std::shared_ptr<const Material> copy;
    static constexpr int k_NearestPass = 0;
    static constexpr int k_BilinearPass = 1;
};

/// The state that holds for all draws until it is set again.
struct CommonDrawState
{
    std::optional<ViewportRect> scissor; ///< none = the whole target
    bool invertsCulling = false;
    float depthBias = 0.0f; ///< positive = farther, as PipelineState's offsets
    float slopeDepthBias = 0.0f;
};

/// Turns what passes record into the frame's list of commands. Materials, globals and LightMode
/// tags are looked up, so that the list is plain data.
/// Unity: UnityEngine.Rendering.ScriptableRenderContext (2022.3).
class ScriptableRenderContext
{
public:
    /// Makes a context that is not begun: call Begin first.
    ScriptableRenderContext();
    explicit ScriptableRenderContext(RenderReport& report,
                                     const glm::dvec3& origin = glm::dvec3(0.0));
    ~ScriptableRenderContext();
    ScriptableRenderContext(const ScriptableRenderContext&) = delete;
    ScriptableRenderContext& operator=(const ScriptableRenderContext&) = delete;

    /// Forgets everything that was recorded and made global. One context for all frames is cheaper
    /// than one for each.
    /// @param report               must outlive the frame
    /// @param origin               the point to which positions are relative on the device, see
    ///     Camera::renderOrigin
    /// @param spare                commands of an earlier frame, whose memory is used again
    /// @param usesReversedZBuffer  see ShaderCompilerOptions
    void Begin(RenderReport& report, const glm::dvec3& origin, FrameCommands spare = {},
               bool usesReversedZBuffer = true);

    /// Sets the lights from which DrawRenderers gives each object the brightest, up to `limit`. If
    /// there are no more than that, and for draws by command buffers, the global lights are used.
    /// @param lights  the additional lights of shaders; none is null, at most 32
    /// @param limit   0...8
    void SetObjectLights(std::span<const Light* const> lights, int limit);

    /// Sets the targets that identifiers in command buffers stand for until EndCamera.
    void BeginCamera(CameraTargets camera);
    /// Gives back the temporary textures that were not released.
    void EndCamera();

    /// Appends the buffer's commands; the buffer may be cleared and used again afterwards.
    /// @throws AssetError if a shader pass does not compile
    void ExecuteCommandBuffer(const CommandBuffer& commandBuffer);

    /// Appends draws of the items that pass the filter into the bound target, and counts in the
    /// report the verdict on every item.
    /// @param stateBlock  replaces groups of the passes' own state
    /// @throws AssetError if a shader pass does not compile and there is no fallbackMaterial
    /// @throws ContractError if an override's pass index is none of its shader's
    void DrawRenderers(const CullingResults& cullingResults, const DrawingSettings& drawingSettings,
                       const FilteringSettings& filteringSettings,
                       const RenderStateBlock& stateBlock = RenderStateBlock());

    /// Makes a list for CommandBuffer::DrawRendererList in this camera's frame. Nothing is computed
    /// before it is drawn. Unity: ScriptableRenderContext.CreateRendererList (2022.3).
    RendererList CreateRendererList(const RendererListParams& param) const
    {
        return RendererList(param);
    }
    RendererList CreateRendererList(const RendererListDesc& desc) const
    {
        return RendererList(desc.ToParams());
    }

    /// Sets the name of the pass that makes the following calls, for the report.
    void SetPassName(std::string_view name) { m_PassName = SampleName(name); }
    void SetPassName(SampleName name) { m_PassName = name; }

    /// A place between two commands of the frame, with the state that held for all draws there.
    struct Place
    {
        std::size_t command = 0;
        std::size_t globalChange = 0;
        CommonDrawState state;
    };
    /// Returns the current place, for RecordAt.
    Place MarkPlace();
    /// Inserts what `record` records at an earlier place. Its draws see the globals of that place,
    /// and what it makes global ends with it. Places behind it must not be used any more.
    void RecordAt(const Place& place, const std::function<void()>& record);

    /// Returns whether a draw of this camera so far has the texture bound.
    bool Reads(const Texture& texture) const;

    /// Returns everything recorded so far; the context is empty afterwards.
    FrameCommands TakeCommands();

private:
    void Run(const CommandBuffer& commandBuffer);
    void GenerateMips(const RenderTexture& texture);

    friend class RenderGraphRun; // looks at what a pass recorded

    RenderReport* m_Report = nullptr;
    glm::dvec3 m_Origin{0.0};
    SampleName m_PassName;
    FrameCommands m_Frame;
    std::unique_ptr<DrawRecorder> m_Recorder;
    std::unique_ptr<RenderTargetResolver> m_Identified;
};

} // namespace limn

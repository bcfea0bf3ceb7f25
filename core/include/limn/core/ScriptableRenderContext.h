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

/// What identifiers stand for while a camera is rendered.
struct CameraTargets
{
    RTHandle color;
    RTHandle depth;
    RenderTexturePool* temporaryTextures = nullptr; ///< null = there are none to be had
    /// Passes 0 and 1 draw _BlitTexture over the whole target, the nearest texel and bilinear; null
    /// where the renderer has no shaders.
    std::shared_ptr<const Material> copy;
};

/// What holds for all draws until it is set otherwise.
struct CommonDrawState
{
    std::optional<ViewportRect> scissor; ///< none = the whole target
    bool invertsCulling = false;
    float depthBias = 0.0f; ///< positive = farther, as PipelineState's offsets
    float slopeDepthBias = 0.0f;
};

/// Turns what passes record into the frame's list of commands, with materials, globals and
/// LightMode tags looked up: the list is plain data.
/// Unity: UnityEngine.Rendering.ScriptableRenderContext (2022.3).
class ScriptableRenderContext
{
public:
    /// Begin comes first.
    ScriptableRenderContext();
    explicit ScriptableRenderContext(RenderReport& report,
                                     const glm::dvec3& origin = glm::dvec3(0.0));
    ~ScriptableRenderContext();
    ScriptableRenderContext(const ScriptableRenderContext&) = delete;
    ScriptableRenderContext& operator=(const ScriptableRenderContext&) = delete;

    /// Forgets everything that was recorded and made global. One context for all frames is cheaper
    /// than one for each.
    /// @param report  must outlive the frame
    /// @param origin  what the device sees positions relative to, see Camera::renderOrigin
    /// @param spare   of an earlier frame: the memory of its lists is used again
    /// @param usesReversedZBuffer  see ShaderCompilerOptions
    void Begin(RenderReport& report, const glm::dvec3& origin, FrameCommands spare = {},
               bool usesReversedZBuffer = true);

    /// DrawRenderers gives each object the brightest of these, at most so many of them. Where there
    /// are no more than that, and for draws by command buffers, what is global holds.
    /// @param lights  what shaders call the additional lights; none is null, at most 32
    /// @param limit   0...8
    void SetObjectLights(std::span<const Light* const> lights, int limit);

    /// From here to EndCamera identifiers in command buffers stand for these.
    void BeginCamera(CameraTargets camera);
    /// Gives back the temporary textures that nobody released.
    void EndCamera();

    /// Appends the buffer's commands; the buffer may be cleared and used again afterwards.
    /// @throws AssetError if a shader pass does not compile
    void ExecuteCommandBuffer(const CommandBuffer& commandBuffer);

    /// Appends draws of what passes the filter into the target that is bound, and counts in the
    /// report what became of every item.
    /// @param stateBlock  replaces groups of the passes' own state
    /// @throws AssetError if a shader pass does not compile and there is no fallbackMaterial
    /// @throws ContractError if an override's pass index is none of its shader's
    void DrawRenderers(const CullingResults& cullingResults, const DrawingSettings& drawingSettings,
                       const FilteringSettings& filteringSettings,
                       const RenderStateBlock& stateBlock = RenderStateBlock());

    /// For CommandBuffer::DrawRendererList in this camera's frame. Nothing is worked out before it
    /// is drawn. Unity: ScriptableRenderContext.CreateRendererList (2022.3).
    RendererList CreateRendererList(const RendererListParams& param) const;
    RendererList CreateRendererList(const RendererListDesc& desc) const;

    /// Whose calls these are, for the report.
    void SetPassName(std::string_view name) { m_PassName = SampleName(name); }
    void SetPassName(SampleName name) { m_PassName = name; }

    /// A place between two commands of the frame, and what held for all draws there.
    struct Place
    {
        std::size_t command = 0;
        std::size_t globalChange = 0;
        CommonDrawState state;
    };
    /// Here and now, for RecordAt.
    Place MarkPlace();
    /// Puts what `record` records at an earlier place; draws see the globals of then, and what it
    /// makes global ends with it. No place behind it may be used any more.
    void RecordAt(const Place& place, const std::function<void()>& record);

    /// Whether a draw of this camera so far has the texture bound.
    bool Reads(const Texture& texture) const;

    /// Everything so far; the context is empty afterwards.
    FrameCommands TakeCommands();

private:
    void Run(const CommandBuffer& commandBuffer);
    void GenerateMips(const RenderTexture& texture);

    friend class RenderGraphRun; // looks at what a pass recorded

    RenderReport* m_Report = nullptr;
    glm::dvec3 m_Origin{0.0};
    SampleName m_PassName;
    FrameCommands m_Frame;
    MaterialPropertyBlock m_Globals;
    std::unique_ptr<DrawRecorder> m_Recorder;
    std::unique_ptr<RenderTargetResolver> m_Identified;
};

} // namespace limn

#pragma once

#include "cull/ObjectLights.h"
#include "record/RecordedCommands.h"
#include "resolve/DrawResolver.h"

#include <functional>
#include <limn/core/CommandBuffer.h>
#include <limn/core/RenderStateBlock.h>
#include <limn/core/ScriptableRenderContext.h>
#include <map>
#include <tuple>

namespace limn
{

/// The properties that win over a material's values; null = none.
struct DrawProperties
{
    const MaterialPropertyBlock* own = nullptr;    ///< of the draw, or its renderer
    const MaterialPropertyBlock* lights = nullptr; ///< the lights of ObjectLights
};

/// Resolves recorded draws and appends them to the frame.
class DrawRecorder
{
public:
    using Place = ScriptableRenderContext::Place;

    /// @param passName  the pass whose draws are recorded at the time
    DrawRecorder(FrameCommands& frame, const SampleName& passName)
        : m_Frame(frame), m_Resolver(m_Globals, passName)
    {
    }

    /// Begins a frame.
    /// @param notes   receives sentences for the user
    /// @param origin  the point to which positions are relative on the device
    void Begin(std::vector<std::string>& notes, const glm::dvec3& origin);

    /// Begins a camera of a frame, which may have several.
    void BeginCamera();
    const FrameGlobals& globals() const { return m_Globals; } ///< as they are now
    /// Ends a frame, see DrawResolver::End.
    void End() { m_Resolver.End(); }

    void SetGlobal(const SetGlobalCommand& command);
    void SetKeyword(const SetKeywordCommand& command);
    /// Returns the keywords that are on for all materials, sorted.
    std::span<const std::string> keywords();
    std::span<const std::string> ProceduralKeywords();
    /// Returns the lights that an object at this place has; null if the shader or the frame does
    /// not need them.
    const MaterialPropertyBlock* LightsOf(const RecordedDraw& recorded,
                                          const ShaderProgram& program);
    /// Takes over what Shader::SetGlobalFloat and its like have changed, unless the frame has set
    /// something else.
    void TakeShaderGlobals();
    void SetViewProjection(const SetViewProjectionCommand& command);
    void SetMatrix(const SetViewCommand& command);
    void SetMatrix(const SetProjectionCommand& command);
    /// @throws ContractError naming the buffer, if a draw or dispatch of the frame has it already
    void ExpectUnused(const GraphicsBuffer& buffer, const char* call) const;
    void SetRenderTarget(const SetRenderTargetCommand& command);
    CommonDrawState& commonState() { return m_State; } ///< for what is drawn from now on
    /// @param properties  of the draw; null = none
    void Draw(const RecordedDraw& recorded, const MaterialPropertyBlock* properties);

    /// Resolves a dispatch and appends it.
    void Dispatch(const RecordedDispatch& recorded);
    /// @param kernel  made by MakeCopyKernel
    void Copy(const CopyBufferCommand& command, const std::shared_ptr<const ComputeShader>& kernel);

    Place MarkPlace();
    /// Runs `record` with the globals of that place.
    void WithGlobalsOf(const Place& place, const std::function<void()>& record);
    /// Returns whether a draw of this camera reads the texture.
    bool Reads(const Texture& texture) const { return m_Resolver.HasBound(texture); }

    /// Returns the state that all draws of this pass have in common.
    /// @param recorded  a draw that may be procedural or indirect; null = there is none
    /// @throws AssetError if the pass does not compile
    DrawSetup LookUp(const Material& material, int shaderPass, const DrawProperties& properties,
                     const RenderStateBlock& stateBlock, const RecordedDraw* recorded = nullptr);
    /// Returns a material with the values of this one and another shader; it is the same object as
    /// long as each frame asks for it.
    std::shared_ptr<const Material> WithShader(const std::shared_ptr<const Material>& material,
                                               const std::shared_ptr<const Shader>& shader);
    /// Returns the region in which a box is seen, in the shaders' coordinates; nothing if it may be
    /// anywhere.
    /// @param radius  see ProjectBounds
    std::optional<TargetRegion> Project(const Bounds& bounds, float radius,
                                        const PerDrawData& perDraw) const;

    /// Returns PipelineState::frontFaceFlipped of a draw into the bound target, depending on
    /// whether its transform mirrors.
    bool FlipsFrontFace(bool isMirrored) const
    {
        return (isMirrored != m_State.invertsCulling) != m_IsFlipped;
    }

    /// Returns the number of a setup, or of a mesh, in the frame's tables.
    std::uint32_t Add(DrawSetup setup);
    std::uint32_t Add(const std::shared_ptr<const Mesh>& mesh);

    FrameCommands& frame() { return m_Frame; }
    ObjectLights& objectLights() { return m_ObjectLights; } ///< of this camera
    bool hasDepth() const { return m_Depth != nullptr; }    ///< in the bound target

private:
    void Take(ShaderPropertyId id, const ShaderPropertyValue& value);
    void TurnProjection();
    void UndoChanges(std::size_t begin, std::size_t end);
    void Dispatch(const RecordedDispatch& recorded, const PropertySources& sources);
    void ExpectSameDepth(const Material& material) const;
    void ExpectStencil(const PipelineState& state, const Material& material, int shaderPass) const;
    void NoteMissingDepth(const PipelineState& state, const Material& material, int shaderPass);
    bool MayCover(const RecordedDraw& recorded, const PipelineState& state) const;
    std::shared_ptr<const FullScreenPromise> Promise(const RecordedDraw& recorded,
                                                     const MaterialPropertyBlock* properties,
                                                     const PipelineState& state);
    bool MergeIntoLast(const DrawCommand& draw);
    const std::shared_ptr<const Mesh>& QuadIndices(std::uint32_t count);

    struct GlobalChange
    {
        FrameGlobals::Place place = 0;
        /// The value before it; after it, while a pass is recorded at a place before. None = it
        /// was not set.
        std::optional<ShaderPropertyValue> other;
    };

    struct Variant
    {
        std::shared_ptr<const Material> material;
        bool isUsed = false; ///< in this frame
    };

    FrameCommands& m_Frame;
    FrameGlobals m_Globals;
    std::vector<GlobalChange> m_Changes; ///< since the first place was marked
    bool m_KeepsChanges = false;
    std::uint64_t m_GlobalsVersion = 0;
    std::vector<GlobalKeyword> m_KnownKeywords; ///< all that were ever switched, by name
    std::vector<std::string> m_Keywords; ///< the keywords that are on, unless m_AreKeywordsOld
    std::size_t m_KeywordCount = 0;      ///< of them; the strings behind keep their memory
    std::vector<std::string> m_ProceduralKeywords;
    bool m_AreKeywordsOld = false;
    std::uint64_t m_ShaderGlobalsVersion = 0;
    std::map<ShaderPropertyId, ShaderPropertyValue> m_ShaderGlobals; ///< taken over in this frame
    glm::dvec3 m_Origin{0.0};
    glm::dmat4 m_View{1.0};       ///< the view that was set last
    glm::mat4 m_Projection{1.0f}; ///< for a target whose projection is flipped
    CommonDrawState m_State;
    const RenderTexture* m_Target = nullptr;      ///< the first colour bound, or the depth
    std::shared_ptr<const RenderTexture> m_Depth; ///< of the bound target
    bool m_IsFlipped = true;                      ///< IsProjectionFlipped of the bound target
    ObjectLights m_ObjectLights;
    DrawResolver m_Resolver;
    std::vector<std::string>* m_Notes = nullptr; ///< of the frame
    MaterialPropertyBlock m_CopyParams;          ///< for its memory
    struct MeshPlace
    {
        std::uint32_t index = 0; ///< in the frame's table
        bool isUsed = false;     ///< in this frame
    };
    std::unordered_map<const Mesh*, MeshPlace> m_MeshPlaces;
    struct Quads
    {
        std::shared_ptr<const Mesh> mesh;
        bool isUsed = false; ///< in this frame
    };
    std::unordered_map<std::uint32_t, Quads> m_Quads; ///< by how many
    bool m_HasDraws = false;                          ///< in this frame
    /// The promises in the order of the draws; behind m_PromiseCount those of the frame before.
    std::vector<std::shared_ptr<const FullScreenPromise>> m_Promises;
    std::size_t m_PromiseCount = 0;
    std::map<
        std::tuple<std::shared_ptr<const Material>, std::uint64_t, std::shared_ptr<const Shader>>,
        Variant>
        m_WithShader;
};

/// Returns whether draws that differ in their transform may become instances of one. Only a vertex
/// function knows its instance, and one that takes SV_InstanceID must find 0 in each draw.
bool isInstanceable(const ShaderProgram& program);

} // namespace limn

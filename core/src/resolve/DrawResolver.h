#pragma once

#include "resolve/ProgramUniforms.h"

#include <iterator>
#include <limn/core/ComputeShader.h>
#include <limn/core/FrameCommands.h>
#include <limn/core/Material.h>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace limn
{

/// Keeps those values of a map that were marked isUsed, and removes the mark from them.
template <typename Map>
void EraseUnused(Map& map)
{
    for (auto entry = map.begin(); entry != map.end();)
    {
        entry = std::exchange(entry->second.isUsed, false) ? std::next(entry) : map.erase(entry);
    }
}

/// The sources of the property values of a draw or dispatch, first to last.
struct PropertySources
{
    const MaterialPropertyBlock* block = nullptr; ///< may be null; a kernel's own
    const Material* material = nullptr;           ///< null = a dispatch's
    const FrameGlobals* globals = nullptr;        ///< never null
    const ComputeShader* compute = nullptr;       ///< null = a draw's
    int kernel = 0;
    const BufferRange* arguments = nullptr; ///< set for an indirect draw or dispatch, else null
    const MaterialPropertyBlock* lights = nullptr; ///< the lights of an object, before all else
    /// If true, its buffers may be made for anything, and a counter lies in them at
    /// counterOffset().
    bool isCopy = false;

    const ShaderPropertyValue* Find(ShaderPropertyId id) const;
    bool HasBuffers() const; ///< else no value is a buffer
    bool IsKeywordEnabled(std::string_view keyword) const;
    /// Returns the owner of the values for messages: "material 'Paint'"
    std::string Subject() const;
    std::string Subject(const std::string& property) const; ///< of one of them
};

/// Turns property values into the bytes and slots that a compiled pass binds. It reuses in the next
/// frame what it found out in one.
class DrawResolver
{
public:
    /// @param globals   of the frames
    /// @param passName  the pass whose draws are resolved at the time, for the notes
    DrawResolver(FrameGlobals& globals, const SampleName& passName)
        : m_Globals(globals), m_PassName(passName)
    {
    }

    /// Begins a frame.
    /// @param notes  receives a sentence for each texture of a shader that nothing gives a value,
    ///     and those of the passes themselves
    void Begin(std::vector<std::string>& notes);

    /// Ends a frame: adds to the notes a sentence for each property that was set on a material,
    /// that its shader's passes do not name and that nothing drawn with it has read.
    void End();

    /// Returns the bindings of a draw; equal ones of draws without a block of their own are shared.
    /// If the frame before bound the same at this point, it is the same object.
    /// @param globalsVersion  grows whenever `sources.globals` changes, and with each frame
    std::shared_ptr<const DrawBindings> Resolve(const std::shared_ptr<const ShaderProgram>& pass,
                                                const PropertySources& sources,
                                                std::uint64_t globalsVersion,
                                                std::vector<std::byte>& uniformData);

    /// Returns the bindings of a dispatch.
    std::shared_ptr<const DrawBindings> Resolve(const std::shared_ptr<const ShaderProgram>& kernel,
                                                const PropertySources& sources,
                                                std::vector<std::byte>& uniformData);

    /// Returns the result of ResolveState for a pass, which is kept until a property of the
    /// material changes.
    PipelineState StateOf(const Material& material, int shaderPass);

    /// Begins a camera, for which HasBound forgets the draws so far.
    void BeginCamera() { ++m_Camera; }

    /// Returns whether a draw of this camera so far has the texture bound.
    bool HasBound(const Texture& texture) const
    {
        const auto bound = m_Bound.find(texture.id());
        return bound != m_Bound.end() && bound->second.isUsed && bound->second.camera == m_Camera;
    }

private:
    /// The state of a sampler if it is known, or the texture whose sampler it is.
    struct SamplerSource
    {
        std::optional<SamplerState> state;
        ShaderPropertyId texture;
    };
    struct StoragePlace
    {
        ShaderPropertyId id;
        bool isPerDraw = false;
        bool isDevices = false; ///< the device fills it
    };
    /// The names of a layout as ids, computed once for each shader that has the pass.
    struct ProgramIds
    {
        std::shared_ptr<const ShaderProgram> pass; ///< keeps the address of the key in use
        std::optional<ProgramUniforms> uniforms;   ///< set
        std::vector<ShaderPropertyId> textures;
        /// The values, by texture, that the shader's Properties have if nothing sets it; null = not
        /// known yet.
        std::vector<std::shared_ptr<const Texture>> defaults;
        std::vector<SamplerSource> samplers;
        std::vector<StoragePlace> storageBuffers;
        std::vector<ShaderPropertyId> storageTextures;
        bool isUsed = false; ///< in this frame
    };
    static bool Reads(const ProgramIds& ids, ShaderPropertyId property);
    /// Marks those of the material's undeclared properties that the program reads.
    void FollowUndeclared(const ProgramIds& ids, const Material& material);
    ProgramIds MakeIds(const std::shared_ptr<const ShaderProgram>& pass);
    void Note(const std::string& message, const std::string& shader);
    /// @param shader  the name and the id of the shader whose pass it is
    ProgramIds& IdsOf(const std::shared_ptr<const ShaderProgram>& pass, const std::string& shader,
                      std::uint64_t shaderId);
    /// The uniform values of a draw, which are kept in layers; a dispatch has none.
    struct UniformLayers
    {
        ProgramUniforms::MaterialLayer* material = nullptr;
        std::uint64_t globalsVersion = 0;
    };
    std::shared_ptr<const DrawBindings> Build(ProgramIds& ids, const PropertySources& sources,
                                              const UniformLayers& layers,
                                              std::vector<std::byte>& uniformData);
    void AddUniforms(ProgramIds& ids, const PropertySources& sources, const UniformLayers& layers,
                     std::vector<std::byte>& uniformData);
    void AddTextures(ProgramIds& ids, const PropertySources& sources);
    void AddStorage(const ProgramIds& ids, const PropertySources& sources);
    std::shared_ptr<const Texture> TextureOf(ProgramIds& ids, std::size_t texture,
                                             const PropertySources& sources);
    std::shared_ptr<const Texture> DefaultOf(ShaderPropertyId id, TextureDimension dimension,
                                             const PropertySources& sources,
                                             std::shared_ptr<const Texture>& known);

    /// A pass, and the id of the material or the shader that has it.
    template <typename Pass>
    struct PassKey
    {
        Pass pass;
        std::uint64_t owner;
        bool operator==(const PassKey&) const = default;
    };
    struct HashKey
    {
        template <typename Pass>
        std::size_t operator()(const PassKey<Pass>& key) const
        {
            return std::hash<Pass>()(key.pass) * 31 + key.owner;
        }
    };
    struct KnownState
    {
        std::uint64_t materialVersion = 0;
        bool isKnown = false; ///< if false, it depends on globals
        bool isUsed = false;  ///< in this frame
        PipelineState state;
    };
    std::unordered_map<PassKey<int>, KnownState, HashKey> m_States;
    /// The bindings that a material last had without values of a draw's own, and its uniform
    /// values.
    struct Shared
    {
        std::uint64_t materialVersion = 0;
        std::uint64_t globalsVersion = 0;
        std::size_t built = 0; ///< in m_Built
        ProgramUniforms::MaterialLayer uniforms;
        bool isUsed = false; ///< in this frame
    };
    FrameGlobals& m_Globals;
    std::unordered_map<PassKey<const ShaderProgram*>, ProgramIds, HashKey> m_Ids;
    std::unordered_map<PassKey<const ShaderProgram*>, Shared, HashKey> m_Shared;
    /// The bindings in the order in which they were needed; behind m_BuiltCount those of the frame
    /// before.
    std::vector<std::shared_ptr<const DrawBindings>> m_Built;
    std::size_t m_BuiltCount = 0;
    DrawBindings m_Building;
    bool m_HasResolved = false; ///< whether anything was resolved in this frame
    struct Bound
    {
        bool isUsed = false;      ///< in this frame
        std::uint64_t camera = 0; ///< the last one that did
    };
    /// A property that was set on materials of a shader whose Properties block lacks it.
    struct Undeclared
    {
        std::shared_ptr<const Shader> shader;
        std::string material; ///< the first one drawn
        bool isRead = false;  ///< by a program, in any frame so far
        bool isUsed = false;  ///< in this frame
    };
    std::map<std::pair<std::uint64_t, ShaderPropertyId>, Undeclared> m_Undeclared; ///< by shader
    std::uint64_t m_Camera = 0;
    std::unordered_map<std::uint64_t, Bound> m_Bound; ///< by the texture's id
    struct SharedNote
    {
        std::size_t index; ///< in m_Notes
        std::vector<std::string> shaders;
    };
    std::vector<std::string>* m_Notes = nullptr; ///< never null in a frame
    const SampleName& m_PassName;
    /// The notes that concern several shaders, by message.
    std::map<std::string, SharedNote> m_SharedNotes;
    /// The pairs of shader and texture that have a note.
    std::set<std::pair<std::uint64_t, ShaderPropertyId>> m_Noted;
};

/// Returns a pass's state with the material's values in place of its property references; a name
/// that the material lacks is looked up in `globals`.
/// @param readsGlobals  set to true if a global was looked for; may be null
/// @param unset         gets "Cull [_Cull]" for each reference to a property that nothing sets,
///                      whose value is 0 then, as in Unity; may be null
/// @throws ContractError naming material, shader and property, if a value is no member of the enum
PipelineState ResolveState(const RenderState& state, const Material& material,
                           const FrameGlobals& globals, bool* readsGlobals = nullptr,
                           std::vector<std::string>* unset = nullptr);

} // namespace limn

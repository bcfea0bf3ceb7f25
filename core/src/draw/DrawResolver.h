#pragma once

#include <limn/core/FrameCommands.h>
#include <limn/core/Material.h>
#include <map>
#include <set>
#include <unordered_map>

namespace limn
{

/// Where a draw's property values come from, first to last.
struct PropertySources
{
    const MaterialPropertyBlock* block = nullptr;   ///< may be null
    const Material* material = nullptr;             ///< never null
    const MaterialPropertyBlock* globals = nullptr; ///< never null

    const ShaderPropertyValue* Find(ShaderPropertyId id) const;
};

/// Turns property values into the bytes and slots a compiled pass binds. One frame long.
class DrawResolver
{
public:
    /// @param notes  gets a sentence for each texture of a shader that nothing gives a value, and
    ///               those of the passes themselves
    explicit DrawResolver(std::vector<std::string>& notes) : m_Notes(notes) {}

    /// The bindings of a draw; equal ones of draws without a block of their own are shared.
    /// @param globalsVersion  changes whenever `sources.globals` does
    std::shared_ptr<const DrawBindings> Resolve(const std::shared_ptr<const ShaderProgram>& pass,
                                                const PropertySources& sources,
                                                std::uint64_t globalsVersion,
                                                std::vector<std::byte>& uniformData);

private:
    /// The names of a layout as ids, worked out once a pass.
    struct ProgramIds
    {
        std::shared_ptr<const ShaderProgram> pass;          ///< keeps the key's address taken
        std::vector<std::vector<ShaderPropertyId>> members; ///< by buffer
        std::vector<ShaderPropertyId> textures;
    };
    void Note(const std::string& message, const Shader& shader);
    const ProgramIds& IdsOf(const std::shared_ptr<const ShaderProgram>& pass, const Shader& shader);
    std::shared_ptr<const DrawBindings> Build(const ProgramIds& ids, const PropertySources& sources,
                                              std::vector<std::byte>& uniformData);
    std::vector<TextureSlot> TextureSlots(const ProgramIds& ids, const PropertySources& sources);
    std::shared_ptr<const Texture> TextureOf(ShaderPropertyId id, const TextureBinding& binding,
                                             const PropertySources& sources);
    std::shared_ptr<const Texture> DefaultOf(ShaderPropertyId id, TextureDimension dimension,
                                             const PropertySources& sources);

    struct SharedKey
    {
        const ShaderProgram* pass;
        std::uint64_t materialId;
        std::uint64_t materialVersion;
        std::uint64_t globalsVersion;
        auto operator<=>(const SharedKey&) const = default;
    };
    std::unordered_map<const ShaderProgram*, ProgramIds> m_Ids;
    std::map<SharedKey, std::shared_ptr<const DrawBindings>> m_Shared;
    struct SharedNote
    {
        std::size_t index; ///< in m_Notes
        std::vector<std::string> shaders;
    };
    std::vector<std::string>& m_Notes;
    std::map<std::string, SharedNote> m_SharedNotes; ///< of several shaders, by message
    std::set<std::pair<std::uint64_t, ShaderPropertyId>> m_Noted; ///< shaders with textures
};

} // namespace limn

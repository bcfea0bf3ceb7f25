#pragma once

#include "material/FrameGlobals.h"

#include <limn/core/FrameCommands.h>
#include <span>
#include <vector>

namespace limn
{

class Material;
struct PropertySources;

/// A member of a uniform buffer in a form that frames can go through: the data for writing it takes
/// few bytes, and its name is not looked up any more.
struct UniformPlace
{
    /// Selects the value if it has not been set.
    enum class Unset : std::uint8_t
    {
        Zero,
        OneOneZeroZero,
        TexelSize ///< 1/width, 1/height, width, height of `texture`
    };

    explicit UniformPlace(const UniformMember& member);

    ShaderPropertyId id;
    ShaderPropertyId texture;
    std::uint32_t offset = 0; ///< bytes from the start of the buffer
    std::uint32_t size = 0;   ///< bytes, arrays included
    std::uint32_t arrayStride = 0;
    int arraySize = 0; ///< 0 = not an array
    UniformType type = UniformType::Float;
    std::uint8_t components = 1; ///< of the vector; 4 for Matrix4x4
    Unset unset = Unset::Zero;
};

/// Writes one value of a uniform buffer. A name that nothing has set is zero, except for `X_ST` and
/// `X_HDR` (1, 1, 0, 0) and `X_TexelSize` (1/width, 1/height, width, height of the texture bound to
/// X).
/// @param value    null = nothing has set it
/// @param texture  the texture X, if the value is not set; null = nothing has set that either
/// @param buffer   all bytes that UniformPlace::offset counts
/// @return false if the value's kind does not fit; then it is zero
bool WriteUniform(const UniformPlace& member, const ShaderPropertyValue* value,
                  const ShaderPropertyValue* texture, std::span<std::byte> buffer);

/// Writes the value that the sources have.
/// @throws DrawError naming material and property, if the value's kind does not fit
void WriteUniform(const UniformPlace& member, const PropertySources& sources,
                  std::span<std::byte> buffer);

/// Writes a buffer called k_DynamicKeywordBuffer: 1 for each keyword that the material has on, or
/// the globals have.
/// @param bytes  the bytes of the whole buffer
void WriteDynamicKeywords(const UniformBuffer& buffer, const PropertySources& sources,
                          std::span<std::byte> bytes);

/// The bytes of a program's uniform buffers. Each of three layers is written as often as it
/// changes: what is global, once for all draws until a global changes; a material's values, once
/// until the material changes; and what a draw has of its own, each time.
class ProgramUniforms
{
public:
    /// The layer of a material.
    class MaterialLayer
    {
        friend class ProgramUniforms;
        struct Run ///< bytes that lie side by side
        {
            std::uint32_t offset = 0;
            std::uint32_t size = 0;
        };
        std::optional<std::uint64_t> version; ///< of the material; none = it was never written
        std::vector<Run> runs;
        std::vector<std::byte> bytes; ///< of the runs, one behind the other
        /// The sizes of its textures, which are written each time: something else may set the
        /// value.
        std::vector<std::uint32_t> texelSizes;
        bool fits = true; ///< if false, a value is of another kind than the shader's
    };

    /// @param globals  of all frames whose draws use the program
    ProgramUniforms(const PropertyLayout& layout, FrameGlobals& globals);

    std::size_t size() const { return m_Globals.size(); } ///< of all buffers, in bytes
    /// Returns where a buffer begins, which is a multiple of k_UniformAlignment.
    std::uint32_t offset(std::size_t buffer) const { return m_Buffers[buffer].offset; }
    ShaderPropertyId name(std::size_t buffer) const { return m_Buffers[buffer].id; }
    /// Returns whether a buffer or a member has this name, or depends on a texture that has.
    bool Reads(ShaderPropertyId id) const;

    /// Writes the values of a draw into its size() bytes.
    /// @param layer  of the draw's material
    /// @param globalsVersion  grows with each change of the globals
    /// @return false if a value is of another kind than the shader's, which another value may hide;
    ///     then the bytes are to be written by WriteBuffer
    bool Write(const PropertySources& sources, MaterialLayer& layer, std::uint64_t globalsVersion,
               std::span<std::byte> bytes);

    /// Writes a buffer value by value.
    /// @param bytes  of all buffers
    /// @throws DrawError naming material and property, if the value's kind does not fit
    void WriteBuffer(std::size_t buffer, const PropertySources& sources,
                     std::span<std::byte> bytes) const;

private:
    struct Buffer
    {
        ShaderPropertyId id;
        std::uint32_t offset = 0;
        std::uint32_t memberEnd = 0; ///< its members lie between the last one's end and this
    };
    /// The global value of a member, and the texture of an X_TexelSize.
    struct GlobalSource
    {
        FrameGlobals::Place value = 0;
        FrameGlobals::Place texture = 0; ///< of others the value's
        // These are the versions of both that are written.
        std::uint64_t valueVersion = k_Unwritten;
        std::uint64_t textureVersion = k_Unwritten;
    };
    static constexpr std::uint64_t k_Unwritten = ~std::uint64_t{0};
    struct Reader
    {
        ShaderPropertyId id; ///< of a value or texture
        std::uint32_t member = 0;
    };
    void WriteGlobals(const FrameGlobals& globals);
    void WriteLayer(const Material& material, MaterialLayer& layer);
    void WriteOwn(const MaterialPropertyBlock* own, const PropertySources& sources,
                  std::span<std::byte> bytes) const;

    std::vector<Buffer> m_Buffers;
    std::vector<UniformPlace> m_Members; ///< in the bytes of all buffers
    std::vector<GlobalSource> m_Sources; ///< of the members
    std::vector<Reader> m_Readers;       ///< by id
    std::vector<std::byte> m_Globals;
    std::uint64_t m_GlobalsVersion = 0;
    std::vector<std::uint32_t>
        m_Unfit;                    ///< members whose global value is of another kind than theirs
    std::vector<std::byte> m_Layer; ///< for its memory, as the next one
    std::vector<ShaderPropertyId> m_Gamma;
};

} // namespace limn

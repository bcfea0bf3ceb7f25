#pragma once

#include <limn/base/Diagnostic.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The stages of a pass that use a resource; bit flags.
enum class ShaderStage : std::uint8_t
{
    None = 0,
    Vertex = 1,
    Fragment = 2,
    Both = 3,
    Geometry = 4,
    Compute = 8,
    /// No function, but the reading of a draw's or dispatch's arguments from a buffer.
    Indirect = 16
};
constexpr ShaderStage operator|(ShaderStage a, ShaderStage b)
{
    return static_cast<ShaderStage>(static_cast<int>(a) | static_cast<int>(b));
}
constexpr bool operator&(ShaderStage a, ShaderStage b)
{
    return (static_cast<int>(a) & static_cast<int>(b)) != 0;
}

enum class UniformType
{
    Float, ///< 32-bit; `components` 1...4
    Int,
    UInt,
    Matrix4x4 ///< column-major, columns 16 bytes apart
};

/// Returns whether `stages` has all of `wanted`.
constexpr bool HasAll(ShaderStage stages, ShaderStage wanted)
{
    return (stages | wanted) == stages;
}

/// A value in a uniform buffer.
struct UniformMember
{
    std::string name;
    UniformType type = UniformType::Float;
    int components = 1;       ///< the components of the vector; 4 for Matrix4x4
    std::uint32_t offset = 0; ///< bytes from the start of the buffer
    std::uint32_t size = 0;   ///< bytes, arrays included
    int arraySize = 0;        ///< 0 = not an array
    std::uint32_t arrayStride = 0;

    bool operator==(const UniformMember&) const = default;
};

struct UniformBuffer
{
    std::string name; ///< as in HLSL; "$Global" for loose uniforms
    ShaderStage stages = ShaderStage::None;
    std::uint32_t binding = 0;
    std::uint32_t size = 0; ///< bytes
    std::vector<UniformMember> members;

    bool operator==(const UniformBuffer&) const = default;
};

/// The uniform buffer whose members are a program's dynamic_branch keywords: int, 1 = on.
inline constexpr std::string_view k_DynamicKeywordBuffer = "limn_DynamicKeywords";

enum class TextureDimension
{
    Tex2D = 2,
    Tex3D = 3,
    Cube = 4,
    Tex2DArray = 5,
    CubeArray = 6
};

struct TextureBinding
{
    std::string name;
    ShaderStage stages = ShaderStage::None;
    std::uint32_t binding = 0;
    TextureDimension dimension = TextureDimension::Tex2D;
    bool multisampled = false;
    bool combinedSampler = false;          ///< sampler2D: one descriptor holds texture and sampler
    UniformType type = UniformType::Float; ///< the type of its components in the shader

    bool operator==(const TextureBinding&) const = default;
};

struct SamplerBinding
{
    std::string name; ///< e.g. "sampler_LinearClamp" (state in the name) or "sampler_MainTex"
    ShaderStage stages = ShaderStage::None;
    std::uint32_t binding = 0;
    bool comparison = false;

    bool operator==(const SamplerBinding&) const = default;
};

/// A structured buffer, a buffer of bytes, or the counter of a buffer to which elements are
/// appended.
struct StorageBufferBinding
{
    std::string name; ///< "limn_PerDraw" and "limn_Instances": see PerDrawData
    ShaderStage stages = ShaderStage::None;
    std::uint32_t binding = 0;
    std::uint32_t stride = 0; ///< bytes of one element, packed as Direct3D does; 0 = of bytes
    bool isWritten = false;   ///< if false, the buffer is read-only
    bool isCounter = false;   ///< a uint beside the elements of the buffer called `name`

    bool operator==(const StorageBufferBinding&) const = default;
};

/// A texture that a kernel writes to, or reads and writes: RWTexture2D and its kin.
struct StorageTextureBinding
{
    std::string name;
    ShaderStage stages = ShaderStage::None;
    std::uint32_t binding = 0;
    TextureDimension dimension = TextureDimension::Tex2D;
    UniformType type = UniformType::Float; ///< the type of its components in the shader
    bool isRead = false;                   ///< if false, it is only written

    bool operator==(const StorageTextureBinding&) const = default;
};

/// A vertex attribute that the vertex function reads.
struct VertexInput
{
    std::string semantic; ///< upper case with index: "POSITION", "NORMAL", "TANGENT", "COLOR",
                          ///< "TEXCOORD0" ... "TEXCOORD7"
    std::uint32_t location = 0;
    UniformType type = UniformType::Float;
    int components = 4;

    bool operator==(const VertexInput&) const = default;
};

/// The primitive that a geometry function takes.
enum class GeometryInput
{
    None, ///< there is no geometry function
    Point,
    Line,
    LineAdjacency,
    Triangle,
    TriangleAdjacency
};

/// The resources that the stages of a pass read, with every descriptor in set 0. Bindings are
/// unique over all stages; resources of several stages with the same name share one. The `$Global`
/// buffers of the stages are separate if they differ.
struct PropertyLayout
{
    std::vector<UniformBuffer> buffers;
    std::vector<TextureBinding> textures;
    std::vector<SamplerBinding> samplers;
    std::vector<StorageBufferBinding> storageBuffers;
    std::vector<StorageTextureBinding> storageTextures; ///< only kernels have them
    std::vector<VertexInput> vertexInputs;
    int colorOutputs = 0; ///< number of SV_Target values the fragment function writes
    /// The type of each; Float for those that it does not write.
    std::vector<UniformType> outputTypes;
    GeometryInput geometryInput = GeometryInput::None;
    ShaderStage pushStages = ShaderStage::None; ///< the stages that read the DrawConstants
    /// The fragment function reads something that differs from pixel to pixel, its own position
    /// included.
    bool fragmentHasInputs = true;

    bool operator==(const PropertyLayout&) const = default;
};

/// A pass or kernel that is compiled for one set of keywords: the SPIR-V 1.3 of its stages (entry
/// point "main") and its layout.
struct ShaderProgram
{
    std::vector<std::uint32_t> vertexSpirv;
    std::vector<std::uint32_t> geometrySpirv; ///< empty = the pass has no geometry function
    std::vector<std::uint32_t> fragmentSpirv;
    std::vector<std::uint32_t> computeSpirv; ///< the code of a kernel, which has no other stage
    std::array<std::uint32_t, 3> threadGroupSize{}; ///< the [numthreads(x, y, z)] of a kernel
    PropertyLayout layout;
    /// The warnings of the compiler, also about pragmas; and notes without a line, "uses X, which
    /// limn does not have: Y", about functions that the pass uses and that the ShaderLibrary only
    /// replaces by a stand-in.
    std::vector<Diagnostic> diagnostics;

    bool operator==(const ShaderProgram&) const = default;
};

/// The keyword of variants for draws whose instances share one element of `limn_PerDraw`, such as
/// draws that take their counts from a buffer. Programs need not declare it. The name is Unity's.
inline constexpr std::string_view k_ProceduralInstancing = "PROCEDURAL_INSTANCING_ON";

/// One element of the structured buffer `limn_PerDraw` that the ShaderLibrary's per-draw macros
/// (unity_ObjectToWorld, unity_WorldToObject, unity_RenderingLayer ...) read; std430, 160 bytes.
/// The structured buffer `limn_Instances` (of uint) holds the index of the element: vertex
/// functions look it up by the instance's index on the device, the others by
/// DrawConstants::firstInstance.
struct PerDrawData
{
    float objectToWorld[16];         ///< column-major
    float worldToObject[16];         ///< column-major
    float worldTransformParams[4];   ///< w = -1 where the determinant is negative, else 1;
                                     ///< xyz = the object's place relative to limn_Origin
    std::uint32_t renderingLayer[4]; ///< x = the renderer's rendering layer bits
};
static_assert(sizeof(PerDrawData) == 160);

/// The push constants of a draw, at offset 0.
struct DrawConstants
{
    std::uint32_t firstInstance = 0; ///< element of limn_Instances
    /// The index on the device of the instance whose SV_InstanceID is 0; as in Direct3D,
    /// SV_InstanceID counts from 0 in every draw. Only vertex functions that take SV_InstanceID
    /// read this.
    std::uint32_t instanceBase = 0;
};

} // namespace limn

#pragma once

#include <limn/base/Diagnostic.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Which stages of a pass use a resource; bit flags.
enum class ShaderStage : std::uint8_t
{
    None = 0,
    Vertex = 1,
    Fragment = 2,
    Both = 3,
    Geometry = 4,
    Compute = 8,
    Indirect = 16 ///< no function: what reads a draw's or dispatch's arguments from a buffer
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

/// Whether `stages` has all of `wanted`.
constexpr bool HasAll(ShaderStage stages, ShaderStage wanted)
{
    return (stages | wanted) == stages;
}

/// A value in a uniform buffer.
struct UniformMember
{
    std::string name;
    UniformType type = UniformType::Float;
    int components = 1;       ///< of the vector; 4 for Matrix4x4
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
    UniformType type = UniformType::Float; ///< of its components in the shader

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

/// A structured buffer, one of bytes, or the counter of one that is appended to.
struct StorageBufferBinding
{
    std::string name; ///< "limn_PerDraw" and "limn_Instances": see PerDrawData
    ShaderStage stages = ShaderStage::None;
    std::uint32_t binding = 0;
    std::uint32_t stride = 0; ///< bytes of one element, packed as Direct3D does; 0 = of bytes
    bool isWritten = false;   ///< else it is read only
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
    UniformType type = UniformType::Float; ///< of its components in the shader
    bool isRead = false;                   ///< else it is written only

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

/// What a geometry function takes at a time.
enum class GeometryInput
{
    None, ///< there is no geometry function
    Point,
    Line,
    LineAdjacency,
    Triangle,
    TriangleAdjacency
};

/// What the stages of a pass read, with every descriptor in set 0. Bindings are unique over all
/// stages; equal named resources of several stages share one. A `$Global` of each stage is a
/// buffer of its own where they differ.
struct PropertyLayout
{
    std::vector<UniformBuffer> buffers;
    std::vector<TextureBinding> textures;
    std::vector<SamplerBinding> samplers;
    std::vector<StorageBufferBinding> storageBuffers;
    std::vector<StorageTextureBinding> storageTextures; ///< of kernels only
    std::vector<VertexInput> vertexInputs;
    int colorOutputs = 0; ///< number of SV_Target values the fragment function writes
    std::vector<UniformType> outputTypes; ///< of each; Float for those that it leaves out
    GeometryInput geometryInput = GeometryInput::None;
    ShaderStage pushStages = ShaderStage::None; ///< that read the DrawConstants
    /// Whether the fragment function looks at anything that differs from one place to another, its
    /// own place included.
    bool fragmentHasInputs = true;

    bool operator==(const PropertyLayout&) const = default;
};

/// A pass or kernel compiled for one keyword set: SPIR-V 1.3 of its stages (entry point "main") and
/// its layout.
struct ShaderProgram
{
    std::vector<std::uint32_t> vertexSpirv;
    std::vector<std::uint32_t> geometrySpirv; ///< empty = the pass has no geometry function
    std::vector<std::uint32_t> fragmentSpirv;
    std::vector<std::uint32_t> computeSpirv;        ///< of a kernel, which has no other stage
    std::array<std::uint32_t, 3> threadGroupSize{}; ///< of a kernel: [numthreads(x, y, z)]
    PropertyLayout layout;
    /// Warnings of the compiler, pragmas included; and notes without a line, "uses X, which limn
    /// does not have: Y", of what the pass uses that the ShaderLibrary only stands in for.
    std::vector<Diagnostic> diagnostics;

    bool operator==(const ShaderProgram&) const = default;
};

/// The keyword of variants for draws whose instances share one element of `limn_PerDraw`, as those
/// that take their counts from a buffer; no program has to declare it. Unity's name.
inline constexpr std::string_view k_ProceduralInstancing = "PROCEDURAL_INSTANCING_ON";

/// One element of the structured buffer `limn_PerDraw` that the ShaderLibrary's per-draw macros
/// (unity_ObjectToWorld, unity_WorldToObject, unity_RenderingLayer ...) read; std430, 160 bytes.
/// Which one is told by the structured buffer `limn_Instances` (of uint): vertex functions look it
/// up by the instance's index on the device, the others by DrawConstants::firstInstance.
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
    /// Index on the device of the instance whose SV_InstanceID is 0: as in Direct3D it counts from
    /// 0 in every draw. Only vertex functions that take SV_InstanceID read this.
    std::uint32_t instanceBase = 0;
};

} // namespace limn

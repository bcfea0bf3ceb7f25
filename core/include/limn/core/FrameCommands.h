#pragma once

#include <cstdint>
#include <limn/core/Color.h>
#include <limn/core/FixedList.h>
#include <limn/core/GraphicsBuffer.h>
#include <limn/core/Mesh.h>
#include <limn/core/PipelineState.h>
#include <limn/core/RTHandle.h>
#include <limn/core/ShaderId.h>
#include <limn/shaderlab/ShaderProgram.h>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace limn
{

/// The data of a scene's objects for shaders, by index. It stays from frame to frame, so that a
/// device copies only what has changed.
class InstanceData
{
public:
    virtual ~InstanceData() = default;

    virtual std::uint64_t id() const = 0;      ///< unique in the process
    virtual std::uint64_t version() const = 0; ///< grows with each change
    virtual std::uint32_t count() const = 0;   ///< the number of objects
    /// Returns the object's data as it is now, not as it was when a frame was recorded.
    virtual PerDrawData Get(std::uint32_t object) const = 0;
    /// Returns the objects that have changed since `version`, each at least once, or nothing if
    /// that is too long ago to tell. The result is valid until the next change.
    virtual std::optional<std::span<const std::uint32_t>>
    ChangedSince(std::uint64_t version) const = 0;
};

class ComputeShader;
class Shader;

/// Selects the parts of a target to clear; bit flags with Unity's values.
/// Unity: UnityEngine.Rendering.ClearFlag.
enum class ClearFlag
{
    None = 0,
    Color = 1,
    Depth = 2,
    ColorDepth = 3, ///< of RTClearFlags
    Stencil = 4,
    ColorStencil = 5,
    DepthStencil = 6,
    All = 7
};
/// The name under which CommandBuffer.ClearRenderTarget takes a ClearFlag.
/// Unity: UnityEngine.Rendering.RTClearFlags (2022.3).
using RTClearFlags = ClearFlag;
template <>
inline constexpr bool k_IsFlags<ClearFlag> = true;
constexpr ClearFlag Only(ClearFlag flags, ClearFlag wanted)
{
    return static_cast<ClearFlag>(static_cast<int>(flags) & static_cast<int>(wanted));
}
constexpr ClearFlag Without(ClearFlag flags, ClearFlag unwanted)
{
    return static_cast<ClearFlag>(static_cast<int>(flags) & ~static_cast<int>(unwanted));
}

/// A rectangle of target texels, measured from the top left.
struct ViewportRect
{
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const ViewportRect&) const = default;
};

/// The alignment of uniform buffers, in bytes: the largest that any device requires.
inline constexpr std::uint32_t k_UniformAlignment = 256;

/// A range of bytes in FrameCommands::uniformData that is bound to one uniform buffer.
struct UniformSlice
{
    std::uint32_t binding = 0;
    std::uint32_t offset = 0; ///< a multiple of k_UniformAlignment
    std::uint32_t size = 0;

    bool operator==(const UniformSlice&) const = default;
};

struct TextureSlot
{
    std::uint32_t binding = 0;
    std::shared_ptr<const Texture> texture; ///< never null
    std::optional<SamplerState> sampler;    ///< set if texture and sampler are one descriptor

    bool operator==(const TextureSlot&) const = default;
};

struct SamplerSlot
{
    std::uint32_t binding = 0;
    SamplerState state;

    bool operator==(const SamplerSlot&) const = default;
};

/// A buffer that something other than the frame made.
struct BufferSlot
{
    std::uint32_t binding = 0;
    std::shared_ptr<const GraphicsBuffer> buffer; ///< never null
    std::uint32_t offset = 0;                     ///< bytes
    std::uint32_t size = 0;                       ///< bytes
    ShaderStage stages = ShaderStage::None;       ///< the stages that use it
    bool isUniform = false;                       ///< a cbuffer
    bool isWritten = false;

    bool operator==(const BufferSlot&) const = default;
};

/// The BufferSlot::binding of the buffer that holds the counts of a draw or dispatch; shaders do
/// not see it.
inline constexpr std::uint32_t k_ArgumentsBinding = ~std::uint32_t{0};

/// A texture that a kernel writes to.
struct StorageTextureSlot
{
    std::uint32_t binding = 0;
    std::shared_ptr<const RenderTexture> texture; ///< never null

    bool operator==(const StorageTextureSlot&) const = default;
};

/// Everything bound by one draw or dispatch; draws of equal material and globals share one.
struct DrawBindings
{
    std::vector<UniformSlice> uniforms;
    std::vector<TextureSlot> textures;
    std::vector<SamplerSlot> samplers;
    std::vector<BufferSlot> buffers;
    std::vector<StorageTextureSlot> storageTextures; ///< set by dispatches
    /// The binding of limn_PerDraw, if the shader reads it.
    std::optional<std::uint32_t> perDrawBinding;

    /// Returns the buffer with the draw's vkCmdDrawIndirect or vkCmdDrawIndexedIndirect arguments,
    /// or with the dispatch's, or null if the command has its own counts.
    const BufferSlot* arguments() const
    {
        const bool has = !buffers.empty() && buffers.back().binding == k_ArgumentsBinding;
        return has ? &buffers.back() : nullptr;
    }
    bool operator==(const DrawBindings&) const = default;
};

/// A part of a target of any size: 0 is its left or top border, 1 its right or bottom one. It may
/// reach beyond them.
struct TargetRegion
{
    double left = 0.0;
    double top = 0.0;
    double right = 1.0;
    double bottom = 1.0;

    bool operator==(const TargetRegion&) const = default;
};

/// The promises of a pass with the tag LimnFullScreen for its draws without a mesh: they cover
/// their target, and leave no texel of it as it was except by blending.
struct FullScreenPromise
{
    /// If every texel of one of these textures is 0 in each component that it has, the fragment
    /// function returns `output`.
    FixedList<std::shared_ptr<const Texture>, 4> zeroTextures;
    /// The farthest distance from its own place at which the fragment function reads, in texels of
    /// the zeroTextures. It is enough that a texture is 0 within that distance. Negative =
    /// unlimited.
    float reach = -1.0f;
    /// A property for which the fragment function returns `output` in any case if it is 0.
    ShaderPropertyId zeroProperty;
    Color output; ///< linear
    /// The texture whose texel at its own place the fragment function returns, with alpha 1; null =
    /// it returns another value.
    std::shared_ptr<const Texture> copied;

    bool operator==(const FullScreenPromise&) const = default;
};

/// The state that many draws of a frame have in common.
struct DrawSetup
{
    std::shared_ptr<const ShaderProgram> program;
    std::shared_ptr<const DrawBindings> bindings;
    PipelineState state;
    std::shared_ptr<const FullScreenPromise> fullScreen; ///< null = it makes no promise
    // These are what `program` was compiled from, for reports and errors.
    std::shared_ptr<const Shader> shader;
    int shaderPass = 0;

    bool operator==(const DrawSetup&) const = default;
};

/// A draw, whose numbers are indices into the frame's tables.
struct DrawCommand
{
    static constexpr std::uint32_t k_NoMesh = ~std::uint32_t{0};

    std::uint32_t setup = 0;       ///< of FrameTables::setups
    std::uint32_t mesh = k_NoMesh; ///< of FrameTables::meshes; none = SV_VertexID only
    int subMesh = 0;
    std::uint32_t vertexCount = 0;   ///< if it has neither a mesh nor DrawBindings::arguments
    std::uint32_t firstInstance = 0; ///< index into FrameTables::instances
    std::uint32_t instanceCount = 1;
    bool drawsObjects = false; ///< its instances are of FrameTables::objects, else of perDraw
    std::optional<TargetRegion> bounds; ///< it draws nothing outside of them; none = unknown
    /// The only texels that are drawn. If none is recorded, CompileFrame may set one.
    std::optional<ViewportRect> scissor;

    bool operator==(const DrawCommand&) const = default;
};

/// The state that dispatches of a frame may have in common.
struct DispatchSetup
{
    std::shared_ptr<const ShaderProgram> program;
    std::shared_ptr<const DrawBindings> bindings; ///< never null
    // These are what `program` was compiled from, for reports and errors.
    std::shared_ptr<const ComputeShader> shader;
    int kernel = 0;

    bool operator==(const DispatchSetup&) const = default;
};

/// Runs a kernel, and does not depend on the bound target.
struct DispatchCommand
{
    std::uint32_t setup = 0;                      ///< of FrameTables::dispatchSetups
    std::array<std::uint32_t, 3> groups{1, 1, 1}; ///< unless it has DrawBindings::arguments
    bool isKept = false; ///< it is run even if nothing reads what it writes
    /// If true, the mip levels behind the first are made for the textures that it writes.
    bool generatesMips = false;

    bool operator==(const DispatchCommand&) const = default;
};

/// The largest number of colour targets that can be drawn into at once.
inline constexpr std::size_t k_MostColors = std::tuple_size_v<decltype(PipelineState::targets)>;

/// Sets the target that later draws draw into; the viewport is the whole of it.
struct SetRenderTargetCommand
{
    FixedList<std::shared_ptr<const RenderTexture>, k_MostColors>
        colors;                                 ///< may be empty with a depth
    std::shared_ptr<const RenderTexture> depth; ///< may be null
    bool isKept = false;                        ///< those draws are run even if nothing reads them
    /// If true, mip levels are made for the colours that have them and do not make them themselves.
    bool generatesMips = false;

    bool operator==(const SetRenderTargetCommand&) const = default;
};

/// Clears the bound target, or the viewport's part of it if a viewport is set.
struct ClearCommand
{
    ClearFlag flags = ClearFlag::None;
    Color color;        ///< linear
    float depth = 1.0f; ///< 1 = far whatever the device's depth direction is, as Unity writes it
    int stencil = 0;

    bool operator==(const ClearCommand&) const = default;
};

struct SetViewportCommand
{
    ViewportRect rect;

    bool operator==(const SetViewportCommand&) const = default;
};

/// Begins a named group of commands, for captures, timings and dumps; EndSampleCommand ends it.
struct BeginSampleCommand
{
    SampleName name;

    bool operator==(const BeginSampleCommand&) const = default;
};
struct EndSampleCommand
{
    bool operator==(const EndSampleCommand&) const = default;
};

using FrameCommand =
    std::variant<SetRenderTargetCommand, ClearCommand, SetViewportCommand, DrawCommand,
                 BeginSampleCommand, EndSampleCommand, DispatchCommand>;

/// The tables to which the draws of a frame refer by number. Each instance is an element of one of
/// two lists.
struct FrameTables
{
    std::vector<DrawSetup> setups;
    std::vector<DispatchSetup> dispatchSetups;
    std::vector<std::shared_ptr<const Mesh>> meshes; ///< no element is null
    std::vector<std::uint32_t> instances; ///< elements of perDraw or objects; empty = 0, 1, 2 ...
    std::vector<PerDrawData> perDraw;     ///< used by draws of this frame only
    std::shared_ptr<const InstanceData> objects; ///< of the scene; null = no draw has any
    /// The depth direction that its shaders expect, see ShaderCompilerOptions.
    bool usesReversedZBuffer = true;

    const DrawSetup& Setup(const DrawCommand& draw) const { return setups[draw.setup]; }
    const DispatchSetup& Setup(const DispatchCommand& dispatch) const
    {
        return dispatchSetups[dispatch.setup];
    }
    /// Returns the draw's mesh, or null if it has none.
    const std::shared_ptr<const Mesh>& MeshOf(const DrawCommand& draw) const;
    /// Returns the element of an instance.
    std::uint32_t Element(std::uint32_t instance) const
    {
        return instances.empty() ? instance : instances[instance];
    }
    /// Returns the data that shaders get for an instance, as it is now.
    /// @pre the draw has this many instances
    PerDrawData PerDraw(const DrawCommand& draw, std::uint32_t instance = 0) const;
};

/// Everything that a frame recorded, in order, with nothing left to look up: plain data.
struct FrameCommands : FrameTables
{
    std::vector<FrameCommand> commands;
    std::vector<std::byte> uniformData;
};

} // namespace limn

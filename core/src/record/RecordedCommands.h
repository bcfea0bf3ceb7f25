#pragma once

#include <array>
#include <limn/core/ComputeShader.h>
#include <limn/core/FrameCommands.h>
#include <limn/core/LayerMask.h>
#include <limn/core/Material.h>
#include <limn/core/RenderTargetIdentifier.h>
#include <limn/core/ShaderKeyword.h>
#include <variant>
#include <vector>

namespace limn
{

// These are what a CommandBuffer records about kernels, which are looked up when the buffer is
// executed.

struct RecordedDispatch
{
    std::shared_ptr<const ComputeShader> shader;
    int kernel = 0;
    std::array<std::uint32_t, 3> groups{};
    BufferRange arguments; ///< if it has a buffer, that has the groups
};

struct SetComputeParamCommand
{
    std::shared_ptr<ComputeShader> shader;
    int kernel = ComputeShader::k_AllKernels;
    ShaderPropertyId id;
    ShaderPropertyValue value;
};

/// Sets all values that a material has.
struct SetComputeParamsCommand
{
    std::shared_ptr<ComputeShader> shader;
    int kernel = 0;
    std::shared_ptr<const Material> material; ///< never null
};

struct SetComputeTextureCommand
{
    std::shared_ptr<ComputeShader> shader;
    int kernel = 0;
    ShaderPropertyId id;
    RenderTargetIdentifier texture;
};

struct SetComputeKeywordCommand
{
    std::shared_ptr<ComputeShader> shader;
    std::string keyword;
    bool isOn = false;
};

struct RendererListParams;

/// A draw as it is recorded: the material is read when the buffer is executed.
struct RecordedDraw
{
    std::shared_ptr<const Mesh> mesh; ///< null = procedural
    int subMesh = 0;
    std::uint32_t vertexCount = 0; ///< procedural
    glm::dmat4 matrix{1.0}; ///< in double, since a float is coarse far away from the world's origin
    std::shared_ptr<const Material> material;
    int shaderPass = 0;
    std::uint32_t properties = k_NoProperties; ///< for CommandBuffer::PropertiesOf
    RenderingLayerMask renderingLayers{1};
    std::uint32_t instanceCount = 1; ///< procedural
    MeshTopology topology = MeshTopology::Triangles;
    bool isBlit = false; ///< its mesh covers the target, so the pass's promises about that hold
    /// If true, its instances share the data that shaders get for the draw: see
    /// k_ProceduralInstancing.
    bool isProcedural = false;
    BufferRange arguments; ///< if it has a buffer, that has the draw's counts

    static constexpr std::uint32_t k_NoProperties = ~std::uint32_t{0};
};

struct SetGlobalCommand
{
    ShaderPropertyId id;
    ShaderPropertyValue value;
};

struct SetKeywordCommand
{
    GlobalKeyword keyword;
    bool isOn = false;

    bool operator==(const SetKeywordCommand&) const = default;
};

/// Switches a keyword of one material.
struct SetMaterialKeywordCommand
{
    std::shared_ptr<Material> material; ///< never null
    LocalKeyword keyword;
    bool isOn = false;
};

/// Sets matrices that become globals in the end; they are kept unrounded until the frame's origin
/// is known.
struct SetViewProjectionCommand
{
    glm::dmat4 view{1.0};
    glm::mat4 gpuProjection{1.0f};
    bool inverses = false;
};

/// Sets one of the matrices; the other one stays.
struct SetViewCommand
{
    glm::dmat4 view{1.0};
};

struct SetProjectionCommand
{
    glm::dmat4 projection{1.0}; ///< as in OpenGL: z from -w near to w far
};

struct SetBufferDataCommand
{
    std::shared_ptr<GraphicsBuffer> buffer; ///< never null
    std::vector<std::byte> bytes;
    std::size_t offset = 0; ///< bytes
};

struct SetBufferCounterCommand
{
    std::shared_ptr<GraphicsBuffer> buffer; ///< never null
    std::uint32_t value = 0;
};

/// Copies bytes from one buffer to another on the device.
struct CopyBufferCommand
{
    std::shared_ptr<const GraphicsBuffer> source; ///< never null
    std::shared_ptr<const GraphicsBuffer> dest;   ///< never null
    std::uint32_t from = 0;                       ///< words of `source`, which include its counter
    std::uint32_t to = 0;                         ///< words of `dest`
    std::uint32_t count = 0;                      ///< words
};

// These name their textures by identifiers, which are looked up when the buffer is executed.

struct GetTemporaryRTCommand
{
    ShaderPropertyId id;
    RenderTextureDescriptor descriptor; ///< a negative size is a part of the camera's size
    FilterMode filter = FilterMode::Point;
};

struct ReleaseTemporaryRTCommand
{
    ShaderPropertyId id;
};

struct SetIdentifiedTargetCommand
{
    std::vector<RenderTargetIdentifier> colors;
    /// The depth; none = the one that belongs to the colour, if there is exactly one.
    RenderTargetIdentifier depth;
};

struct SetCameraColorCommand
{
    RTHandle color;
};

struct SetGlobalIdentifierCommand
{
    ShaderPropertyId id;
    RenderTargetIdentifier value;
};

struct IdentifiedBlitCommand
{
    RenderTargetIdentifier source;
    RenderTargetIdentifier dest;
    std::shared_ptr<const Material> material; ///< null = a plain copy
    int pass = -1;
};

/// Draws a copy onto the bound target.
struct CopyDrawCommand
{
    RenderTargetIdentifier source;
    glm::vec4 scaleBias{1.0f, 1.0f, 0.0f, 0.0f};
    bool isBilinear = false; ///< else the nearest texel
    float mipLevel = 0.0f;
    /// The part of the target that a quad covers; none = a triangle over the whole.
    std::optional<glm::vec4> targetScaleBias = std::nullopt;
    /// A texture that is written as depth; null = no depth is written.
    std::shared_ptr<const RenderTexture> depth = nullptr;
};

struct CopyTextureCommand
{
    RenderTargetIdentifier source;
    RenderTargetIdentifier dest;
};

struct GenerateMipsCommand
{
    RenderTargetIdentifier texture;
};

// These hold for all draws that follow, in any buffer.

struct SetScissorCommand
{
    std::optional<ViewportRect> rect; ///< none = the whole target
};

struct SetInvertCullingCommand
{
    bool isInverted = false;
};

struct SetGlobalDepthBiasCommand
{
    float bias = 0.0f;
    float slopeBias = 0.0f;
};

struct DrawRendererListCommand
{
    std::shared_ptr<const RendererListParams> list; ///< never null
};

using CommandVariant =
    std::variant<SetRenderTargetCommand, ClearCommand, SetViewportCommand, BeginSampleCommand,
                 EndSampleCommand, RecordedDraw, SetGlobalCommand, SetKeywordCommand,
                 SetViewProjectionCommand, GetTemporaryRTCommand, ReleaseTemporaryRTCommand,
                 SetIdentifiedTargetCommand, SetCameraColorCommand, SetGlobalIdentifierCommand,
                 IdentifiedBlitCommand, CopyDrawCommand, CopyTextureCommand, SetScissorCommand,
                 SetInvertCullingCommand, SetGlobalDepthBiasCommand, DrawRendererListCommand,
                 GenerateMipsCommand, RecordedDispatch, SetComputeParamCommand,
                 SetComputeTextureCommand, SetComputeKeywordCommand, SetMaterialKeywordCommand,
                 SetViewCommand, SetProjectionCommand, SetBufferDataCommand,
                 SetBufferCounterCommand, CopyBufferCommand, SetComputeParamsCommand>;

/// One command of a CommandBuffer. It is a struct, so that CommandBuffer.h needs no more than its
/// name: a variant of so many types costs each file that sees it most of a second.
struct RecordedCommand : CommandVariant
{
    using CommandVariant::CommandVariant;
};

} // namespace limn

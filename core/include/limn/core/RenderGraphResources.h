#pragma once

#include <limn/core/Color.h>
#include <limn/core/GraphicsBuffer.h>
#include <limn/core/LiteralZero.h>
#include <limn/core/RTHandle.h>
#include <limn/core/RendererList.h>
#include <optional>

namespace limn
{

class RenderGraph;

/// Describes what a pass does with a texture; bit flags with Unity's values.
/// Unity: UnityEngine.Rendering.RenderGraphModule.AccessFlags (core 17).
enum class AccessFlags
{
    None = 0,
    Read = 1,
    Write = 2,
    ReadWrite = 3,
    Discard = 4, ///< its earlier contents do not matter
    WriteAll = 6 ///< Write and Discard
};
template <>
inline constexpr bool k_IsFlags<AccessFlags> = true;

/// Unity: UnityEngine.Rendering.DepthBits (core 17).
enum class DepthBits
{
    None = 0,
    Depth8 = 8, ///< throws ContractError: no depth has so few bits
    Depth16 = 16,
    Depth24 = 24,
    Depth32 = 32
};
/// Unity: UnityEngine.Rendering.MSAASamples (core 17).
enum class MSAASamples
{
    None = 1,
    MSAA2x = 2,
    MSAA4x = 4,
    MSAA8x = 8
};

/// Unity: UnityEngine.Rendering.RenderGraphModule.TextureSizeMode (core 17).
enum class TextureSizeMode
{
    Explicit,
    Scale,
    Functor
};

/// A texture that RenderGraph::CreateTexture makes.
/// Unity: UnityEngine.Rendering.RenderGraphModule.TextureDesc (core 17).
struct TextureDesc
{
    int width = 0;  ///< texels
    int height = 0; ///< texels
    GraphicsFormat format = GraphicsFormat::R8G8B8A8_UNorm;
    ZeroOr<DepthBits> depthBufferBits; ///< not None = a depth texture without colour
    MSAASamples msaaSamples = MSAASamples::None;
    FilterMode filterMode = FilterMode::Bilinear;
    TextureWrapMode wrapMode = TextureWrapMode::Clamp;
    /// If true, the texture is cleared before the first pass that writes it, unless that writes
    /// with AccessFlags::WriteAll. Otherwise its contents are undefined then.
    bool clearBuffer = true;
    Color clearColor = Color::black; ///< linear; depth clears to far
    bool enableRandomWrite = false;  ///< kernels may write to it, see RenderTextureDescriptor
    bool useMipMap = false;          ///< as RenderTextureDescriptor's, with the next two
    bool autoGenerateMips = true;
    int anisoLevel = 1;                                   ///< see SamplerState
    float mipMapBias = 0.0f;                              ///< see SamplerState
    TextureSizeMode sizeMode = TextureSizeMode::Explicit; ///< other modes ignore width and height
    glm::vec2 scale{1.0f};     ///< for sizeMode Scale: times the camera's size, rounded
    RTHandles::ScaleFunc func; ///< for sizeMode Functor
    TextureDimension dimension = TextureDimension::Tex2D; ///< others throw ContractError
    int slices = 1;                                       ///< others throw ContractError
    bool bindTextureMS = false;                           ///< true throws ContractError
    // These have no effect: limn derives what is stored and kept, and nothing scales.
    bool discardBuffer = false;
    bool useDynamicScale = false;
    RenderTextureMemoryless memoryless = RenderTextureMemoryless::None;
    bool fallBackToBlackTexture = false;
    ResourceName name;

    TextureDesc() = default;
    TextureDesc(int w, int h) : width(w), height(h) {}
    explicit TextureDesc(const glm::vec2& scale_) : sizeMode(TextureSizeMode::Scale), scale(scale_)
    {
    }
    explicit TextureDesc(RTHandles::ScaleFunc func_)
        : sizeMode(TextureSizeMode::Functor), func(std::move(func_))
    {
    }
    explicit TextureDesc(const RenderTextureDescriptor& descriptor);

    /// Returns the descriptor with the size for the camera that is rendered.
    /// @throws ContractError for a scale that is not positive, and an empty function
    RenderTextureDescriptor descriptor() const;
};

/// Options of an imported texture. The frame compiler derives what is discarded.
/// Unity: UnityEngine.Rendering.RenderGraphModule.ImportResourceParams (core 17).
struct ImportResourceParams
{
    bool clearOnFirstUse = false;
    Color clearColor = Color::clear; ///< linear
};

/// The properties of a texture as a target.
/// Unity: UnityEngine.Rendering.RenderGraphModule.RenderTargetInfo (core 17).
struct RenderTargetInfo
{
    int width = 0;  ///< texels
    int height = 0; ///< texels
    int volumeDepth = 1;
    int msaaSamples = 1;                          ///< per texel
    GraphicsFormat format = GraphicsFormat::None; ///< of the depth, for a depth texture
    bool bindMS = false;
};

/// A texture of a camera's render graph, or none. It is valid until the camera is done.
/// Unity: UnityEngine.Rendering.RenderGraphModule.TextureHandle (core 17).
class TextureHandle
{
public:
    TextureHandle() = default;

    bool IsValid() const { return static_cast<bool>(m_Texture); }
    /// Converts to a texture in render functions, as in Unity.
    operator const RTHandle&() const { return m_Texture; }
    const std::shared_ptr<const RenderTexture>& rt() const { return m_Texture.rt(); }
    /// @throws ContractError if there is no texture
    TextureDesc GetDescriptor(const RenderGraph& renderGraph) const;

    static const TextureHandle nullHandle; ///< none

    bool operator==(const TextureHandle&) const = default;

private:
    friend class RenderGraph;
    TextureHandle(RTHandle texture, std::uint64_t frame)
        : m_Texture(std::move(texture)), m_Frame(frame)
    {
    }

    RTHandle m_Texture;
    std::uint64_t m_Frame = 0;
};

inline const TextureHandle TextureHandle::nullHandle;

/// A renderer list of a camera's render graph, or none. It is valid until the camera is done.
/// Unity: UnityEngine.Rendering.RenderGraphModule.RendererListHandle (core 17).
class RendererListHandle
{
public:
    RendererListHandle() = default;
    bool IsValid() const { return m_Frame != 0; }

    static const RendererListHandle nullHandle; ///< none

    bool operator==(const RendererListHandle&) const = default;

private:
    friend class RenderGraph;
    RendererListHandle(std::size_t index, std::uint64_t frame) : m_Index(index), m_Frame(frame) {}

    std::size_t m_Index = 0;
    std::uint64_t m_Frame = 0; ///< 0 = none
};

inline const RendererListHandle RendererListHandle::nullHandle;

/// A buffer that RenderGraph::CreateBuffer makes.
/// Unity: UnityEngine.Rendering.RenderGraphModule.BufferDesc (core 17).
struct BufferDesc
{
    int count = 0;
    int stride = 0; ///< bytes
    GraphicsBuffer::Target target = GraphicsBuffer::Target::Structured;
    ResourceName name;

    BufferDesc() = default;
    BufferDesc(int elements, int bytes,
               GraphicsBuffer::Target usedAs = GraphicsBuffer::Target::Structured)
        : count(elements), stride(bytes), target(usedAs)
    {
    }

    bool operator==(const BufferDesc&) const = default;
};

/// A buffer of a camera's render graph, or none. It is valid until the camera is done.
/// Unity: UnityEngine.Rendering.RenderGraphModule.BufferHandle (core 17).
class BufferHandle
{
public:
    BufferHandle() = default;
    bool IsValid() const { return m_Buffer != nullptr; }
    /// Converts to a buffer in render functions, as in Unity.
    operator std::shared_ptr<const GraphicsBuffer>() const { return m_Buffer; }
    const std::shared_ptr<const GraphicsBuffer>& buffer() const { return m_Buffer; }

    static const BufferHandle nullHandle; ///< none

    bool operator==(const BufferHandle&) const = default;

private:
    friend class RenderGraph;
    BufferHandle(std::shared_ptr<const GraphicsBuffer> buffer, std::uint64_t frame)
        : m_Buffer(std::move(buffer)), m_Frame(frame)
    {
    }

    std::shared_ptr<const GraphicsBuffer> m_Buffer;
    std::uint64_t m_Frame = 0;
};

inline const BufferHandle BufferHandle::nullHandle;

} // namespace limn

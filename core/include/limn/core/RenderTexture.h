#pragma once

#include <limn/core/Texture.h>
#include <memory>

namespace limn
{

/// Unity: UnityEngine.Rendering.ShadowSamplingMode (2022.3).
enum class ShadowSamplingMode
{
    CompareDepths = 0, ///< a sampler of the texture's own compares
    RawDepth = 1,
    None = 2
};
/// Unity: UnityEngine.VRTextureUsage (2022.3).
enum class VRTextureUsage
{
    None = 0,
    OneEye = 1,        ///< throws ContractError, as the next two do: there is no XR
    TwoEyes = 2,       ///< throws ContractError
    DeviceSpecific = 3 ///< throws ContractError
};
/// Unity: UnityEngine.RenderTextureMemoryless (2022.3); bit flags.
enum class RenderTextureMemoryless
{
    None = 0,
    Color = 1,
    Depth = 2,
    MSAA = 4
};

/// Unity: UnityEngine.RenderTextureDescriptor (2022.3).
struct RenderTextureDescriptor
{
    int width = 0;  ///< texels
    int height = 0; ///< texels
    /// The colour's format. None with depthBufferBits, or a depth format, makes a depth texture in
    /// the format of MadeFormat (Unity does not allow a depth format here).
    GraphicsFormat graphicsFormat = GraphicsFormat::R8G8B8A8_UNorm;
    /// The bits of depth: 0, 16, 24 or 32. A number other than 0 with a colour format makes a
    /// colour with a depth of its own (RenderTexture::depthBuffer); RTHandles then make a depth
    /// texture, whatever the colour format, as in Unity. Depth is D32_SFloat for 16,
    /// D32_SFloat_S8_UInt for 24 and 32, since in Unity only 16 has no stencil.
    int depthBufferBits = 0;
    /// The samples per texel: 1, 2, 4 or 8. Several samples are resolved for readers of the
    /// texture: colour to the average, depth and stencil to the first sample.
    int msaaSamples = 1;
    /// If true, a colour has mip levels, which are undefined until they are generated.
    bool useMipMap = false;
    /// If true, each draw into the texture makes the mip levels anew when the next target is bound;
    /// otherwise CommandBuffer::GenerateMips does.
    bool autoGenerateMips = true;
    int mipCount = 0; ///< for useMipMap: 0 = all down to 1x1
    /// If true, kernels may write to it, too (RWTexture2D). It must be a colour with one sample per
    /// texel that is not sRGB-encoded. Kernels write to the first of its mip levels; GenerateMips
    /// makes the others, which autoGenerateMips does not, as in Unity.
    bool enableRandomWrite = false;
    TextureDimension dimension = TextureDimension::Tex2D; ///< others throw ContractError
    int volumeDepth = 1;                                  ///< others throw ContractError
    ShadowSamplingMode shadowSamplingMode = ShadowSamplingMode::None;
    VRTextureUsage vrUsage = VRTextureUsage::None; ///< others throw ContractError
    bool bindMS = false; ///< true throws ContractError: shaders see one sample per texel
    /// A value other than None promises that no next frame reads what this one leaves in the
    /// texture, so that nothing needs to be stored; within the frame it may be read. (Unity: within
    /// a pass only, and only where the device can.)
    RenderTextureMemoryless memoryless = RenderTextureMemoryless::None;
    bool useDynamicScale = false; ///< no effect: nothing scales
    /// If true, the texture's first row is the top of the picture, as in the image of a window or a
    /// host, which Unity calls the back buffer. TargetOrientation.h documents the consequences.
    /// The texture is upright only as the last target of a frame; shaders that sample it see it
    /// mirrored.
    bool isTopRowFirst = false;

    RenderTextureDescriptor() = default;
    RenderTextureDescriptor(int w, int h, GraphicsFormat format, int depthBits = 0)
        : width(w), height(h), graphicsFormat(format), depthBufferBits(depthBits)
    {
    }

    /// Returns whether texels are sRGB-encoded. Unity: the property sRGB.
    bool sRGB() const { return IsSRGBFormat(graphicsFormat); }
    /// Chooses between R8G8B8A8_SRGB and R8G8B8A8_UNorm, or B8G8R8A8_SRGB and B8G8R8A8_UNorm; other
    /// formats stay. Unity: the property sRGB.
    void SetSRGB(bool value);
    /// Sets the colour format; an sRGB format stays sRGB if the new one can be. Unity: the property
    /// colorFormat.
    void SetColorFormat(RenderTextureFormat format)
    {
        graphicsFormat = ToGraphicsFormat(format, sRGB());
    }

    /// Returns the depth format; None if depthBufferBits is 0. Unity: the property
    /// depthStencilFormat.
    GraphicsFormat depthStencilFormat() const;
    /// @param format  None or a depth format: one without a stencil sets depthBufferBits to 16, one
    ///     with a stencil to 32
    /// @throws ContractError for another format
    void SetDepthStencilFormat(GraphicsFormat format);

    bool operator==(const RenderTextureDescriptor&) const = default;
};

/// A texture that passes draw into. Its contents are undefined until the first draw or clear.
/// Unity: UnityEngine.RenderTexture.
class RenderTexture final : public Texture
{
public:
    /// @throws ContractError naming the texture, if the size is not positive, the format is None,
    ///     depthBufferBits or msaaSamples is none of the numbers that the descriptor documents,
    ///     enableRandomWrite is set for a texture that the descriptor excludes, or for any other
    ///     value for which the descriptor documents it
    RenderTexture(std::string name, const RenderTextureDescriptor& descriptor,
                  SamplerState sampler = {}, bool transient = false);
    /// Makes a colour with a depth that already exists.
    /// @param depthBuffer  a depth texture of the same size and samples
    /// @throws ContractError also if the descriptor has depthBufferBits of its own
    RenderTexture(std::string name, const RenderTextureDescriptor& descriptor, SamplerState sampler,
                  bool transient, std::shared_ptr<const RenderTexture> depthBuffer);

    const RenderTextureDescriptor& descriptor() const { return m_Descriptor; }

    /// Returns the depth and stencil that are bound with this colour when it is the only target
    /// that is set; null for a depth texture and for a colour without depth.
    /// Unity: RenderTexture.depthBuffer.
    const std::shared_ptr<const RenderTexture>& depthBuffer() const { return m_DepthBuffer; }
    /// Returns whether another texture has the same width, height and samples per texel.
    bool HasSizeOf(const RenderTexture& other) const
    {
        return width() == other.width() && height() == other.height() &&
               m_Descriptor.msaaSamples == other.m_Descriptor.msaaSamples;
    }

    /// Returns whether nothing reads the contents after the frame, so that what no later command of
    /// the frame reads need not be stored.
    bool isTransient() const
    {
        return m_Transient || m_Descriptor.memoryless != RenderTextureMemoryless::None;
    }

private:
    RenderTextureDescriptor m_Descriptor;
    std::shared_ptr<const RenderTexture> m_DepthBuffer;
    bool m_Transient;
};

} // namespace limn

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
    OneEye = 1,        ///< refused, as the next two: there is no XR
    TwoEyes = 2,       ///< refused
    DeviceSpecific = 3 ///< refused
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
    /// The colour's format. None with depthBufferBits, or a depth format, makes a depth texture, as
    /// MadeFormat says (Unity refuses a depth format here).
    GraphicsFormat graphicsFormat = GraphicsFormat::R8G8B8A8_UNorm;
    /// 0, 16, 24 or 32. Not 0 beside a colour format makes a colour with a depth of its own
    /// (RenderTexture::depthBuffer); RTHandles make a depth texture of it, whatever the colour
    /// format, as in Unity. Depth is D32_SFloat for 16, D32_SFloat_S8_UInt for 24 and 32, since in
    /// Unity only 16 has no stencil.
    int depthBufferBits = 0;
    /// 1, 2, 4 or 8 a texel. What draws left in several is resolved for whoever reads the texture:
    /// colour to the average, depth and stencil to the first sample.
    int msaaSamples = 1;
    /// With mip levels, of a colour. They are undefined until they are generated.
    bool useMipMap = false;
    /// Each draw into the texture makes them anew, when the next target is bound; else
    /// CommandBuffer::GenerateMips does.
    bool autoGenerateMips = true;
    int mipCount = 0; ///< of useMipMap: 0 = all down to 1x1
    /// Kernels may write to it, too (RWTexture2D): a colour of one sample a texel that is not
    /// sRGB-encoded. Of mip levels they write to the first; GenerateMips makes the others, which
    /// autoGenerateMips does not, as in Unity.
    bool enableRandomWrite = false;
    TextureDimension dimension = TextureDimension::Tex2D; ///< others are refused
    int volumeDepth = 1;                                  ///< others are refused
    ShadowSamplingMode shadowSamplingMode = ShadowSamplingMode::None;
    VRTextureUsage vrUsage = VRTextureUsage::None; ///< others are refused
    bool bindMS = false; ///< true is refused: shaders see one sample a texel
    /// Not None promises that no next frame reads what this one leaves in the texture, so that
    /// nothing need be stored; within a frame it may be read. (Unity: within a pass only, and only
    /// where the device can.)
    RenderTextureMemoryless memoryless = RenderTextureMemoryless::None;
    bool useDynamicScale = false; ///< no effect: nothing scales
    /// Whether the texture's first row is the top of the picture, as in a window's or a host's
    /// image: what Unity calls the back buffer. TargetOrientation.h says what follows. Only as the
    /// last target of a frame is such a texture upright; shaders that sample it see it mirrored.
    bool isTopRowFirst = false;

    RenderTextureDescriptor() = default;
    RenderTextureDescriptor(int w, int h, GraphicsFormat format, int depthBits = 0)
        : width(w), height(h), graphicsFormat(format), depthBufferBits(depthBits)
    {
    }

    /// Whether texels are sRGB-encoded. Unity: the property sRGB.
    bool sRGB() const { return IsSRGBFormat(graphicsFormat); }
    /// What is sRGB stays so, where the format can be. Unity: the property colorFormat.
    void SetColorFormat(RenderTextureFormat format)
    {
        graphicsFormat = ToGraphicsFormat(format, sRGB());
    }

    /// None where depthBufferBits is 0. Unity: the property depthStencilFormat.
    GraphicsFormat depthStencilFormat() const;
    /// @param format  None, or a depth format: one without a stencil is depthBufferBits 16, one
    ///                with it 32
    /// @throws ContractError for another format
    void SetDepthStencilFormat(GraphicsFormat format);

    bool operator==(const RenderTextureDescriptor&) const = default;
};

/// A texture that passes draw into. Contents are undefined until the first draw or clear.
/// Unity: UnityEngine.RenderTexture.
class RenderTexture final : public Texture
{
public:
    /// @throws ContractError naming the texture, if the size is not positive, the format is None,
    ///         depthBufferBits or msaaSamples is none of the numbers that the descriptor names,
    ///         enableRandomWrite is set for what the descriptor excludes, or anything that it
    ///         refuses
    RenderTexture(std::string name, const RenderTextureDescriptor& descriptor,
                  SamplerState sampler = {}, bool transient = false);
    /// Makes a colour whose depth is there already.
    /// @param depthBuffer  a depth texture of its size and samples
    /// @throws ContractError also if the descriptor has depthBufferBits of its own
    RenderTexture(std::string name, const RenderTextureDescriptor& descriptor, SamplerState sampler,
                  bool transient, std::shared_ptr<const RenderTexture> depthBuffer);

    const RenderTextureDescriptor& descriptor() const { return m_Descriptor; }

    /// Returns the depth and stencil that are bound with this colour where it is set as a target
    /// alone; null for a depth texture and for a colour without. Unity: RenderTexture.depthBuffer.
    const std::shared_ptr<const RenderTexture>& depthBuffer() const { return m_DepthBuffer; }

    /// Nobody looks at the contents after the frame: what no later command of the frame reads need
    /// not be stored.
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

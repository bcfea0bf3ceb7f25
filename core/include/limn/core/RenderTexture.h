#pragma once

#include <limn/core/Texture.h>

namespace limn
{

/// Unity: UnityEngine.RenderTextureDescriptor (2022.3), the fields that limn honours.
struct RenderTextureDescriptor
{
    int width = 0;  ///< texels
    int height = 0; ///< texels
    /// Of the colour. A depth format makes a depth texture, too (Unity refuses it here).
    GraphicsFormat graphicsFormat = GraphicsFormat::R8G8B8A8_UNorm;
    /// 0, 16, 24 or 32. Not 0 = a depth texture whose graphicsFormat is ignored, as RTHandles do:
    /// D32_SFloat for 16, D32_SFloat_S8_UInt for 24 and 32, since in Unity only 16 has no stencil.
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
    /// sRGB-encoded.
    bool enableRandomWrite = false;

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

    bool operator==(const RenderTextureDescriptor&) const = default;
};

/// A texture that passes draw into. Contents are undefined until the first draw or clear.
/// Unity: UnityEngine.RenderTexture.
class RenderTexture final : public Texture
{
public:
    /// @throws ContractError naming the texture, if the size is not positive, the format is None,
    ///         depthBufferBits or msaaSamples is none of the numbers that the descriptor names, or
    ///         enableRandomWrite is set for what the descriptor excludes
    RenderTexture(std::string name, const RenderTextureDescriptor& descriptor,
                  SamplerState sampler = {}, bool transient = false);

    const RenderTextureDescriptor& descriptor() const { return m_Descriptor; }

    /// Nobody looks at the contents after the frame: what no later command of the frame reads need
    /// not be stored.
    bool isTransient() const { return m_Transient; }

private:
    RenderTextureDescriptor m_Descriptor;
    bool m_Transient;
};

} // namespace limn

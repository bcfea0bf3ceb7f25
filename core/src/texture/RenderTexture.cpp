#include <limn/core/RenderTexture.h>

#include <limn/shaderlab/Diagnostic.h>
#include <utility>

namespace limn
{

namespace
{

GraphicsFormat FormatOf(const std::string& name, const RenderTextureDescriptor& descriptor)
{
    switch (descriptor.depthBufferBits)
    {
    case 0:
        return descriptor.graphicsFormat;
    case 16:
        return GraphicsFormat::D32_SFloat;
    case 24:
    case 32:
        return GraphicsFormat::D32_SFloat_S8_UInt;
    default:
        throw ContractError("texture '" + name + "': depthBufferBits " +
                            std::to_string(descriptor.depthBufferBits) +
                            "; it must be 0, 16, 24 or 32");
    }
}

TextureShape ShapeOf(const RenderTextureDescriptor& descriptor)
{
    TextureShape shape{TextureDimension::Tex2D, descriptor.width, descriptor.height};
    if (descriptor.useMipMap)
    {
        shape.mipCount = descriptor.mipCount == 0 ? FullMipCount(shape) : descriptor.mipCount;
    }
    return shape;
}

} // namespace

RenderTexture::RenderTexture(std::string name, const RenderTextureDescriptor& descriptor,
                             SamplerState sampler, bool transient)
    : Texture(name, ShapeOf(descriptor), FormatOf(name, descriptor), sampler),
      m_Descriptor(descriptor),
      m_Transient(transient)
{
    const int samples = descriptor.msaaSamples;
    if (samples != 1 && samples != 2 && samples != 4 && samples != 8)
    {
        throw ContractError("texture '" + name + "': msaaSamples " + std::to_string(samples) +
                            "; it must be 1, 2, 4 or 8");
    }
    if (descriptor.useMipMap && IsDepthFormat(graphicsFormat()))
    {
        throw ContractError("texture '" + name +
                            "': useMipMap of a depth texture; only a colour has "
                            "mip levels");
    }
    const GraphicsFormat format = graphicsFormat();
    if (descriptor.enableRandomWrite &&
        (samples != 1 || IsDepthFormat(format) || IsSRGBFormat(format) || mipmapCount() > 1))
    {
        throw ContractError("texture '" + this->name() + "': enableRandomWrite with " +
                            std::to_string(samples) + " samples of " + ToString(format) + " and " +
                            std::to_string(mipmapCount()) +
                            " mip levels; kernels write to colours of one sample and level that "
                            "are not sRGB");
    }
}

} // namespace limn

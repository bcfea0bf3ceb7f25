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

} // namespace

RenderTexture::RenderTexture(std::string name, const RenderTextureDescriptor& descriptor,
                             SamplerState sampler, bool transient)
    : Texture(name, {TextureDimension::Tex2D, descriptor.width, descriptor.height},
              FormatOf(name, descriptor), sampler),
      m_Descriptor(descriptor),
      m_Transient(transient)
{
    const int samples = descriptor.msaaSamples;
    if (samples != 1 && samples != 2 && samples != 4 && samples != 8)
    {
        throw ContractError("texture '" + name + "': msaaSamples " + std::to_string(samples) +
                            "; it must be 1, 2, 4 or 8");
    }
}

} // namespace limn

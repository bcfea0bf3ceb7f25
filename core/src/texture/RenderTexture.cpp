#include <limn/core/RenderTexture.h>

#include <limn/base/Diagnostic.h>
#include <limn/base/NumberText.h>
#include <utility>

namespace limn
{

namespace
{

GraphicsFormat DepthFormatOf(const std::string& name, const RenderTextureDescriptor& descriptor)
{
    switch (descriptor.depthBufferBits)
    {
    case 0:
        return GraphicsFormat::None;
    case 16:
        return GraphicsFormat::D32_SFloat;
    case 24:
    case 32:
        return GraphicsFormat::D32_SFloat_S8_UInt;
    default:
        throw ContractError("texture '" + name + "': depthBufferBits is " +
                            std::to_string(descriptor.depthBufferBits) +
                            "; it must be 0, 16, 24 or 32");
    }
}

bool HasColor(const RenderTextureDescriptor& descriptor)
{
    return descriptor.graphicsFormat != GraphicsFormat::None &&
           !IsDepthFormat(descriptor.graphicsFormat);
}

GraphicsFormat FormatOf(const std::string& name, const RenderTextureDescriptor& descriptor)
{
    const GraphicsFormat depth = DepthFormatOf(name, descriptor);
    return HasColor(descriptor) || depth == GraphicsFormat::None
               ? MadeFormat(descriptor.graphicsFormat)
               : depth;
}

/// Returns null where the descriptor asks for none beside its colour.
std::shared_ptr<const RenderTexture>
MakeDepthBuffer(const std::string& name, const RenderTextureDescriptor& descriptor, bool transient)
{
    if (!HasColor(descriptor) || descriptor.depthBufferBits == 0)
    {
        return nullptr;
    }
    RenderTextureDescriptor depth(descriptor.width, descriptor.height, GraphicsFormat::None,
                                  descriptor.depthBufferBits);
    depth.msaaSamples = descriptor.msaaSamples;
    depth.isTopRowFirst = descriptor.isTopRowFirst;
    depth.memoryless = descriptor.memoryless;
    return std::make_shared<const RenderTexture>(name + " Depth", depth, SamplerState(), transient);
}

SamplerState SamplerFor(const RenderTextureDescriptor& descriptor, SamplerState sampler)
{
    sampler.comparison =
        sampler.comparison || descriptor.shadowSamplingMode == ShadowSamplingMode::CompareDepths;
    return sampler;
}

/// Returns why limn refuses the descriptor, "" if it accepts it. A setting that has no meaning here
/// must not be ignored silently.
std::string ReasonRefused(const RenderTextureDescriptor& descriptor, GraphicsFormat format)
{
    if (descriptor.dimension != TextureDimension::Tex2D || descriptor.volumeDepth != 1)
    {
        return std::string("dimension is ") + ToString(descriptor.dimension) +
               " and volumeDepth is " + std::to_string(descriptor.volumeDepth) +
               "; passes draw only into 2D textures with a volumeDepth of 1";
    }
    if (descriptor.vrUsage != VRTextureUsage::None)
    {
        return "vrUsage is not VRTextureUsage::None; limn has no XR";
    }
    if (descriptor.bindMS)
    {
        return "bindMS is true; shaders read only the resolved texture, with one sample per texel";
    }
    const int samples = descriptor.msaaSamples;
    if (samples != 1 && samples != 2 && samples != 4 && samples != 8)
    {
        return "msaaSamples is " + std::to_string(samples) + "; it must be 1, 2, 4 or 8";
    }
    if (descriptor.useMipMap && IsDepthFormat(format))
    {
        return "useMipMap is true for a depth texture; only colours have mip levels";
    }
    if (ComponentType(format) != UniformType::Float && (samples != 1 || descriptor.useMipMap))
    {
        return std::string("its integer format ") + ToString(format) + " cannot have " +
               (samples != 1 ? "several samples per texel" : "useMipMap") +
               "; integers have no average";
    }
    if (descriptor.enableRandomWrite &&
        (samples != 1 || IsDepthFormat(format) || IsSRGBFormat(format)))
    {
        return "enableRandomWrite is true, with " +
               CountText(static_cast<std::size_t>(samples), "sample") + " of " + ToString(format) +
               "; kernels can write only to colours of one sample that are not sRGB";
    }
    return "";
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

GraphicsFormat RenderTextureDescriptor::depthStencilFormat() const
{
    return DepthFormatOf("descriptor", *this);
}

void RenderTextureDescriptor::SetDepthStencilFormat(GraphicsFormat format)
{
    if (format != GraphicsFormat::None && !IsDepthFormat(format))
    {
        throw ContractError(std::string("SetDepthStencilFormat: ") + ToString(format) +
                            " is no depth format");
    }
    depthBufferBits = format == GraphicsFormat::None ? 0 : HasStencil(format) ? 32 : 16;
}

RenderTexture::RenderTexture(std::string name, const RenderTextureDescriptor& descriptor,
                             SamplerState sampler, bool transient)
    : Texture(name, ShapeOf(descriptor), FormatOf(name, descriptor),
              SamplerFor(descriptor, sampler)),
      m_Descriptor(descriptor),
      m_DepthBuffer(MakeDepthBuffer(this->name(), descriptor, transient)),
      m_Transient(transient)
{
    if (const std::string reason = ReasonRefused(descriptor, graphicsFormat()); !reason.empty())
    {
        throw ContractError("texture '" + this->name() + "': " + reason);
    }
}

RenderTexture::RenderTexture(std::string name, const RenderTextureDescriptor& descriptor,
                             SamplerState sampler, bool transient,
                             std::shared_ptr<const RenderTexture> depthBuffer)
    : RenderTexture(std::move(name), descriptor, sampler, transient)
{
    const bool fits = depthBuffer && IsDepthFormat(depthBuffer->graphicsFormat()) &&
                      depthBuffer->width() == width() && depthBuffer->height() == height() &&
                      depthBuffer->descriptor().msaaSamples == descriptor.msaaSamples;
    if (!fits || m_DepthBuffer || !HasColor(descriptor))
    {
        throw ContractError("texture '" + this->name() +
                            "': a given depth buffer must be a depth texture with the colour's "
                            "size and samples, and the colour's depthBufferBits must be 0");
    }
    m_DepthBuffer = std::move(depthBuffer);
}

void RenderTextureDescriptor::SetSRGB(bool value)
{
    using enum GraphicsFormat;
    if (graphicsFormat == R8G8B8A8_SRGB || graphicsFormat == R8G8B8A8_UNorm)
    {
        graphicsFormat = value ? R8G8B8A8_SRGB : R8G8B8A8_UNorm;
    }
    else if (graphicsFormat == B8G8R8A8_SRGB || graphicsFormat == B8G8R8A8_UNorm)
    {
        graphicsFormat = value ? B8G8R8A8_SRGB : B8G8R8A8_UNorm;
    }
}

} // namespace limn

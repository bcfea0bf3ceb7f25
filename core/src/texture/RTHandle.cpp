#include <limn/core/RenderTargetIdentifier.h>
#include <limn/shaderlab/Diagnostic.h>

#include <algorithm>
#include <utility>

namespace limn
{

namespace
{

SamplerState MakeSampler(FilterMode filterMode, TextureWrapMode wrapMode)
{
    return {filterMode, wrapMode, wrapMode, wrapMode, false};
}

bool Matches(const RenderTexture& texture, const RenderTextureDescriptor& wanted,
             const SamplerState& sampler, std::string_view name)
{
    RenderTextureDescriptor actual = texture.descriptor();
    if (wanted.depthBufferBits != 0)
    {
        // A depth texture has no colour format, so a difference there is none.
        actual.graphicsFormat = wanted.graphicsFormat;
    }
    return actual == wanted && texture.sampler() == sampler && texture.name() == name;
}

} // namespace

RenderTargetIdentifier::RenderTargetIdentifier(const RTHandle& handle) : m_Content(handle.rt())
{
    if (!handle)
    {
        throw ContractError("RenderTargetIdentifier: the handle is empty");
    }
}

RenderTargetIdentifier::RenderTargetIdentifier(std::shared_ptr<const Texture> texture)
{
    if (texture)
    {
        m_Content = std::move(texture);
    }
}

RTHandle RTHandles::Alloc(const RenderTextureDescriptor& descriptor, FilterMode filterMode,
                          TextureWrapMode wrapMode, std::string name)
{
    return RTHandle(std::make_shared<const RenderTexture>(std::move(name), descriptor,
                                                          MakeSampler(filterMode, wrapMode)));
}

bool RenderingUtils::ReAllocateIfNeeded(RTHandle& handle, RenderTextureDescriptor descriptor,
                                        FilterMode filterMode, TextureWrapMode wrapMode,
                                        std::string_view name)
{
    descriptor.width = std::max(descriptor.width, 1);
    descriptor.height = std::max(descriptor.height, 1);
    if (handle && Matches(*handle.rt(), descriptor, MakeSampler(filterMode, wrapMode), name))
    {
        return false;
    }
    handle = RTHandles::Alloc(descriptor, filterMode, wrapMode, std::string(name));
    return true;
}

} // namespace limn

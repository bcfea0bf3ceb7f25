#include <limn/core/RTHandle.h>

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

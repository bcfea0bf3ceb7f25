#include "texture/ScaledTexture.h"

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
    return texture.descriptor() == DescriptorOfHandle(wanted) && texture.sampler() == sampler &&
           texture.name() == name;
}

} // namespace

RenderTargetIdentifier RTHandle::nameID() const
{
    return m_Identifier ? *m_Identifier : RenderTargetIdentifier(rt());
}

const std::shared_ptr<const RenderTexture>& RTHandle::ScaledToCamera() const
{
    return m_Scaled->texture();
}

glm::vec2 RTHandle::scaleFactor() const
{
    return m_Scaled ? m_Scaled->factor : glm::vec2(0.0f);
}

RTHandle RTHandles::Alloc(RenderTargetIdentifier texture)
{
    if (texture == BuiltinRenderTextureType::None)
    {
        throw ContractError("RTHandles::Alloc: the identifier is none");
    }
    return RTHandle(std::make_shared<const RenderTargetIdentifier>(std::move(texture)));
}

RTHandle RTHandles::Alloc(std::shared_ptr<const RenderTexture> texture)
{
    if (!texture)
    {
        throw ContractError("RTHandles::Alloc: the texture is null");
    }
    return RTHandle(std::move(texture));
}

RenderTargetIdentifier::RenderTargetIdentifier(const RTHandle& handle)
    : RenderTargetIdentifier(handle.nameID())
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
    return RTHandle(std::make_shared<const RenderTexture>(
        std::move(name), DescriptorOfHandle(descriptor), MakeSampler(filterMode, wrapMode)));
}

bool RenderingUtils::ReAllocateIfNeeded(RTHandle& handle, RenderTextureDescriptor descriptor,
                                        FilterMode filterMode, TextureWrapMode wrapMode,
                                        std::string_view name)
{
    descriptor.width = std::max(descriptor.width, 1);
    descriptor.height = std::max(descriptor.height, 1);
    if (handle.rt() && Matches(*handle.rt(), descriptor, MakeSampler(filterMode, wrapMode), name))
    {
        return false;
    }
    handle = RTHandles::Alloc(descriptor, filterMode, wrapMode, std::string(name));
    return true;
}

} // namespace limn

#include "texture/ScaledTexture.h"

#include <limn/base/Diagnostic.h>
#include <limn/core/RenderTargetIdentifier.h>

#include <algorithm>
#include <utility>

namespace limn
{

namespace
{

bool Matches(const RenderTexture& texture, const RenderTextureDescriptor& wanted,
             const SamplerState& sampler, std::string_view name)
{
    return texture.descriptor() == wanted && texture.sampler() == sampler && texture.name() == name;
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
        std::move(name), DescriptorOfHandle(descriptor), SamplerWith(filterMode, wrapMode)));
}

bool RenderingUtils::ReAllocateIfNeeded(RTHandle& handle, RenderTextureDescriptor descriptor,
                                        FilterMode filterMode, TextureWrapMode wrapMode,
                                        std::string_view name)
{
    ReAllocateArguments arguments{filterMode, wrapMode};
    arguments.name = name;
    return ReAllocateIfNeeded(handle, descriptor, arguments);
}

bool RenderingUtils::ReAllocateIfNeeded(RTHandle& handle, const RenderTextureDescriptor& descriptor,
                                        const ReAllocateArguments& arguments)
{
    RenderTextureDescriptor wanted = DescriptorOfHandle(WithArguments(descriptor, arguments));
    wanted.width = std::max(wanted.width, 1);
    wanted.height = std::max(wanted.height, 1);
    const SamplerState sampler = SamplerWith(wanted, arguments);
    const bool isKept = handle.rt() && !handle.useScaling() &&
                        Matches(*handle.rt(), wanted, sampler, arguments.name);
    if (!isKept)
    {
        handle = RTHandle(
            std::make_shared<const RenderTexture>(std::string(arguments.name), wanted, sampler));
    }
    return !isKept;
}

} // namespace limn

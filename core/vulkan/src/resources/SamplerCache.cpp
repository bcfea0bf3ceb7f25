#include "resources/SamplerCache.h"

#include "device/Check.h"
#include <algorithm>
#include <limn/core/DrawError.h>

namespace limn::vulkan
{

namespace
{

VkSamplerAddressMode ToAddressMode(TextureWrapMode mode, bool mirrorOnce)
{
    switch (mode)
    {
    case TextureWrapMode::Repeat:
        return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    case TextureWrapMode::Mirror:
        return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    case TextureWrapMode::MirrorOnce:
        return mirrorOnce ? VK_SAMPLER_ADDRESS_MODE_MIRROR_CLAMP_TO_EDGE
                          : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    case TextureWrapMode::Clamp:
        break;
    }
    return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
}

void RequireSupport(const SamplerState& state, const DeviceCapabilities& can)
{
    const auto refuse = [](const char* what, const char* feature)
    {
        throw DrawError(std::string("a texture is read ") + what + ", which needs " + feature +
                        " of VK_KHR_portability_subset; the device lacks it");
    };
    if (state.mipMapBias != 0.0f && !can.mipLodBias)
    {
        refuse("with a mipMapBias", "samplerMipLodBias");
    }
    if (state.comparison && !can.comparisonSamplers)
    {
        refuse("by a SamplerComparisonState", "mutableComparisonSamplers");
    }
}

} // namespace

VkSampler SamplerCache::Get(const SamplerState& state, std::uint64_t number)
{
    if (Entry* found = FindPooled(m_Samplers, state))
    {
        found->lastUse = number;
        return found->sampler.get();
    }
    const std::uint32_t most = m_Context.capabilities().limits.maxSamplerAllocationCount;
    if (m_Samplers.size() >= most)
    {
        throw DrawError("the frame reads textures in more than " + std::to_string(most) +
                        " ways (filter, wrap mode and mip bias), which is as many samplers as the "
                        "device has; share samplers between textures");
    }
    Entry entry{Create(state), number};
    return m_Samplers.emplace(state, std::move(entry)).first->second.sampler.get();
}

void SamplerCache::Sweep(std::uint64_t finished)
{
    // Frames that are recorded already, and their descriptor sets, are made anew afterwards.
    if (m_Samplers.size() > m_Context.capabilities().limits.maxSamplerAllocationCount / 4)
    {
        m_Freed += std::erase_if(m_Samplers,
                                 [&](const auto& item) { return item.second.lastUse <= finished; });
    }
}

UniqueSampler SamplerCache::Create(const SamplerState& state) const
{
    RequireSupport(state, m_Context.capabilities());
    const VkFilter filter =
        state.filterMode == FilterMode::Point ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
    const bool mirrorOnce = m_Context.capabilities().mirrorOnce;
    auto info = Make<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    info.magFilter = filter;
    info.minFilter = filter;
    info.mipmapMode = state.filterMode == FilterMode::Trilinear ? VK_SAMPLER_MIPMAP_MODE_LINEAR
                                                                : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = ToAddressMode(state.wrapModeU, mirrorOnce);
    info.addressModeV = ToAddressMode(state.wrapModeV, mirrorOnce);
    info.addressModeW = ToAddressMode(state.wrapModeW, mirrorOnce);
    info.compareEnable = state.comparison ? VK_TRUE : VK_FALSE;
    info.compareOp = !state.comparison ? VK_COMPARE_OP_ALWAYS
                     : state.standardZ ? VK_COMPARE_OP_LESS_OR_EQUAL
                                       : VK_COMPARE_OP_GREATER_OR_EQUAL;
    info.maxLod = VK_LOD_CLAMP_NONE;
    const VkPhysicalDeviceLimits& limits = m_Context.capabilities().limits;
    info.mipLodBias =
        std::clamp(state.mipMapBias, -limits.maxSamplerLodBias, limits.maxSamplerLodBias);
    // As in Unity, the point filter takes one texel whatever the level is.
    info.anisotropyEnable = m_Context.capabilities().features.samplerAnisotropy &&
                                    state.anisoLevel > 1 && state.filterMode != FilterMode::Point
                                ? VK_TRUE
                                : VK_FALSE;
    info.maxAnisotropy =
        std::min(static_cast<float>(state.anisoLevel), limits.maxSamplerAnisotropy);
    return {m_Context.device(), vkCreateSampler, info, "vkCreateSampler"};
}

} // namespace limn::vulkan

#include "resources/SamplerCache.h"

#include "device/Check.h"
#include <algorithm>

namespace limn::vulkan
{

namespace
{

SamplerKey Pack(const SamplerState& state)
{
    const int bits = static_cast<int>(state.filterMode) + 4 * static_cast<int>(state.wrapModeU) +
                     16 * static_cast<int>(state.wrapModeV) +
                     64 * static_cast<int>(state.wrapModeW) + (state.comparison ? 256 : 0) +
                     (state.standardZ ? 512 : 0) + 1024 * state.anisoLevel;
    return {bits, state.mipMapBias};
}

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

} // namespace

VkSampler SamplerCache::Get(const SamplerState& state)
{
    UniqueSampler& sampler = m_Samplers[Pack(state)];
    if (sampler)
    {
        return sampler.get();
    }
    const VkFilter filter =
        state.filterMode == FilterMode::Point ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
    const bool mirrorOnce = m_Context.capabilities().mirrorOnce;
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
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
    // As in Unity, whose point filter takes one texel whatever the level.
    info.anisotropyEnable = m_Context.capabilities().anisotropy && state.anisoLevel > 1 &&
                                    state.filterMode != FilterMode::Point
                                ? VK_TRUE
                                : VK_FALSE;
    info.maxAnisotropy =
        std::min(static_cast<float>(state.anisoLevel), limits.maxSamplerAnisotropy);
    VkSampler handle = VK_NULL_HANDLE;
    Check(vkCreateSampler(m_Context.device(), &info, nullptr, &handle), "vkCreateSampler");
    sampler = UniqueSampler{m_Context.device(), handle};
    return handle;
}

} // namespace limn::vulkan

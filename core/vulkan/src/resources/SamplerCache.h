#pragma once

#include "device/UniqueHandle.h"
#include "device/VulkanContext.h"
#include <limn/core/Texture.h>
#include <map>

namespace limn::vulkan
{

/// A state's fields, packed, and its bias.
using SamplerKey = std::pair<int, float>;

/// One sampler for each way of reading a texture; there are at most a few dozen.
class SamplerCache
{
public:
    explicit SamplerCache(const VulkanContext& context) : m_Context(context) {}

    VkSampler Get(const SamplerState& state);

private:
    const VulkanContext& m_Context;
    std::map<SamplerKey, UniqueSampler> m_Samplers;
};

} // namespace limn::vulkan

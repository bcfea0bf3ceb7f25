#pragma once

#include "device/UniqueHandle.h"
#include "device/VulkanContext.h"
#include <limn/core/Texture.h>
#include <map>

namespace limn::vulkan
{

/// A state's fields, packed, and its bias.
using SamplerKey = std::pair<int, float>;

/// One sampler for each way of reading a texture. Mostly there are a few dozen; where a bias is
/// animated each frame has others, and those that no frame in flight uses make room.
class SamplerCache
{
public:
    explicit SamplerCache(const VulkanContext& context) : m_Context(context) {}

    /// @param number  of the submission that uses it
    /// @throws DrawError if the frames in flight need more samplers than the device has
    VkSampler Get(const SamplerState& state, std::uint64_t number);
    /// Adds the uses of those that submission `number` uses.
    void AddUses(std::uint64_t number, std::vector<std::uint64_t*>& uses);
    void Rollback(std::uint64_t number) noexcept; ///< that submission never will be
    void Sweep(std::uint64_t finished);
    std::uint64_t freedCount() const { return m_Freed; } ///< so far

private:
    struct Entry
    {
        UniqueSampler sampler;
        std::uint64_t lastUse = 0;
    };
    UniqueSampler Create(const SamplerState& state) const;

    const VulkanContext& m_Context;
    std::map<SamplerKey, Entry> m_Samplers;
    std::uint64_t m_Freed = 0;
};

} // namespace limn::vulkan

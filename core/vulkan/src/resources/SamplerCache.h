#pragma once

#include "device/UniqueHandle.h"
#include "device/VulkanContext.h"
#include "resources/Pooled.h"
#include <limn/core/Texture.h>

namespace limn::vulkan
{

/// Keeps one sampler for each way of reading a texture. Mostly there are a few dozen. If a bias is
/// animated, each frame needs others, and those that no frame in flight uses are freed.
class SamplerCache
{
public:
    explicit SamplerCache(const VulkanContext& context) : m_Context(context) {}

    /// @param number  the number of the submission that uses the sampler
    /// @throws DrawError if the frames in flight need more samplers than the device has
    VkSampler Get(const SamplerState& state, std::uint64_t number);
    /// Adds the uses of the samplers that submission `number` uses.
    void AddUses(std::uint64_t number, std::vector<std::uint64_t*>& uses)
    {
        AddPooledUses(m_Samplers, number, uses);
    }
    /// The submission will never happen.
    void Rollback(std::uint64_t number) noexcept { UndoPooledUses(m_Samplers, number); }
    void Sweep(std::uint64_t finished);
    std::uint64_t freedCount() const { return m_Freed; } ///< the number of samplers freed so far

private:
    struct Entry
    {
        UniqueSampler sampler;
        std::uint64_t lastUse = 0;
    };
    UniqueSampler Create(const SamplerState& state) const;

    const VulkanContext& m_Context;
    std::map<SamplerState, Entry> m_Samplers;
    std::uint64_t m_Freed = 0;
};

} // namespace limn::vulkan

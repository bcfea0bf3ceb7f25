#pragma once

#include "descriptors/DescriptorCache.h"
#include "frame/SubmitQueue.h"
#include "memory/LinearMemory.h"

namespace limn::vulkan
{

/// What one frame in flight owns; taken again when the GPU is done with the frame.
class FrameSlot
{
public:
    FrameSlot(const VulkanContext& context, MemoryAllocator& allocator);

    VkCommandBuffer commands() const { return m_Commands; }
    LinearMemory& upload() { return m_Upload; }
    DescriptorCache& descriptors() { return m_Descriptors; }
    const DescriptorCache& descriptors() const { return m_Descriptors; }
    std::uint64_t number() const { return m_Number; } ///< of its last submission, 0 = none

    /// Starts recording. @pre the slot's last submission is finished
    /// @param destroyed  see DescriptorCache::Begin
    void Begin(std::size_t passCount, std::uint64_t destroyed = 0);
    /// What was recorded will not be submitted; Begin() drops it.
    void Abandon() noexcept { m_TimedCount = 0; }
    /// Ends recording and submits.
    void Submit(SubmitQueue& queue);

    void BeginTiming(const std::string& name);
    void EndTiming();
    /// @pre the slot's last submission is finished
    std::vector<PassTiming> ReadTimings() const;

private:
    void ReserveQueries(std::size_t passCount);

    const VulkanContext& m_Context;
    UniqueCommandPool m_Pool;
    VkCommandBuffer m_Commands = VK_NULL_HANDLE; ///< owned by the pool
    LinearMemory m_Upload;
    DescriptorCache m_Descriptors;
    UniqueQueryPool m_Queries; ///< two a pass
    std::uint32_t m_QueryCapacity = 0;
    std::vector<std::string> m_TimedPasses; ///< the first `m_TimedCount` are of this frame
    std::size_t m_TimedCount = 0;
    std::uint64_t m_Number = 0;
};

} // namespace limn::vulkan

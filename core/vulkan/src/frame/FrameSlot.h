#pragma once

#include "descriptors/DescriptorAllocator.h"
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
    DescriptorAllocator& descriptors() { return m_Descriptors; }
    std::uint64_t number() const { return m_Number; } ///< of its last submission, 0 = none

    /// Starts recording. @pre the slot's last submission is finished
    void Begin(std::size_t passCount);
    /// What was recorded will not be submitted; Begin() drops it.
    void Abandon() noexcept { m_TimedPasses.clear(); }
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
    DescriptorAllocator m_Descriptors;
    UniqueQueryPool m_Queries; ///< two a pass
    std::uint32_t m_QueryCapacity = 0;
    std::vector<std::string> m_TimedPasses;
    std::uint64_t m_Number = 0;
};

} // namespace limn::vulkan

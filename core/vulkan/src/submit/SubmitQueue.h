#pragma once

#include "device/UniqueHandle.h"
#include "device/VulkanContext.h"

namespace limn::vulkan
{

/// The device's queue with a timeline: every submission gets the next number.
class SubmitQueue
{
public:
    explicit SubmitQueue(const VulkanContext& context);
    ~SubmitQueue(); ///< waits until the device is idle
    SubmitQueue(const SubmitQueue&) = delete;
    SubmitQueue& operator=(const SubmitQueue&) = delete;

    /// Returns the number of the next submission.
    std::uint64_t nextNumber() const { return m_Submitted + 1; }
    std::uint64_t lastNumber() const { return m_Submitted; }
    std::uint64_t finishedNumber() const; ///< all submissions up to this number are done

    /// @param before  commands that run first; null = none
    void Submit(VkCommandBuffer before, VkCommandBuffer commands);
    void Wait(std::uint64_t number) const;
    void WaitIdle() const noexcept; ///< waits until nothing is in use any more

private:
    const VulkanContext& m_Context;
    UniqueSemaphore m_Timeline;
    std::uint64_t m_Submitted = 0;
};

} // namespace limn::vulkan

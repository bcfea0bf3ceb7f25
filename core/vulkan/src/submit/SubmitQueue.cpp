#include "submit/SubmitQueue.h"

#include "device/Check.h"
#include <array>
#include <limits>

namespace limn::vulkan
{

SubmitQueue::SubmitQueue(const VulkanContext& context) : m_Context(context)
{
    auto type = Make<VkSemaphoreTypeCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO);
    type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
    auto info = Make<VkSemaphoreCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO);
    info.pNext = &type;
    m_Timeline = UniqueSemaphore{context.device(), vkCreateSemaphore, info, "vkCreateSemaphore",
                                 "frame timeline"};
}

SubmitQueue::~SubmitQueue()
{
    WaitIdle();
}

void SubmitQueue::WaitIdle() const noexcept
{
    // A lost device is idle too. Want of memory is no answer to somebody who frees things next.
    constexpr int k_Attempts = 8;
    VkResult result = VK_ERROR_OUT_OF_HOST_MEMORY;
    for (int i = 0; i < k_Attempts && result < 0 && result != VK_ERROR_DEVICE_LOST; ++i)
    {
        result = vkDeviceWaitIdle(m_Context.device());
    }
}

std::uint64_t SubmitQueue::finishedNumber() const
{
    std::uint64_t value = 0;
    Check(vkGetSemaphoreCounterValue(m_Context.device(), m_Timeline.get(), &value),
          "vkGetSemaphoreCounterValue", "frame timeline");
    return value;
}

void SubmitQueue::Submit(VkCommandBuffer before, VkCommandBuffer commands)
{
    std::array<VkCommandBufferSubmitInfo, 2> buffers{};
    std::uint32_t count = 0;
    for (VkCommandBuffer buffer : {before, commands})
    {
        if (buffer != VK_NULL_HANDLE)
        {
            buffers.at(count).sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
            buffers.at(count++).commandBuffer = buffer;
        }
    }
    auto signal = Make<VkSemaphoreSubmitInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO);
    signal.semaphore = m_Timeline.get();
    signal.value = nextNumber();
    signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    auto info = Make<VkSubmitInfo2>(VK_STRUCTURE_TYPE_SUBMIT_INFO_2);
    info.commandBufferInfoCount = count;
    info.pCommandBufferInfos = buffers.data();
    info.signalSemaphoreInfoCount = 1;
    info.pSignalSemaphoreInfos = &signal;
    Check(vkQueueSubmit2(m_Context.queue(), 1, &info, VK_NULL_HANDLE), "vkQueueSubmit2");
    ++m_Submitted;
}

void SubmitQueue::Wait(std::uint64_t number) const
{
    const VkSemaphore semaphore = m_Timeline.get();
    auto info = Make<VkSemaphoreWaitInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO);
    info.semaphoreCount = 1;
    info.pSemaphores = &semaphore;
    info.pValues = &number;
    VkResult result = VK_TIMEOUT;
    while (result == VK_TIMEOUT) // some drivers know no endless wait
    {
        result =
            vkWaitSemaphores(m_Context.device(), &info, std::numeric_limits<std::uint64_t>::max());
    }
    Check(result, "vkWaitSemaphores", "frame timeline");
}

} // namespace limn::vulkan

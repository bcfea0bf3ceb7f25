#include "submit/CopyBandwidth.h"

#include "submit/FrameSlot.h"

#include <algorithm>
#include <chrono>

namespace limn::vulkan
{

namespace
{

constexpr VkDeviceSize k_Bytes = VkDeviceSize{64} << 20; // more than a processor's caches hold
constexpr int k_Copies = 4;                              // beside which submitting takes no time
constexpr int k_Rounds = 5;                              // the first meets memory never touched

/// Seconds until all copies are done.
double TimeCopies(const VulkanContext& context, MemoryAllocator& allocator, SubmitQueue& queue,
                  VkBuffer from, VkBuffer to)
{
    FrameSlot slot{context, allocator};
    slot.BeginRecording(0);
    const VkBufferCopy region{0, 0, k_Bytes};
    constexpr UsageScope k_BothWays{VK_PIPELINE_STAGE_2_COPY_BIT,
                                    VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT};
    for (int i = 0; i < k_Copies; ++i)
    {
        RecordBarrier(slot.commands(), k_BothWays, k_BothWays);
        vkCmdCopyBuffer(slot.commands(), from, to, 1, &region);
    }
    slot.EndRecording();
    const auto begin = std::chrono::steady_clock::now();
    slot.Submit(queue);
    queue.Wait(slot.number());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

double MeasureCopyBandwidth(const VulkanContext& context, MemoryAllocator& allocator,
                            SubmitQueue& queue)
{
    const auto make = [&](VkBufferUsageFlags usage)
    {
        return Buffer{context.device(), allocator,       k_Bytes, usage,
                      MemoryUse::Gpu,   "buffer to copy"};
    };
    const Buffer from = make(VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    const Buffer to = make(VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    double shortest = TimeCopies(context, allocator, queue, from.handle.get(), to.handle.get());
    for (int i = 1; i < k_Rounds; ++i)
    {
        shortest = std::min(
            shortest, TimeCopies(context, allocator, queue, from.handle.get(), to.handle.get()));
    }
    return 2.0 * k_Copies * static_cast<double>(k_Bytes) / shortest;
}

} // namespace limn::vulkan

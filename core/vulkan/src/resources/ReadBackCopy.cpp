#include "resources/ReadBackCopy.h"

#include "frame/FrameSlot.h"
#include <functional>

namespace limn::vulkan
{

namespace
{

GraphicsFormat CopiedFormat(GraphicsFormat format, VkImageAspectFlagBits aspect)
{
    switch (aspect)
    {
    case VK_IMAGE_ASPECT_DEPTH_BIT:
        return GraphicsFormat::D32_SFloat;
    case VK_IMAGE_ASPECT_STENCIL_BIT:
        return GraphicsFormat::R8_UNorm;
    default:
        return format;
    }
}

/// What was copied is there for the CPU.
void RecordHostBarrier(VkCommandBuffer commands)
{
    VkMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
    RecordBarrier(commands, barrier);
}

void RecordCopy(VkCommandBuffer commands, const PooledImage& image, const Image& size,
                VkImageAspectFlagBits aspect, VkBuffer target)
{
    VkBufferImageCopy region{};
    region.imageSubresource.aspectMask = static_cast<VkImageAspectFlags>(aspect);
    region.imageSubresource.layerCount = 1;
    region.imageExtent = {static_cast<std::uint32_t>(size.width),
                          static_cast<std::uint32_t>(size.height), 1};
    vkCmdCopyImageToBuffer(commands, image.readImage(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           target, 1, &region);
    RecordHostBarrier(commands);
}

/// Submits what `record` records and waits for it.
void RunNow(const VulkanContext& context, MemoryAllocator& allocator, SubmitQueue& queue,
            const std::function<void(VkCommandBuffer)>& record)
{
    FrameSlot slot{context, allocator};
    slot.BeginRecording(0);
    record(slot.commands());
    slot.EndRecording();
    slot.Submit(queue);
    try
    {
        queue.Wait(slot.number());
    }
    catch (...)
    {
        queue.WaitIdle(); // the copy may still be at it
        throw;
    }
}

} // namespace

Image CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator, SubmitQueue& queue,
                const PooledImage& image, const RenderTexture& texture,
                VkImageAspectFlagBits aspect)
{
    Image result;
    result.width = texture.width();
    result.height = texture.height();
    result.format = CopiedFormat(texture.graphicsFormat(), aspect);
    const auto size = static_cast<std::size_t>(result.width) *
                      static_cast<std::size_t>(result.height) *
                      static_cast<std::size_t>(BytesPerTexel(result.format));
    const Buffer buffer{
        context.device(),    allocator,         size, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        MemoryUse::ReadBack, "read-back buffer"};
    RunNow(context, allocator, queue,
           [&](VkCommandBuffer commands)
           { RecordCopy(commands, image, result, aspect, buffer.handle.get()); });
    const std::byte* texels = buffer.memory.mapped();
    result.texels.assign(texels, texels + size);
    return result;
}

std::vector<std::byte> CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator,
                                 SubmitQueue& queue, const PooledBuffer& buffer, std::size_t size)
{
    const Buffer target{
        context.device(),    allocator,         size, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        MemoryUse::ReadBack, "read-back buffer"};
    RunNow(context, allocator, queue,
           [&](VkCommandBuffer commands)
           {
               VkMemoryBarrier2 barrier{}; // whatever wrote it last
               barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
               barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
               barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
               barrier.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
               barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT;
               RecordBarrier(commands, barrier);
               const VkBufferCopy region{0, 0, size};
               vkCmdCopyBuffer(commands, buffer.buffer.handle.get(), target.handle.get(), 1,
                               &region);
               RecordHostBarrier(commands);
           });
    const std::byte* bytes = target.memory.mapped();
    return {bytes, bytes + size};
}

} // namespace limn::vulkan

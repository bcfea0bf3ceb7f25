#include "submit/ReadBackCopy.h"

namespace limn::vulkan
{

namespace
{

GraphicsFormat CopiedFormat(GraphicsFormat format, VkImageAspectFlagBits aspect)
{
    return aspect == VK_IMAGE_ASPECT_DEPTH_BIT     ? GraphicsFormat::D32_SFloat
           : aspect == VK_IMAGE_ASPECT_STENCIL_BIT ? GraphicsFormat::R8_UNorm
                                                   : format;
}

constexpr UsageScope k_CopiedFrom{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
/// Whatever writes a buffer before or after the copy.
constexpr UsageScope k_AnyWrite{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT};

/// Records the barrier that makes the copied data visible to the CPU.
void RecordHostBarrier(VkCommandBuffer commands)
{
    RecordBarrier(commands, {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                  {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
}

void RecordCopy(VkCommandBuffer commands, const PooledImage& image, const Image& size,
                VkImageAspectFlagBits aspect, VkBuffer target)
{
    VkBufferImageCopy region{};
    region.imageSubresource.aspectMask = static_cast<VkImageAspectFlags>(aspect);
    region.imageSubresource.layerCount = 1;
    region.imageExtent = {static_cast<std::uint32_t>(size.width),
                          static_cast<std::uint32_t>(size.height), 1};
    vkCmdCopyImageToBuffer(commands, image.read().image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           target, 1, &region);
    RecordHostBarrier(commands);
}

std::size_t SizeOf(const Image& shape)
{
    return static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.height) *
           static_cast<std::size_t>(BytesPerTexel(shape.format));
}

} // namespace

ReadBackCopy::ReadBackCopy(const VulkanContext& context, MemoryAllocator& allocator,
                           SubmitQueue& queue, Image shape, const Record& record)
    : PendingReadback(std::move(shape)), m_Queue(queue), m_Size(SizeOf(result()))
{
    m_Buffer.emplace(context.device(), allocator, m_Size, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                     MemoryUse::ReadBack, "read-back buffer");
    m_Slot.emplace(context, allocator);
    m_Slot->BeginRecording(0);
    record(m_Slot->commands(), m_Buffer->handle.get());
    m_Slot->EndRecording();
    m_Slot->Submit(queue);
    m_Number = m_Slot->number();
}

ReadBackCopy::~ReadBackCopy()
{
    if (m_Slot)
    {
        m_Queue.WaitIdle(); // the copy may still be at it
    }
}

Image ReadBackCopy::WaitAndTake()
{
    Wait();
    Image image = result();
    image.texels = Take();
    Release();
    return image;
}

std::vector<std::byte> ReadBackCopy::Take()
{
    const std::byte* bytes = m_Buffer->memory.mapped();
    return {bytes, bytes + m_Size};
}

void ReadBackCopy::Release() noexcept
{
    if (hasError())
    {
        m_Queue.WaitIdle();
    }
    m_Slot.reset();
    m_Buffer.reset();
}

std::shared_ptr<ReadBackCopy> CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator,
                                        SubmitQueue& queue, const PooledImage& image,
                                        const RenderTexture& texture, VkImageAspectFlagBits aspect)
{
    const Image shape{
        texture.width(), texture.height(), CopiedFormat(texture.graphicsFormat(), aspect), {}};
    return std::make_shared<ReadBackCopy>(context, allocator, queue, shape,
                                          [&](VkCommandBuffer commands, VkBuffer target)
                                          { RecordCopy(commands, image, shape, aspect, target); });
}

std::shared_ptr<ReadBackCopy> CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator,
                                        SubmitQueue& queue, const PooledBuffer& buffer,
                                        std::size_t size)
{
    const auto record = [&](VkCommandBuffer commands, VkBuffer target)
    {
        RecordBarrier(commands, k_AnyWrite, k_CopiedFrom);
        const VkBufferCopy region{0, 0, size};
        vkCmdCopyBuffer(commands, buffer.buffer.handle.get(), target, 1, &region);
        RecordHostBarrier(commands);
        // Whoever writes it next knows nothing of the copy.
        RecordBarrier(commands, k_CopiedFrom, k_AnyWrite);
    };
    const Image shape{static_cast<int>(size), 1, GraphicsFormat::R8_UNorm, {}};
    return std::make_shared<ReadBackCopy>(context, allocator, queue, shape, record);
}

} // namespace limn::vulkan

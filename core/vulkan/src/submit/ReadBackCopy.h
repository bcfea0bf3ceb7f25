#pragma once

#include "resources/BufferPool.h"
#include "resources/ImagePool.h"
#include "submit/FrameSlot.h"
#include <limn/core/AsyncGPUReadback.h>

namespace limn::vulkan
{

/// A copy to the CPU that has been submitted.
class ReadBackCopy final : public PendingReadback
{
public:
    /// Records what copies the result into the buffer.
    using Record = std::function<void(VkCommandBuffer commands, VkBuffer target)>;

    /// Submits the copy. @lifetime keeps `queue` until it is done
    ReadBackCopy(const VulkanContext& context, MemoryAllocator& allocator, SubmitQueue& queue,
                 Image shape, const Record& record);
    ~ReadBackCopy() override; ///< waits, if it is not done
    ReadBackCopy(const ReadBackCopy&) = delete;
    ReadBackCopy& operator=(const ReadBackCopy&) = delete;

    std::uint64_t number() const { return m_Number; } ///< of its submission
    /// What the request gets, once it is there.
    Image WaitAndTake();

private:
    bool isReady() override { return m_Queue.finishedNumber() >= m_Number; }
    void Wait() override { m_Queue.Wait(m_Number); }
    std::vector<std::byte> Take() override;
    void Release() noexcept override;

    SubmitQueue& m_Queue;
    std::size_t m_Size;
    std::optional<Buffer> m_Buffer;
    std::optional<FrameSlot> m_Slot; ///< none once it is done
    std::uint64_t m_Number = 0;
};

/// Copies one aspect of the image. Stencil comes as R8_UNorm, depth as D32_SFloat, several samples
/// resolved.
/// @pre its use is CopySource
std::shared_ptr<ReadBackCopy> CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator,
                                        SubmitQueue& queue, const PooledImage& image,
                                        const RenderTexture& texture, VkImageAspectFlagBits aspect);

/// Copies the first `size` bytes of the buffer: a row of R8_UNorm.
std::shared_ptr<ReadBackCopy> CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator,
                                        SubmitQueue& queue, const PooledBuffer& buffer,
                                        std::size_t size);

} // namespace limn::vulkan

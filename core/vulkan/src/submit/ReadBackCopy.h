#pragma once

#include "submit/FrameSlot.h"
#include <limn/core/AsyncGPUReadback.h>

namespace limn::vulkan
{

/// A copy to the CPU that has been submitted.
class ReadBackCopy final : public PendingReadback
{
public:
    /// Records the commands that copy the result into the buffer.
    using Record = std::function<void(VkCommandBuffer commands, VkBuffer target)>;

    /// Submits the copy.
    /// @lifetime keeps `queue` until the copy is done
    ReadBackCopy(const VulkanContext& context, MemoryAllocator& allocator, SubmitQueue& queue,
                 Image shape, const Record& record);
    ~ReadBackCopy() override; ///< waits, if it is not done
    ReadBackCopy(const ReadBackCopy&) = delete;
    ReadBackCopy& operator=(const ReadBackCopy&) = delete;

    std::uint64_t number() const { return m_Number; } ///< the number of its submission
    /// Waits for the result and returns it.
    Image WaitAndTake();

private:
    bool isReady() override { return m_Queue.finishedNumber() >= m_Number; }
    void Wait() override { m_Queue.Wait(m_Number); }
    std::vector<std::byte> Take() override;
    void Release() noexcept override;

    SubmitQueue& m_Queue;
    std::size_t m_Size;
    std::optional<Buffer> m_Buffer;
    std::optional<FrameSlot> m_Slot; ///< empty once the copy is done
    std::uint64_t m_Number = 0;
};

/// Copies one aspect of the image. Stencil is returned as R8_UNorm, depth as D32_SFloat, and
/// several samples are resolved.
/// @pre the use of the image is CopySource
std::shared_ptr<ReadBackCopy> CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator,
                                        SubmitQueue& queue, const PooledImage& image,
                                        const RenderTexture& texture, VkImageAspectFlagBits aspect);

/// Copies the first `size` bytes of the buffer, as a row of R8_UNorm.
std::shared_ptr<ReadBackCopy> CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator,
                                        SubmitQueue& queue, const PooledBuffer& buffer,
                                        std::size_t size);

} // namespace limn::vulkan

#pragma once

#include "device/Translate.h"
#include "device/UniqueHandle.h"
#include "device/VulkanContext.h"

namespace limn::vulkan
{

/// A command buffer with a pool of its own.
class Commands
{
public:
    explicit Commands(const VulkanContext& context);

    VkCommandBuffer handle() const { return m_Handle; }
    /// Drops the recorded commands and begins to record again.
    /// @pre the device is done with them
    void Begin(VkCommandBufferUsageFlags usage);
    void End();

private:
    VkDevice m_Device;
    UniqueCommandPool m_Pool;
    VkCommandBuffer m_Handle = VK_NULL_HANDLE; ///< owned by the pool
};

/// Records the barriers; does nothing if there are none.
void RecordBarriers(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier2> images,
                    std::span<const VkMemoryBarrier2> memory = {});
/// Records a barrier between two uses of memory.
void RecordBarrier(VkCommandBuffer commands, const UsageScope& from, const UsageScope& to);

} // namespace limn::vulkan

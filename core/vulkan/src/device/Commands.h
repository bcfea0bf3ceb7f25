#pragma once

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

void RecordBarrier(VkCommandBuffer commands, const VkMemoryBarrier2& barrier);

} // namespace limn::vulkan

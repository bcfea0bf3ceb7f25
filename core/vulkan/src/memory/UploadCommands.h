#pragma once

#include "device/Commands.h"
#include "memory/LinearMemory.h"

namespace limn::vulkan
{

/// Copies from the CPU that run before a frame's passes. They have a separate command buffer, so
/// that the recorded passes can be submitted again without them.
class UploadCommands
{
public:
    UploadCommands(const VulkanContext& context, MemoryAllocator& allocator)
        : m_Commands(context), m_Staging(context.device(), allocator, MemoryUse::Staging)
    {
    }

    void Reset(); ///< forgets all; the device must be done with it

    VkCommandBuffer commands(); ///< the command buffer to record into; the first call begins it
    LinearMemory& staging() { return m_Staging; }
    /// Ends recording. Returns the commands recorded since Reset(), or null if there are none.
    VkCommandBuffer End();

private:
    Commands m_Commands;
    LinearMemory m_Staging;
    bool m_IsBegun = false;
};

} // namespace limn::vulkan

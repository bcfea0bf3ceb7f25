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

    /// Forgets all; the device must be done with it.
    void Reset()
    {
        m_IsBegun = false;
        m_Staging.Reset();
    }
    /// Returns the command buffer to record into. The first call begins it.
    VkCommandBuffer commands()
    {
        if (!m_IsBegun)
        {
            m_Commands.Begin(VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT);
            m_IsBegun = true;
        }
        return m_Commands.handle();
    }
    LinearMemory& staging() { return m_Staging; }
    /// Ends recording. Returns the commands recorded since Reset(), or null if there are none.
    VkCommandBuffer End()
    {
        if (!m_IsBegun)
        {
            return VK_NULL_HANDLE;
        }
        m_Commands.End();
        return m_Commands.handle();
    }

private:
    Commands m_Commands;
    LinearMemory m_Staging;
    bool m_IsBegun = false;
};

} // namespace limn::vulkan

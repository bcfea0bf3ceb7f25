#pragma once

#include "device/Commands.h"
#include "memory/LinearMemory.h"

namespace limn::vulkan
{

/// Copies from the CPU that are done before a frame's passes, in commands of their own: what is
/// recorded of the passes may be submitted again without them.
class UploadCommands
{
public:
    UploadCommands(const VulkanContext& context, MemoryAllocator& allocator)
        : m_Commands(context), m_Staging(context.device(), allocator, MemoryUse::Staging)
    {
    }

    void Reset(); ///< forgets all. @pre the device is done with it

    VkCommandBuffer commands(); ///< to record into; begun by the first call
    LinearMemory& staging() { return m_Staging; }
    /// What was recorded since Reset(); null = nothing.
    VkCommandBuffer End();

private:
    Commands m_Commands;
    LinearMemory m_Staging;
    bool m_IsBegun = false;
};

} // namespace limn::vulkan

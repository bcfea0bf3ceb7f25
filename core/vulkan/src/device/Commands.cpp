#include "device/Commands.h"

#include "device/Check.h"

namespace limn::vulkan
{

Commands::Commands(const VulkanContext& context) : m_Device(context.device())
{
    VkCommandPoolCreateInfo poolInfo{};
    poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    poolInfo.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    poolInfo.queueFamilyIndex = context.queueFamily();
    VkCommandPool pool = VK_NULL_HANDLE;
    Check(vkCreateCommandPool(m_Device, &poolInfo, nullptr, &pool), "vkCreateCommandPool");
    m_Pool = UniqueCommandPool{m_Device, pool};

    VkCommandBufferAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    Check(vkAllocateCommandBuffers(m_Device, &info, &m_Handle), "vkAllocateCommandBuffers");
}

void Commands::Begin(VkCommandBufferUsageFlags usage)
{
    Check(vkResetCommandPool(m_Device, m_Pool.get(), 0), "vkResetCommandPool");
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = usage;
    Check(vkBeginCommandBuffer(m_Handle, &info), "vkBeginCommandBuffer");
}

void Commands::End()
{
    Check(vkEndCommandBuffer(m_Handle), "vkEndCommandBuffer");
}

void RecordBarrier(VkCommandBuffer commands, const VkMemoryBarrier2& barrier)
{
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &info);
}

} // namespace limn::vulkan

#include "device/Commands.h"

#include "device/Check.h"

namespace limn::vulkan
{

Commands::Commands(const VulkanContext& context) : m_Device(context.device())
{
    auto poolInfo = Make<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    poolInfo.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    poolInfo.queueFamilyIndex = context.queueFamily();
    m_Pool = UniqueCommandPool{m_Device, vkCreateCommandPool, poolInfo, "vkCreateCommandPool"};

    auto info = Make<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    info.commandPool = m_Pool.get();
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    Check(vkAllocateCommandBuffers(m_Device, &info, &m_Handle), "vkAllocateCommandBuffers");
}

void Commands::Begin(VkCommandBufferUsageFlags usage)
{
    Check(vkResetCommandPool(m_Device, m_Pool.get(), 0), "vkResetCommandPool");
    auto info = Make<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    info.flags = usage;
    Check(vkBeginCommandBuffer(m_Handle, &info), "vkBeginCommandBuffer");
}

void Commands::End()
{
    Check(vkEndCommandBuffer(m_Handle), "vkEndCommandBuffer");
}

void RecordBarriers(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier2> images,
                    std::span<const VkMemoryBarrier2> memory)
{
    if (images.empty() && memory.empty())
    {
        return;
    }
    auto info = Make<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    info.imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size());
    info.pImageMemoryBarriers = images.data();
    info.memoryBarrierCount = static_cast<std::uint32_t>(memory.size());
    info.pMemoryBarriers = memory.data();
    vkCmdPipelineBarrier2(commands, &info);
}

void RecordBarrier(VkCommandBuffer commands, const UsageScope& from, const UsageScope& to)
{
    const VkMemoryBarrier2 barrier = MemoryBarrier(from, to);
    RecordBarriers(commands, {}, {&barrier, 1});
}

} // namespace limn::vulkan

#include "frame/FrameSlot.h"

#include "device/Check.h"
#include "device/Translate.h"
#include <algorithm>

namespace limn::vulkan
{

FrameSlot::FrameSlot(const VulkanContext& context, MemoryAllocator& allocator)
    : m_Context(context), m_Upload(context.device(), allocator), m_Descriptors(context.device())
{
    VkCommandPoolCreateInfo poolInfo{};
    poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    poolInfo.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    poolInfo.queueFamilyIndex = context.queueFamily();
    VkCommandPool pool = VK_NULL_HANDLE;
    Check(vkCreateCommandPool(context.device(), &poolInfo, nullptr, &pool), "vkCreateCommandPool");
    m_Pool = UniqueCommandPool{context.device(), pool};

    VkCommandBufferAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    Check(vkAllocateCommandBuffers(context.device(), &info, &m_Commands),
          "vkAllocateCommandBuffers");
}

void FrameSlot::Begin(std::size_t passCount, std::uint64_t destroyed)
{
    m_TimedCount = 0;
    Check(vkResetCommandPool(m_Context.device(), m_Pool.get(), 0), "vkResetCommandPool");
    m_Upload.Reset();
    m_Descriptors.Begin(destroyed);
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    Check(vkBeginCommandBuffer(m_Commands, &info), "vkBeginCommandBuffer");
    ReserveQueries(passCount);
}

void FrameSlot::Submit(SubmitQueue& queue)
{
    Check(vkEndCommandBuffer(m_Commands), "vkEndCommandBuffer");
    const std::uint64_t number = queue.nextNumber();
    queue.Submit(m_Commands);
    m_Number = number;
}

void FrameSlot::ReserveQueries(std::size_t passCount)
{
    if (m_Context.capabilities().timestampValidBits == 0 || passCount == 0)
    {
        return; // nothing can be, or nothing is to be measured
    }
    const auto needed = static_cast<std::uint32_t>(2 * passCount);
    if (needed > m_QueryCapacity)
    {
        VkQueryPoolCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = std::max(needed, 64U);
        VkQueryPool pool = VK_NULL_HANDLE;
        Check(vkCreateQueryPool(m_Context.device(), &info, nullptr, &pool), "vkCreateQueryPool");
        m_Queries = UniqueQueryPool{m_Context.device(), pool};
        m_QueryCapacity = info.queryCount;
    }
    vkCmdResetQueryPool(m_Commands, m_Queries.get(), 0, needed);
}

void FrameSlot::BeginTiming(const std::string& name)
{
    if (m_Context.capabilities().timestampValidBits > 0)
    {
        const auto query = static_cast<std::uint32_t>(2 * m_TimedCount);
        if (m_TimedPasses.size() == m_TimedCount)
        {
            m_TimedPasses.emplace_back();
        }
        m_TimedPasses[m_TimedCount++] = name; // keeps the memory of the frames before
        vkCmdWriteTimestamp2(m_Commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, m_Queries.get(),
                             query);
    }
}

void FrameSlot::EndTiming()
{
    if (m_Context.capabilities().timestampValidBits > 0)
    {
        const auto query = static_cast<std::uint32_t>(2 * m_TimedCount - 1);
        vkCmdWriteTimestamp2(m_Commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, m_Queries.get(),
                             query);
    }
}

std::vector<PassTiming> FrameSlot::ReadTimings() const
{
    std::vector<PassTiming> timings;
    if (m_TimedCount == 0)
    {
        return timings;
    }
    std::vector<std::uint64_t> ticks(2 * m_TimedCount);
    Check(vkGetQueryPoolResults(m_Context.device(), m_Queries.get(), 0,
                                static_cast<std::uint32_t>(ticks.size()),
                                ticks.size() * sizeof(std::uint64_t), ticks.data(),
                                sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT),
          "vkGetQueryPoolResults");
    const auto milliseconds = [&](std::size_t from, std::size_t to)
    {
        const std::uint64_t elapsed =
            ElapsedTicks(ticks[from], ticks[to], m_Context.capabilities().timestampValidBits);
        return static_cast<double>(elapsed) * m_Context.capabilities().nanosecondsPerTick * 1e-6;
    };
    for (std::size_t i = 0; i < m_TimedCount; ++i)
    {
        timings.push_back(
            {m_TimedPasses[i], milliseconds(2 * i, 2 * i + 1), milliseconds(0, 2 * i)});
    }
    return timings;
}

} // namespace limn::vulkan

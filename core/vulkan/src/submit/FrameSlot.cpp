#include "submit/FrameSlot.h"

#include "device/Check.h"
#include "device/Translate.h"
#include <algorithm>

namespace limn::vulkan
{

void FrameRecording::Take(DeviceResources& resources, std::uint64_t number)
{
    changes = resources.changeCount();
    images.clear();
    resources.images.ForEachUsed(number,
                                 [&](PooledImage& image) {
                                     images.push_back({&image, image.submitted, image.use});
                                 });
    buffers.clear();
    resources.buffers.AddUsed(number, buffers);
    uses.clear();
    resources.meshes.AddUses(number, uses);
    resources.programs.AddUses(number, uses);
    resources.samplers.AddUses(number, uses);
}

bool FrameRecording::isValid(const CompiledFrame& frame, std::uint64_t changeCount) const
{
    return structure != 0 && structure == frame.structure && changes == changeCount && data &&
           data->Fits(frame) &&
           (objects == VK_NULL_HANDLE ||
            (frame.objects && frame.objects->count() == objectCount)) &&
           std::ranges::all_of(images, [](const UsedImage& used)
                               { return used.image->submitted == used.before; });
}

void FrameRecording::Use(std::uint64_t number) const
{
    for (const UsedImage& used : images)
    {
        used.image->lastUse = number;
        used.image->use = used.after;
    }
    for (std::uint64_t* use : uses)
    {
        *use = number;
    }
}

FrameSlot::FrameSlot(const VulkanContext& context, MemoryAllocator& allocator)
    : m_Context(context),
      m_Commands(context),
      m_Data(context.device(), allocator, MemoryUse::Upload),
      m_Uploads(context, allocator),
      m_Descriptors(context.device())
{
}

void FrameSlot::BeginRecording(std::size_t passCount, std::uint64_t structure)
{
    Abandon();
    m_Data.Reset();
    // A structure of 0 does not come again, so its commands are recorded for one submission.
    m_Commands.Begin(structure == 0 ? VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT : 0);
    m_Recording.structure = structure;
    ReserveQueries(passCount);
}

void FrameSlot::Abandon() noexcept
{
    m_TimedCount = 0;
    m_Recording.structure = 0;
}

void FrameSlot::Submit(SubmitQueue& queue)
{
    const std::uint64_t number = queue.nextNumber();
    queue.Submit(m_Uploads.End(), m_Commands.handle());
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
        auto info = Make<VkQueryPoolCreateInfo>(VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO);
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = std::max(needed, 64U);
        m_Queries =
            UniqueQueryPool{m_Context.device(), vkCreateQueryPool, info, "vkCreateQueryPool"};
        m_QueryCapacity = info.queryCount;
    }
    vkCmdResetQueryPool(commands(), m_Queries.get(), 0, needed);
}

void FrameSlot::BeginTiming(const CompiledRenderPass& pass)
{
    if (m_Context.capabilities().timestampValidBits > 0)
    {
        const auto query = static_cast<std::uint32_t>(2 * m_TimedCount);
        if (m_TimedPasses.size() == m_TimedCount)
        {
            m_TimedPasses.emplace_back();
        }
        pass.WriteTitle(m_TimedPasses[m_TimedCount++]);
        vkCmdWriteTimestamp2(commands(), VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, m_Queries.get(),
                             query);
    }
}

void FrameSlot::EndTiming()
{
    if (m_Context.capabilities().timestampValidBits > 0)
    {
        const auto query = static_cast<std::uint32_t>(2 * m_TimedCount - 1);
        vkCmdWriteTimestamp2(commands(), VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, m_Queries.get(),
                             query);
    }
}

void FrameSlot::ReadTimings(std::vector<PassTiming>& timings)
{
    timings.resize(m_TimedCount);
    if (m_TimedCount == 0)
    {
        return;
    }
    m_Ticks.resize(2 * m_TimedCount);
    Check(vkGetQueryPoolResults(
              m_Context.device(), m_Queries.get(), 0, static_cast<std::uint32_t>(m_Ticks.size()),
              m_Ticks.size() * sizeof(std::uint64_t), m_Ticks.data(), sizeof(std::uint64_t),
              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "vkGetQueryPoolResults");
    const auto milliseconds = [&](std::size_t from, std::size_t to)
    {
        const std::uint64_t elapsed =
            ElapsedTicks(m_Ticks[from], m_Ticks[to], m_Context.capabilities().timestampValidBits);
        return static_cast<double>(elapsed) *
               static_cast<double>(m_Context.capabilities().limits.timestampPeriod) * 1e-6;
    };
    for (std::size_t i = 0; i < m_TimedCount; ++i)
    {
        timings[i].name = m_TimedPasses[i];
        timings[i].milliseconds = milliseconds(2 * i, 2 * i + 1);
        timings[i].start = milliseconds(0, 2 * i);
    }
}

FrameSlots::FrameSlots(const VulkanContext& context, MemoryAllocator& allocator)
    : m_Context(context), m_Allocator(allocator)
{
    Add();
    Add();
}

std::uint64_t FrameSlots::beforeLast() const
{
    std::uint64_t last = 0;
    std::uint64_t before = 0;
    for (const FrameSlot& slot : m_Slots)
    {
        before = std::max(before, std::min(last, slot.number()));
        last = std::max(last, slot.number());
    }
    return before;
}

FrameSlot& FrameSlots::Take(std::uint64_t structure)
{
    constexpr std::size_t k_Most = 4;
    const std::uint64_t before = beforeLast();
    // First what has nothing to lose, last used so that its descriptor sets fit; then the oldest.
    const auto isBetter = [](const FrameSlot& a, const FrameSlot& b)
    {
        const bool hasNothing = a.recording().structure == 0;
        return hasNothing != (b.recording().structure == 0) ? hasNothing
               : hasNothing                                 ? a.number() > b.number()
                                                            : a.number() < b.number();
    };
    FrameSlot* best = nullptr;
    for (FrameSlot& slot : m_Slots)
    {
        if (slot.number() > before)
        {
            continue; // the GPU may not be done with it
        }
        if (structure != 0 && slot.recording().structure == structure)
        {
            return slot;
        }
        best = best == nullptr || isBetter(slot, *best) ? &slot : best;
    }
    const std::uint64_t given = best->recording().structure;
    if (given != 0)
    {
        if (m_Slots.size() < k_Most && structure != 0 &&
            std::ranges::find(m_Given, structure) != m_Given.end())
        {
            return Add();
        }
        m_Given.at(m_NextGiven++ % m_Given.size()) = given;
    }
    return *best;
}

} // namespace limn::vulkan

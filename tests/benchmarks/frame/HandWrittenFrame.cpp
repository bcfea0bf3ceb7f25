#include "frame/HandWrittenFrame.h"

#include "device/Check.h"
#include "device/Translate.h"
#include <array>
#include <cstring>
#include <limits>

namespace limn::benchmarks
{

namespace
{

constexpr VkImageLayout k_ColorLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
constexpr VkImageLayout k_DepthLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
constexpr VkImageLayout k_ReadLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
constexpr VkPipelineStageFlags2 k_ColorStage = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags2 k_FragmentStage = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr VkAccessFlags2 k_ColorWrite = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 k_Sampled = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
constexpr std::uint32_t k_Passes = 4;

struct Use
{
    VkImageLayout layout;
    VkPipelineStageFlags2 stages;
    VkAccessFlags2 access;
};

/// What was in it does not matter; whoever read it before is waited for.
constexpr Use After(VkPipelineStageFlags2 stages, VkAccessFlags2 access = 0)
{
    return {VK_IMAGE_LAYOUT_UNDEFINED, stages, access};
}
constexpr Use k_AsColor{k_ColorLayout, k_ColorStage, k_ColorWrite};
constexpr Use k_AsTexture{k_ReadLayout, k_FragmentStage, k_Sampled};
constexpr Use k_AsCopySource{VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_COPY_BIT,
                             VK_ACCESS_2_TRANSFER_READ_BIT};

VkImageMemoryBarrier2 Barrier(VkImage image, const Use& before, const Use& after,
                              VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT)
{
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.srcStageMask = before.stages;
    barrier.srcAccessMask = before.access;
    barrier.dstStageMask = after.stages;
    barrier.dstAccessMask = after.access;
    barrier.oldLayout = before.layout;
    barrier.newLayout = after.layout;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {aspect, 0, 1, 0, 1};
    return barrier;
}

void RecordBarriers(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier2> barriers)
{
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.imageMemoryBarrierCount = static_cast<std::uint32_t>(barriers.size());
    info.pImageMemoryBarriers = barriers.data();
    vkCmdPipelineBarrier2(commands, &info);
}

VkRenderingAttachmentInfo Attachment(VkImageView view, VkImageLayout layout,
                                     VkAttachmentLoadOp load, VkAttachmentStoreOp store)
{
    VkRenderingAttachmentInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    info.imageView = view;
    info.imageLayout = layout;
    info.loadOp = load;
    info.storeOp = store;
    return info;
}

void BeginRendering(VkCommandBuffer commands, VkExtent2D extent,
                    const VkRenderingAttachmentInfo& color, const VkRenderingAttachmentInfo* depth)
{
    VkRenderingInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    info.renderArea.extent = extent;
    info.layerCount = 1;
    info.colorAttachmentCount = 1;
    info.pColorAttachments = &color;
    info.pDepthAttachment = depth;
    vkCmdBeginRendering(commands, &info);
}

/// Times what is recorded as long as it lives.
class TimedPass
{
public:
    TimedPass(VkCommandBuffer commands, VkQueryPool queries, std::uint32_t pass)
        : m_Commands(commands), m_Queries(queries), m_Pass(pass)
    {
        Write(0);
    }
    ~TimedPass() { Write(1); }
    TimedPass(const TimedPass&) = delete;
    TimedPass& operator=(const TimedPass&) = delete;

private:
    void Write(std::uint32_t end) const
    {
        vkCmdWriteTimestamp2(m_Commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, m_Queries,
                             2 * m_Pass + end);
    }

    VkCommandBuffer m_Commands;
    VkQueryPool m_Queries;
    std::uint32_t m_Pass;
};

void BindSet(VkCommandBuffer commands, VkPipelineLayout layout, VkDescriptorSet set)
{
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1, &set, 0,
                            nullptr);
}

} // namespace

void HandWrittenFrame::Draw()
{
    Slot& slot = m_Slots[m_Submitted % m_Slots.size()];
    WaitFor(slot.number);
    m_Scene.Update();
    WriteData(slot);
    if (slot.groups != m_Scene.groups())
    {
        slot.groups = m_Scene.groups();
        Record(slot);
    }
    VkCommandBufferSubmitInfo buffer{};
    buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    buffer.commandBuffer = slot.commands;
    VkSemaphoreSubmitInfo signal{};
    signal.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
    signal.semaphore = m_Timeline.get();
    signal.value = m_Submitted + 1;
    signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkSubmitInfo2 info{};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    info.commandBufferInfoCount = 1;
    info.pCommandBufferInfos = &buffer;
    info.signalSemaphoreInfoCount = 1;
    info.pSignalSemaphoreInfos = &signal;
    vulkan::Check(vkQueueSubmit2(m_Context.queue(), 1, &info, VK_NULL_HANDLE), "vkQueueSubmit2");
    slot.number = ++m_Submitted;
}

void HandWrittenFrame::WriteData(Slot& slot)
{
    std::byte* data = slot.data.memory.mapped();
    const std::vector<std::byte>& uniforms =
        m_Scene.isCameraMoved() ? m_Numbers.uniformsOfMovedCamera : m_Numbers.uniforms;
    std::memcpy(data, uniforms.data(), uniforms.size());
    m_Scene.WriteObjects(
        {reinterpret_cast<PerDrawData*>(data + ObjectsOffset(m_Numbers)), m_Numbers.objects.size()},
        slot.version);
    slot.version = m_Scene.version();
    const std::vector<std::uint32_t>& instances = m_Scene.instances();
    std::memcpy(data + InstancesOffset(m_Numbers), instances.data(),
                instances.size() * sizeof(std::uint32_t));
}

void HandWrittenFrame::Record(const Slot& slot)
{
    VkCommandBuffer commands = slot.commands;
    vulkan::Check(vkResetCommandPool(m_Context.device(), slot.pool.get(), 0), "vkResetCommandPool");
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    vulkan::Check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    vkCmdResetQueryPool(commands, slot.queries.get(), 0, 2 * k_Passes);
    RecordMask(slot);
    RecordEdge(slot);
    RecordObjects(slot);
    RecordFinal(slot);
    vulkan::Check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
}

void HandWrittenFrame::RecordMask(const Slot& slot) const
{
    const TimedPass timed(slot.commands, slot.queries.get(), 0);
    RecordBarriers(slot.commands,
                   std::array{Barrier(m_Mask.image.get(), After(k_FragmentStage), k_AsColor)});
    BeginRendering(slot.commands, m_Mask.extent,
                   Attachment(m_Mask.view.get(), k_ColorLayout, VK_ATTACHMENT_LOAD_OP_CLEAR,
                              VK_ATTACHMENT_STORE_OP_STORE),
                   nullptr);
    BindMeshes(slot.commands, m_MaskStage);
    BindSet(slot.commands, m_MaskStage.layout.get(), slot.mask);
    for (const ArticleGroup& group : m_Scene.groups())
    {
        if (group.outlined > 0)
        {
            DrawMesh(slot.commands, group, group.outlined);
        }
    }
    vkCmdEndRendering(slot.commands);
}

void HandWrittenFrame::RecordEdge(const Slot& slot) const
{
    const TimedPass timed(slot.commands, slot.queries.get(), 1);
    RecordBarriers(slot.commands,
                   std::array{Barrier(m_Mask.image.get(), k_AsColor, k_AsTexture),
                              Barrier(m_Edge.image.get(), After(k_FragmentStage), k_AsColor)});
    BeginRendering(slot.commands, m_Edge.extent,
                   Attachment(m_Edge.view.get(), k_ColorLayout, VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                              VK_ATTACHMENT_STORE_OP_STORE),
                   nullptr);
    vkCmdBindPipeline(slot.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, m_EdgeStage.pipeline.get());
    BindSet(slot.commands, m_EdgeStage.layout.get(), slot.edge);
    vkCmdDraw(slot.commands, 3, 1, 0, 0);
    vkCmdEndRendering(slot.commands);
}

void HandWrittenFrame::RecordObjects(const Slot& slot) const
{
    const TimedPass timed(slot.commands, slot.queries.get(), 2);
    constexpr VkPipelineStageFlags2 depthStages =
        VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
    constexpr VkAccessFlags2 depthWrite = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    RecordBarriers(slot.commands,
                   std::array{Barrier(m_Edge.image.get(), k_AsColor, k_AsTexture),
                              Barrier(m_Color.image.get(), After(k_FragmentStage), k_AsColor),
                              Barrier(m_Depth.image.get(), After(depthStages, depthWrite),
                                      {k_DepthLayout, depthStages,
                                       depthWrite | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT},
                                      VK_IMAGE_ASPECT_DEPTH_BIT)});
    VkRenderingAttachmentInfo color =
        Attachment(m_Color.view.get(), k_ColorLayout, VK_ATTACHMENT_LOAD_OP_CLEAR,
                   VK_ATTACHMENT_STORE_OP_STORE);
    const Color& background = m_Numbers.background;
    color.clearValue.color = {{background.r, background.g, background.b, background.a}};
    const VkRenderingAttachmentInfo depth =
        Attachment(m_Depth.view.get(), k_DepthLayout, VK_ATTACHMENT_LOAD_OP_CLEAR,
                   VK_ATTACHMENT_STORE_OP_DONT_CARE); // cleared to 0, which is far
    BeginRendering(slot.commands, m_Color.extent, color, &depth);
    BindMeshes(slot.commands, m_LitStage);
    std::size_t bound = std::numeric_limits<std::size_t>::max();
    for (const ArticleGroup& group : m_Scene.groups())
    {
        if (group.material != bound)
        {
            bound = group.material;
            BindSet(slot.commands, m_LitStage.layout.get(), slot.materials[bound]);
        }
        DrawMesh(slot.commands, group, group.count);
    }
    vkCmdBindPipeline(slot.commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                      m_CompositeStage.pipeline.get());
    BindSet(slot.commands, m_CompositeStage.layout.get(), slot.composite);
    vkCmdDraw(slot.commands, 3, 1, 0, 0);
    vkCmdEndRendering(slot.commands);
}

void HandWrittenFrame::RecordFinal(const Slot& slot) const
{
    {
        const TimedPass timed(slot.commands, slot.queries.get(), 3);
        RecordBarriers(slot.commands,
                       std::array{Barrier(m_Color.image.get(), k_AsColor, k_AsTexture),
                                  Barrier(m_Output.image.get(), After(VK_PIPELINE_STAGE_2_COPY_BIT),
                                          k_AsColor)});
        BeginRendering(slot.commands, m_Output.extent,
                       Attachment(m_Output.view.get(), k_ColorLayout,
                                  VK_ATTACHMENT_LOAD_OP_DONT_CARE, VK_ATTACHMENT_STORE_OP_STORE),
                       nullptr);
        vkCmdBindPipeline(slot.commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                          m_FinalStage.pipeline.get());
        BindSet(slot.commands, m_FinalStage.layout.get(), slot.final);
        vkCmdDraw(slot.commands, 3, 1, 0, 0);
        vkCmdEndRendering(slot.commands);
    }
    RecordBarriers(slot.commands,
                   std::array{Barrier(m_Output.image.get(), k_AsColor, k_AsCopySource)});
}

void HandWrittenFrame::BindMeshes(VkCommandBuffer commands, const Stage& stage) const
{
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, stage.pipeline.get());
    const auto count = static_cast<std::uint32_t>(m_Arrays.size());
    const std::vector<VkBuffer> buffers(count, m_Meshes.handle.get());
    vkCmdBindVertexBuffers(commands, 0, count, buffers.data(), m_Arrays.data());
    vkCmdBindIndexBuffer(commands, m_Meshes.handle.get(), m_Indices, VK_INDEX_TYPE_UINT32);
}

void HandWrittenFrame::DrawMesh(VkCommandBuffer commands, const ArticleGroup& group,
                                std::uint32_t count) const
{
    const PlacedMesh& mesh = m_PlacedMeshes.at(group.mesh->id());
    vkCmdDrawIndexed(commands, mesh.indexCount, count, mesh.index, mesh.vertex, group.first);
}

void HandWrittenFrame::Wait()
{
    WaitFor(m_Submitted);
}

void HandWrittenFrame::WaitFor(std::uint64_t number) const
{
    const VkSemaphore semaphore = m_Timeline.get();
    VkSemaphoreWaitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO;
    info.semaphoreCount = 1;
    info.pSemaphores = &semaphore;
    info.pValues = &number;
    vulkan::Check(
        vkWaitSemaphores(m_Context.device(), &info, std::numeric_limits<std::uint64_t>::max()),
        "vkWaitSemaphores");
}

double HandWrittenFrame::DeviceMilliseconds() const
{
    const Slot& last = m_Slots[(m_Submitted - 1) % m_Slots.size()];
    std::array<std::uint64_t, std::size_t{2} * k_Passes> ticks{};
    vulkan::Check(vkGetQueryPoolResults(m_Context.device(), last.queries.get(), 0, ticks.size(),
                                        sizeof(ticks), ticks.data(), sizeof(ticks[0]),
                                        VK_QUERY_RESULT_64_BIT),
                  "vkGetQueryPoolResults");
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < ticks.size(); i += 2)
    {
        sum += vulkan::ElapsedTicks(ticks[i], ticks[i + 1],
                                    m_Context.capabilities().timestampValidBits);
    }
    return static_cast<double>(sum) *
           static_cast<double>(m_Context.capabilities().limits.timestampPeriod) * 1e-6;
}

std::size_t HandWrittenFrame::drawCount() const
{
    std::size_t count = m_Scene.groups().size() + 3;
    for (const ArticleGroup& group : m_Scene.groups())
    {
        count += group.outlined > 0 ? 1 : 0;
    }
    return count;
}

} // namespace limn::benchmarks

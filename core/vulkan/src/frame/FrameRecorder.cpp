#include "frame/FrameRecorder.h"

#include "device/Translate.h"
#include "frame/BoundState.h"
#include "frame/PassTargets.h"

namespace limn::vulkan
{

namespace
{

/// Returns the fault of a barrier, "" if it has none.
std::string Objection(const TextureBarrier& barrier, const PooledImage& image)
{
    if (barrier.after == TextureUsage::Undefined)
    {
        return "a barrier cannot end in Undefined";
    }
    if (!image.isRenderTexture)
    {
        return "it comes from the CPU and is ShaderRead always; it needs no barrier";
    }
    if (barrier.before != TextureUsage::Undefined && barrier.before != image.use.usage)
    {
        return std::string("the barrier takes it from ") + ToString(barrier.before) +
               ", and its use is " + ToString(image.use.usage);
    }
    return {};
}

/// @param pass  before which the barrier stands; null = at the end of the frame
void RequireBarrierFits(const TextureBarrier& barrier, const PooledImage& image,
                        const CompiledRenderPass* pass)
{
    if (const std::string objection = Objection(barrier, image); !objection.empty())
    {
        throw ContractError((pass != nullptr ? "pass '" + pass->name + "'" : "end of frame") +
                            ": texture '" + image.name + "': " + objection);
    }
}

/// Records one pass of a prepared frame.
/// @lifetime all references must live until Record() returns
class PassRecorder
{
public:
    PassRecorder(const VulkanContext& context, ImagePool& images, VkCommandBuffer commands,
                 const CompiledRenderPass& pass, const PreparedPass& prepared,
                 const PreparedFrame& frame, BoundState& bound)
        : m_Context(context),
          m_Images(images),
          m_Commands(commands),
          m_Pass(pass),
          m_Prepared(prepared),
          m_Frame(frame),
          m_Bound(bound),
          m_NextDraw(prepared.firstDraw),
          m_NextDispatch(prepared.firstDispatch)
    {
    }

    void Record()
    {
        if (!m_Pass.name.empty())
        {
            BeginLabel(m_Pass.name);
        }
        if (!m_Pass.isCompute())
        {
            RecordBeginRendering(m_Commands, m_Pass, m_Images, m_Frame.usesReversedZBuffer);
            Run(SetViewportCommand{{0, 0, m_Pass.width, m_Pass.height}});
        }
        for (const PassCommand& command : m_Pass.commands)
        {
            std::visit([this](const auto& alternative) { Run(alternative); }, command);
        }
        // A sample that goes on in the next pass is cut here, so that labels nest.
        while (m_OpenSamples > 0)
        {
            Run(EndSampleCommand{});
        }
        if (!m_Pass.isCompute())
        {
            vkCmdEndRendering(m_Commands);
            GenerateMips();
        }
        const UsageScope written = ToUsageScope(TextureUsage::RandomWrite);
        for (const auto& texture : m_Pass.mips)
        {
            RecordMips(m_Commands, m_Images.Find(*texture)->read().image.get(), *texture, written,
                       written);
        }
        if (!m_Pass.name.empty())
        {
            EndLabel();
        }
    }

private:
    void GenerateMips() const
    {
        const UsageScope drawn = ToUsageScope(TextureUsage::ColorAttachment);
        for (const ColorAttachment& color : m_Pass.colors)
        {
            if (color.generatesMips)
            {
                const RenderTexture& texture = color.resolve ? *color.resolve : *color.texture;
                RecordMips(m_Commands, m_Images.Find(texture)->read().image.get(), texture, drawn,
                           drawn);
            }
        }
    }

    void Run(const ClearCommand& clear)
    {
        std::vector<VkClearAttachment> attachments;
        if (clear.flags & ClearFlag::Color)
        {
            for (std::uint32_t i = 0; i < m_Prepared.formats.colors.size(); ++i)
            {
                VkClearAttachment color{VK_IMAGE_ASPECT_COLOR_BIT, i, {}};
                color.clearValue.color =
                    ColorClearValue(clear.color, m_Pass.colors[i].texture->graphicsFormat());
                attachments.push_back(color);
            }
        }
        VkImageAspectFlags aspects = 0;
        if ((clear.flags & ClearFlag::Depth) && m_Prepared.formats.depth != VK_FORMAT_UNDEFINED)
        {
            aspects |= VK_IMAGE_ASPECT_DEPTH_BIT;
        }
        if ((clear.flags & ClearFlag::Stencil) && m_Prepared.formats.stencil != VK_FORMAT_UNDEFINED)
        {
            aspects |= VK_IMAGE_ASPECT_STENCIL_BIT;
        }
        if (aspects != 0)
        {
            attachments.push_back(
                {aspects, 0,
                 DepthClearValue(clear.depth, clear.stencil, m_Frame.usesReversedZBuffer)});
        }
        const bool empty = m_Scissor.extent.width == 0 || m_Scissor.extent.height == 0;
        if (attachments.empty() || empty)
        {
            return; // Vulkan forbids a clear of nothing
        }
        const VkClearRect rect{m_Scissor, 0, 1};
        vkCmdClearAttachments(m_Commands, static_cast<std::uint32_t>(attachments.size()),
                              attachments.data(), 1, &rect);
    }

    void Run(const SetViewportCommand& viewport)
    {
        m_Scissor = ClipTo(AreaOf(m_Pass), viewport.rect);
        m_Bound.SetViewport(ToVkViewport(viewport.rect));
    }

    void Run(const DrawCommand& draw)
    {
        const PreparedDraw& prepared = m_Frame.draws[m_NextDraw++];
        m_Bound.SetScissor(draw.scissor ? ClipTo(m_Scissor, *draw.scissor) : m_Scissor);
        m_Bound.BindPipeline(prepared, m_Frame.states[prepared.state]);
        m_Bound.BindMesh(prepared);
        for (std::size_t i = 0; i < prepared.runCount; ++i)
        {
            const PreparedRun& run = m_Frame.runs[prepared.firstRun + i];
            m_Bound.BindRun(prepared, run);
            if (prepared.arguments.buffer != VK_NULL_HANDLE)
            {
                DrawIndirect(prepared);
            }
            else if (prepared.mesh == nullptr)
            {
                vkCmdDraw(m_Commands, draw.vertexCount, run.instances.count, 0,
                          run.instances.first);
            }
            else
            {
                vkCmdDrawIndexed(m_Commands, prepared.indices.indexCount, run.instances.count,
                                 prepared.mesh->range.firstIndex + prepared.indices.indexStart,
                                 m_Bound.VertexOffset(prepared), run.instances.first);
            }
        }
    }

    void DrawIndirect(const PreparedDraw& draw) const
    {
        const auto& [buffer, offset] = draw.arguments;
        if (draw.mesh == nullptr)
        {
            vkCmdDrawIndirect(m_Commands, buffer, offset, 1, 0);
        }
        else
        {
            vkCmdDrawIndexedIndirect(m_Commands, buffer, offset, 1, 0);
        }
    }

    void Run(const DispatchCommand& dispatch)
    {
        const PreparedDispatch& prepared = m_Frame.dispatches[m_NextDispatch++];
        vkCmdBindPipeline(m_Commands, VK_PIPELINE_BIND_POINT_COMPUTE, prepared.pipeline);
        if (prepared.set != VK_NULL_HANDLE)
        {
            vkCmdBindDescriptorSets(m_Commands, VK_PIPELINE_BIND_POINT_COMPUTE, prepared.layout, 0,
                                    1, &prepared.set, 0, nullptr);
        }
        if (prepared.arguments.buffer != VK_NULL_HANDLE)
        {
            vkCmdDispatchIndirect(m_Commands, prepared.arguments.buffer, prepared.arguments.offset);
            return;
        }
        vkCmdDispatch(m_Commands, dispatch.groups[0], dispatch.groups[1], dispatch.groups[2]);
    }

    void Run(const BeginSampleCommand& sample)
    {
        BeginLabel(sample.name.name());
        ++m_OpenSamples;
    }

    void Run(const EndSampleCommand&)
    {
        if (m_OpenSamples > 0) // else it began in an earlier pass, which has closed it
        {
            EndLabel();
            --m_OpenSamples;
        }
    }

    void BeginLabel(const std::string& name)
    {
        if (m_Context.functions().beginLabel != nullptr)
        {
            auto label = Make<VkDebugUtilsLabelEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT);
            label.pLabelName = name.c_str();
            m_Context.functions().beginLabel(m_Commands, &label);
        }
    }

    void EndLabel()
    {
        if (m_Context.functions().endLabel != nullptr)
        {
            m_Context.functions().endLabel(m_Commands);
        }
    }

    const VulkanContext& m_Context;
    ImagePool& m_Images;
    VkCommandBuffer m_Commands;
    const CompiledRenderPass& m_Pass;
    const PreparedPass& m_Prepared;
    const PreparedFrame& m_Frame;
    BoundState& m_Bound;
    std::size_t m_NextDraw;
    std::size_t m_NextDispatch;
    VkRect2D m_Scissor{}; ///< the scissor of the viewport
    int m_OpenSamples = 0;
};

} // namespace

FrameRecorder::FrameRecorder(const VulkanContext& context, DeviceResources& resources,
                             FrameSlot& slot, std::uint64_t number, PreparedFrame& prepared)
    : m_Context(context),
      m_Resources(resources),
      m_Slot(slot),
      m_Number(number),
      m_Prepared(prepared)
{
}

void FrameRecorder::Record(const CompiledFrame& frame)
{
    m_Resources.images.RecordUploads(m_Slot.uploads());
    m_Resources.meshes.RecordUploads(m_Slot.uploads());
    RecordPasses(frame);
    m_Slot.EndRecording();
}

bool FrameRecorder::Prepare(const CompiledFrame& frame)
{
    if (Repeat(frame))
    {
        return true;
    }
    m_Slot.BeginRecording(frame.passes.size(), frame.structure);
    m_Slot.descriptors().Begin(m_Resources.changeCount());
    m_Prepared.Clear();
    m_Prepared.passes.resize(frame.passes.size());
    m_Prepared.usesReversedZBuffer = frame.usesReversedZBuffer;
    m_Resources.images.Place(frame.placed, m_Number);
    FrameDescriptors descriptors{m_Context, m_Resources, m_Slot, frame, m_Prepared.descriptors,
                                 m_Number};
    DrawPreparer draws{m_Context, m_Resources, descriptors, frame, m_Number, m_Prepared};
    for (std::size_t i = 0; i < frame.passes.size(); ++i)
    {
        PreparedPass& pass = m_Prepared.passes[i];
        ForEachAttachment(frame.passes[i],
                          [&](const auto& attachment)
                          {
                              m_Resources.images.Use(attachment.texture, m_Number);
                              if (attachment.resolve)
                              {
                                  m_Resources.images.UseResolved(attachment.resolve, m_Number);
                              }
                          });
        pass.firstBarrier = m_Prepared.barriers.size();
        PrepareBarriers(frame.passes[i].barriers, &frame.passes[i]);
        pass.barrierCount = m_Prepared.barriers.size() - pass.firstBarrier;
        PrepareBufferBarriers(frame.passes[i], pass);
        pass.firstDispatch = m_Prepared.dispatches.size();
        if (frame.passes[i].isCompute())
        {
            PrepareCommands(frame.passes[i], draws);
            continue;
        }
        pass.formats =
            TargetsOf(frame.passes[i], m_Resources.images, m_Context.capabilities().limits);
        pass.firstDraw = m_Prepared.draws.size();
        draws.BeginPass(frame.passes[i], pass.formats);
        PrepareCommands(frame.passes[i], draws);
        MarkSamples(frame.passes[i], m_Resources.images);
    }
    m_Prepared.firstFinalBarrier = m_Prepared.barriers.size();
    PrepareBarriers(frame.finalBarriers, nullptr);
    m_Resources.programs.FinishPipelines();
    m_Slot.recording().Take(m_Resources, m_Number);
    return false;
}

/// Repeats the recording of an earlier frame. If it returns false, nothing but uploads has
/// happened.
bool FrameRecorder::Repeat(const CompiledFrame& frame)
{
    FrameRecording& recording = m_Slot.recording();
    if (!recording.isValid(frame, m_Resources.changeCount()))
    {
        return false;
    }
    if (recording.objects != VK_NULL_HANDLE &&
        m_Resources.objects.Update(frame.objects, m_Number, m_Slot.uploads()) != recording.objects)
    {
        return false;
    }
    for (const auto& buffer : recording.buffers)
    {
        m_Resources.buffers.Use(buffer.lock(), m_Number, m_Slot.uploads());
    }
    recording.data->Write(frame);
    recording.Use(m_Number);
    return true;
}

void FrameRecorder::PrepareCommands(const CompiledRenderPass& pass, DrawPreparer& draws) const
{
    const VkPhysicalDeviceLimits& limits = m_Context.capabilities().limits;
    if (!pass.isCompute())
    {
        RequireViewport({0, 0, pass.width, pass.height}, pass, limits);
    }
    for (const PassCommand& command : pass.commands)
    {
        if (const auto* dispatch = std::get_if<DispatchCommand>(&command))
        {
            draws.Add(*dispatch);
        }
        if (const auto* draw = std::get_if<DrawCommand>(&command))
        {
            draws.Add(*draw);
        }
        else if (const auto* viewport = std::get_if<SetViewportCommand>(&command))
        {
            RequireViewport(viewport->rect, pass, limits);
        }
    }
}

void FrameRecorder::PrepareBufferBarriers(const CompiledRenderPass& pass, PreparedPass& prepared)
{
    prepared.firstMemoryBarrier = m_Prepared.memoryBarriers.size();
    prepared.memoryBarrierCount = pass.bufferBarriers.size();
    for (const BufferBarrier& barrier : pass.bufferBarriers)
    {
        m_Prepared.memoryBarriers.push_back(ToMemoryBarrier(barrier));
    }
}

void FrameRecorder::PrepareBarriers(const std::vector<TextureBarrier>& barriers,
                                    const CompiledRenderPass* pass)
{
    for (const TextureBarrier& barrier : barriers)
    {
        const bool isRead =
            barrier.after == TextureUsage::ShaderRead || barrier.after == TextureUsage::CopySource;
        PooledImage& image = isRead ? m_Resources.images.UseResolved(barrier.texture, m_Number)
                                    : m_Resources.images.Use(barrier.texture, m_Number);
        RequireBarrierFits(barrier, image, pass);
        ChangeUsage(image, barrier, m_Prepared.barriers);
    }
}

void FrameRecorder::RecordPasses(const CompiledFrame& frame) const
{
    VkCommandBuffer commands = m_Slot.commands();
    const std::span<const VkImageMemoryBarrier2> barriers{m_Prepared.barriers};
    const std::span<const VkMemoryBarrier2> memory{m_Prepared.memoryBarriers};
    BoundState bound{commands, m_Context.functions(), m_Resources.meshes.constants()};
    for (std::size_t i = 0; i < frame.passes.size(); ++i)
    {
        const PreparedPass& pass = m_Prepared.passes[i];
        m_Slot.BeginTiming(frame.passes[i]);
        RecordBarriers(commands, barriers.subspan(pass.firstBarrier, pass.barrierCount),
                       memory.subspan(pass.firstMemoryBarrier, pass.memoryBarrierCount));
        PassRecorder{m_Context, m_Resources.images, commands, frame.passes[i],
                     pass,      m_Prepared,         bound}
            .Record();
        m_Slot.EndTiming();
    }
    RecordBarriers(commands, barriers.subspan(m_Prepared.firstFinalBarrier));
}

} // namespace limn::vulkan

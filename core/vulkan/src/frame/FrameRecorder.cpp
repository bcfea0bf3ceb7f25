#include "frame/FrameRecorder.h"

#include "device/Translate.h"
#include "frame/PassRecorder.h"
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
    FrameDescriptors descriptors{m_Context, m_Resources, m_Slot, frame, m_Prepared.descriptors};
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

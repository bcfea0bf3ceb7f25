#include "frame/FrameRecorder.h"

#include "device/Translate.h"
#include "frame/PassRecorder.h"

namespace limn::vulkan
{

namespace
{

void RequireBarrierFits(const TextureBarrier& barrier, const PooledImage& image,
                        const std::string& where)
{
    const std::string subject = where + ": texture '" + image.name + "': ";
    if (barrier.after == TextureUsage::Undefined)
    {
        throw ContractError(subject + "a barrier cannot end in Undefined");
    }
    if (!image.isRenderTexture)
    {
        throw ContractError(subject + "it comes from the CPU and is ShaderRead always; it needs "
                                      "no barrier");
    }
    if (barrier.before != TextureUsage::Undefined && barrier.before != image.usage)
    {
        throw ContractError(subject + "the barrier takes it from " + ToString(barrier.before) +
                            ", and its use is " + ToString(image.usage));
    }
}

std::string PassTitle(const CompiledRenderPass& pass)
{
    return "pass '" + pass.name + "'";
}

} // namespace

FrameRecorder::FrameRecorder(const VulkanContext& context, DeviceResources& resources,
                             FrameSlot& slot, std::uint64_t number)
    : m_Context(context), m_Resources(resources), m_Slot(slot), m_Number(number)
{
}

void FrameRecorder::Record(const CompiledFrame& frame)
{
    Prepare(frame);
    m_Resources.images.RecordUploads(m_Slot.commands(), m_Slot.upload());
    m_Resources.meshes.RecordUploads(m_Slot.commands(), m_Slot.upload());
    VkBuffer objects = VK_NULL_HANDLE;
    if (m_DrawsObjects && frame.objects)
    {
        objects =
            m_Resources.objects.Update(frame.objects, m_Number, m_Slot.commands(), m_Slot.upload());
    }
    FrameDescriptors descriptors{m_Context, m_Resources, m_Slot, frame, objects};
    for (const CompiledRenderPass& pass : frame.passes)
    {
        m_Slot.BeginTiming(pass.name);
        RecordBarrierList(pass.barriers, PassTitle(pass));
        PassRecorder recorder{m_Context,   m_Resources, m_Slot.commands(),
                              descriptors, pass,        m_Number};
        recorder.Record();
        m_Slot.EndTiming();
    }
    RecordBarrierList(frame.finalBarriers, "end of frame");
}

void FrameRecorder::Prepare(const CompiledFrame& frame)
{
    ImagePool& images = m_Resources.images;
    for (const CompiledRenderPass& pass : frame.passes)
    {
        for (const TextureBarrier& barrier : pass.barriers)
        {
            images.Use(barrier.texture, m_Number);
        }
        for (const ColorAttachment& color : pass.colors)
        {
            images.Use(color.texture, m_Number);
            PrepareResolve(color.resolve);
        }
        if (pass.depth)
        {
            images.Use(pass.depth->texture, m_Number);
            PrepareResolve(pass.depth->resolve);
        }
        for (const PassCommand& command : pass.commands)
        {
            if (const auto* draw = std::get_if<DrawCommand>(&command))
            {
                PrepareDraw(*draw);
            }
        }
    }
    for (const TextureBarrier& barrier : frame.finalBarriers)
    {
        images.UseResolved(barrier.texture, m_Number);
    }
}

void FrameRecorder::PrepareDraw(const DrawCommand& draw)
{
    m_DrawsObjects = m_DrawsObjects || draw.drawsObjects;
    if (draw.mesh)
    {
        m_Resources.meshes.Use(draw.mesh, m_Number);
    }
    if (draw.bindings)
    {
        for (const TextureSlot& slot : draw.bindings->textures)
        {
            m_Resources.images.UseResolved(slot.texture, m_Number);
        }
    }
}

void FrameRecorder::PrepareResolve(const std::shared_ptr<const RenderTexture>& target)
{
    if (target)
    {
        m_Resources.images.UseResolved(target, m_Number);
    }
}

void FrameRecorder::RecordBarrierList(const std::vector<TextureBarrier>& barriers,
                                      const std::string& where)
{
    std::vector<VkImageMemoryBarrier2> recorded;
    for (const TextureBarrier& barrier : barriers)
    {
        PooledImage& image = *m_Resources.images.Find(*barrier.texture);
        RequireBarrierFits(barrier, image, where);
        ChangeUsage(image, barrier.before, barrier.after, recorded);
    }
    RecordBarriers(m_Slot.commands(), recorded);
}

} // namespace limn::vulkan

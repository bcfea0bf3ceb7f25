#include "frame/PassRecorder.h"

#include "frame/PassTargets.h"

namespace limn::vulkan
{

PassRecorder::PassRecorder(const VulkanContext& context, ImagePool& images,
                           VkCommandBuffer commands, const CompiledRenderPass& pass,
                           const PreparedPass& prepared, const PreparedFrame& frame,
                           BoundState& bound)
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

void PassRecorder::Record()
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

void PassRecorder::GenerateMips() const
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

void PassRecorder::Run(const ClearCommand& clear)
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
            {aspects, 0, DepthClearValue(clear.depth, clear.stencil, m_Frame.usesReversedZBuffer)});
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

void PassRecorder::Run(const SetViewportCommand& viewport)
{
    m_Scissor = ClipToPass(viewport.rect, m_Pass);
    m_Bound.SetViewport(ToVkViewport(viewport.rect));
}

void PassRecorder::Run(const DrawCommand& draw)
{
    const PreparedDraw& prepared = m_Frame.draws[m_NextDraw++];
    m_Bound.SetScissor(draw.scissor ? Common(ClipToPass(*draw.scissor, m_Pass), m_Scissor)
                                    : m_Scissor);
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
            vkCmdDraw(m_Commands, draw.vertexCount, run.instances.count, 0, run.instances.first);
        }
        else
        {
            vkCmdDrawIndexed(m_Commands, prepared.indices.indexCount, run.instances.count,
                             prepared.mesh->range.firstIndex + prepared.indices.indexStart,
                             m_Bound.VertexOffset(prepared), run.instances.first);
        }
    }
}

void PassRecorder::DrawIndirect(const PreparedDraw& draw) const
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

void PassRecorder::Run(const DispatchCommand& dispatch)
{
    const PreparedDispatch& prepared = m_Frame.dispatches[m_NextDispatch++];
    vkCmdBindPipeline(m_Commands, VK_PIPELINE_BIND_POINT_COMPUTE, prepared.pipeline);
    if (prepared.set != VK_NULL_HANDLE)
    {
        vkCmdBindDescriptorSets(m_Commands, VK_PIPELINE_BIND_POINT_COMPUTE, prepared.layout, 0, 1,
                                &prepared.set, 0, nullptr);
    }
    if (prepared.arguments.buffer != VK_NULL_HANDLE)
    {
        vkCmdDispatchIndirect(m_Commands, prepared.arguments.buffer, prepared.arguments.offset);
        return;
    }
    vkCmdDispatch(m_Commands, dispatch.groups[0], dispatch.groups[1], dispatch.groups[2]);
}

void PassRecorder::Run(const BeginSampleCommand& sample)
{
    BeginLabel(sample.name.name());
    ++m_OpenSamples;
}

void PassRecorder::Run(const EndSampleCommand&)
{
    if (m_OpenSamples > 0) // else it began in an earlier pass, which has closed it
    {
        EndLabel();
        --m_OpenSamples;
    }
}

void PassRecorder::BeginLabel(const std::string& name)
{
    if (m_Context.functions().beginLabel != nullptr)
    {
        VkDebugUtilsLabelEXT label{};
        label.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT;
        label.pLabelName = name.c_str();
        m_Context.functions().beginLabel(m_Commands, &label);
    }
}

void PassRecorder::EndLabel()
{
    if (m_Context.functions().endLabel != nullptr)
    {
        m_Context.functions().endLabel(m_Commands);
    }
}

} // namespace limn::vulkan

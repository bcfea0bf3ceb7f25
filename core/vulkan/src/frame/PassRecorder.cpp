#include "frame/PassRecorder.h"

#include "frame/PassTargets.h"

#include <limn/core/DrawError.h>
#include <limn/core/Shader.h>

namespace limn::vulkan
{

namespace
{

/// The sub-mesh's run of indices.
SubMesh IndicesOf(const DrawCommand& draw)
{
    if (draw.subMesh < 0 || draw.subMesh >= draw.mesh->subMeshCount())
    {
        throw ContractError("a draw asks for sub-mesh " + std::to_string(draw.subMesh) +
                            " of mesh '" + draw.mesh->name() + "', which has " +
                            std::to_string(draw.mesh->subMeshCount()));
    }
    return draw.mesh->subMesh(draw.subMesh);
}

void RequireBuffersFit(const DrawCommand& draw, const VkPhysicalDeviceLimits& limits)
{
    for (const UniformBuffer& buffer : draw.program->layout.buffers)
    {
        if (buffer.size > limits.maxUniformBufferRange)
        {
            throw DrawError((draw.shader ? "shader '" + draw.shader->name() + "', pass " +
                                               std::to_string(draw.shaderPass) + ": "
                                         : "") +
                            "constant buffer '" + buffer.name + "' has " +
                            std::to_string(buffer.size) + " bytes; the device binds at most " +
                            std::to_string(limits.maxUniformBufferRange) +
                            ", so make it smaller or use a texture");
        }
    }
}

bool HasBindings(const PropertyLayout& layout)
{
    return !layout.buffers.empty() || !layout.textures.empty() || !layout.samplers.empty() ||
           !layout.storageBuffers.empty();
}

} // namespace

PassRecorder::PassRecorder(const VulkanContext& context, DeviceResources& resources,
                           VkCommandBuffer commands, FrameDescriptors& descriptors,
                           const CompiledRenderPass& pass, std::uint64_t number)
    : m_Context(context),
      m_Resources(resources),
      m_Commands(commands),
      m_Descriptors(descriptors),
      m_Pass(pass),
      m_Number(number),
      m_Formats(TargetsOf(pass, resources.images, context.capabilities().limits))
{
}

void PassRecorder::Record()
{
    if (!m_Pass.name.empty())
    {
        BeginLabel(m_Pass.name);
    }
    RecordBeginRendering(m_Commands, m_Pass, m_Resources.images);
    Run(SetViewportCommand{{0, 0, m_Pass.width, m_Pass.height}});
    for (const PassCommand& command : m_Pass.commands)
    {
        std::visit([this](const auto& alternative) { Run(alternative); }, command);
    }
    // A sample that goes on in the next pass is cut here, so that labels nest.
    while (m_OpenSamples > 0)
    {
        Run(EndSampleCommand{});
    }
    vkCmdEndRendering(m_Commands);
    if (!m_Pass.name.empty())
    {
        EndLabel();
    }
}

void PassRecorder::Run(const ClearCommand& clear)
{
    std::vector<VkClearAttachment> attachments;
    if (clear.flags & ClearFlag::Color)
    {
        for (std::uint32_t i = 0; i < m_Formats.colors.size(); ++i)
        {
            VkClearAttachment color{VK_IMAGE_ASPECT_COLOR_BIT, i, {}};
            color.clearValue.color = {{clear.color.r, clear.color.g, clear.color.b, clear.color.a}};
            attachments.push_back(color);
        }
    }
    VkImageAspectFlags aspects = 0;
    if ((clear.flags & ClearFlag::Depth) && m_Formats.depth != VK_FORMAT_UNDEFINED)
    {
        aspects |= VK_IMAGE_ASPECT_DEPTH_BIT;
    }
    if ((clear.flags & ClearFlag::Stencil) && m_Formats.stencil != VK_FORMAT_UNDEFINED)
    {
        aspects |= VK_IMAGE_ASPECT_STENCIL_BIT;
    }
    if (aspects != 0)
    {
        attachments.push_back({aspects, 0, DepthClearValue(clear.depth, clear.stencil)});
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
    RequireViewport(viewport.rect, m_Pass, m_Context.capabilities().limits);
    m_Scissor = ClipToPass(viewport.rect, m_Pass);
    m_Limit.reset();
    const VkViewport area = ToVkViewport(viewport.rect);
    vkCmdSetViewport(m_Commands, 0, 1, &area);
    vkCmdSetScissor(m_Commands, 0, 1, &m_Scissor);
}

/// @param part  texels of the viewport that are drawn; none = all
void PassRecorder::LimitTo(const std::optional<ViewportRect>& part)
{
    if (part != m_Limit)
    {
        m_Limit = part;
        const VkRect2D rect = part ? ClipToPass(*part, m_Pass) : m_Scissor;
        vkCmdSetScissor(m_Commands, 0, 1, &rect);
    }
}

void PassRecorder::Run(const DrawCommand& draw)
{
    RequireBuffersFit(draw, m_Context.capabilities().limits);
    LimitTo(draw.scissor);
    ProgramObjects& objects = m_Resources.programs.Use(draw.program, m_Number);
    BindState(draw, objects);
    const PooledMesh* mesh = draw.mesh ? &m_Resources.meshes.Use(draw.mesh, m_Number) : nullptr;
    BindVertices(objects, mesh);
    const SubMesh indices = mesh == nullptr ? SubMesh{} : IndicesOf(draw);
    if (mesh != nullptr)
    {
        vkCmdBindIndexBuffer(m_Commands, mesh->buffer.handle.get(), mesh->indexOffset,
                             VK_INDEX_TYPE_UINT32);
    }
    for (std::uint32_t done = 0; done < draw.instanceCount;)
    {
        const InstanceRun run = m_Descriptors.RunFrom(draw, done);
        BindInstances(draw, objects, run);
        if (mesh == nullptr)
        {
            vkCmdDraw(m_Commands, draw.vertexCount, run.count, 0, run.first);
        }
        else
        {
            vkCmdDrawIndexed(m_Commands, indices.indexCount, run.count, indices.indexStart, 0,
                             run.first);
        }
        done += run.count;
    }
}

void PassRecorder::BindState(const DrawCommand& draw, ProgramObjects& objects)
{
    const PipelineKey key = MakePipelineKey(draw.state, m_Formats, m_Context.capabilities());
    const VkPipeline pipeline = m_Resources.programs.Pipeline(objects, *draw.program, key);
    if (pipeline != m_BoundPipeline)
    {
        vkCmdBindPipeline(m_Commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
        m_BoundPipeline = pipeline;
    }
    const int outputs = draw.program->layout.colorOutputs;
    if (m_BoundState != draw.state || m_BoundOutputs != outputs)
    {
        RecordDynamicState(m_Commands, draw.state, key, outputs, m_Context.functions());
        m_BoundState = draw.state;
        m_BoundOutputs = outputs;
    }
}

void PassRecorder::BindInstances(const DrawCommand& draw, const ProgramObjects& objects,
                                 const InstanceRun& run)
{
    const VkPipelineLayout layout = objects.layout.get();
    if (HasBindings(draw.program->layout))
    {
        const VkDescriptorSet set = m_Descriptors.Get(draw, objects, run.piece);
        if (set != m_BoundSet)
        {
            vkCmdBindDescriptorSets(m_Commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1, &set,
                                    0, nullptr);
            m_BoundSet = set;
        }
    }
    if (objects.pushStages != 0)
    {
        const DrawConstants constants{run.first, run.base};
        vkCmdPushConstants(m_Commands, layout, objects.pushStages, 0, sizeof(constants),
                           &constants);
    }
}

void PassRecorder::BindVertices(const ProgramObjects& objects, const PooledMesh* mesh)
{
    const std::vector<VertexFetch>& fetches = objects.fetches;
    if (fetches.empty())
    {
        return; // the vertex function makes its vertices from SV_VertexID
    }
    std::vector<VkBuffer> buffers(fetches.size(), m_Resources.meshes.constants());
    std::vector<VkDeviceSize> offsets(fetches.size());
    std::vector<VkDeviceSize> strides(fetches.size(), 0);
    for (std::size_t i = 0; i < fetches.size(); ++i)
    {
        const std::size_t attribute = fetches[i].attribute;
        const bool carried = mesh != nullptr && attribute < k_VertexAttributeCount &&
                             mesh->arrays[attribute].stride != 0;
        offsets[i] = MeshPool::ConstantOffset(attribute);
        if (carried)
        {
            buffers[i] = mesh->buffer.handle.get();
            offsets[i] = mesh->arrays[attribute].offset;
            strides[i] = mesh->arrays[attribute].stride;
        }
    }
    vkCmdBindVertexBuffers2(m_Commands, 0, static_cast<std::uint32_t>(fetches.size()),
                            buffers.data(), offsets.data(), nullptr, strides.data());
}

void PassRecorder::Run(const BeginSampleCommand& sample)
{
    BeginLabel(sample.name);
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

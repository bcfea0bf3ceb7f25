#include "frame/DrawPreparer.h"

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

DrawPreparer::DrawPreparer(const VulkanContext& context, DeviceResources& resources,
                           FrameDescriptors& descriptors, std::uint64_t number,
                           PreparedFrame& frame)
    : m_Context(context),
      m_Resources(resources),
      m_Descriptors(descriptors),
      m_Number(number),
      m_Frame(frame)
{
}

void DrawPreparer::BeginPass(const TargetFormats& formats)
{
    m_Formats = &formats;
    m_Last = nullptr;
}

void DrawPreparer::Add(const DrawCommand& draw)
{
    const bool sameProgram = m_Last != nullptr && m_Last->program == draw.program;
    if (!sameProgram)
    {
        UseProgram(draw);
    }
    if (!sameProgram || m_Last->state != draw.state)
    {
        UseState(draw);
    }
    UseMesh(draw);
    AddRuns(draw);
    m_Frame.draws.push_back(m_Draw);
    m_Last = &draw;
}

void DrawPreparer::UseProgram(const DrawCommand& draw)
{
    RequireBuffersFit(draw, m_Context.capabilities().limits);
    m_Program = &m_Resources.programs.Use(draw.program, m_Number);
    m_Draw.program = m_Program;
    m_HasBindings = HasBindings(draw.program->layout);
}

void DrawPreparer::UseState(const DrawCommand& draw)
{
    const PipelineKey key = MakePipelineKey(draw.state, *m_Formats, m_Context.capabilities());
    m_Draw.pipeline = m_Resources.programs.Pipeline(*m_Program, *draw.program, key);
    m_Draw.state = m_Frame.states.size();
    m_Frame.states.push_back(ToDynamicState(draw.state, key, draw.program->layout.colorOutputs));
}

void DrawPreparer::UseMesh(const DrawCommand& draw)
{
    if (m_Last == nullptr || m_Last->mesh != draw.mesh)
    {
        m_Draw.mesh = draw.mesh ? &m_Resources.meshes.Use(draw.mesh, m_Number) : nullptr;
    }
    m_Draw.indices = draw.mesh ? IndicesOf(draw) : SubMesh{};
}

void DrawPreparer::AddRuns(const DrawCommand& draw)
{
    m_Draw.firstRun = m_Frame.runs.size();
    for (std::uint32_t done = 0; done < draw.instanceCount;)
    {
        PreparedRun run;
        run.instances = m_Descriptors.RunFrom(draw, done);
        if (m_HasBindings)
        {
            run.set = m_Descriptors.Get(draw, *m_Program, run.instances.piece, m_Number);
        }
        m_Frame.runs.push_back(run);
        done += run.instances.count;
    }
    m_Draw.runCount = m_Frame.runs.size() - m_Draw.firstRun;
}

} // namespace limn::vulkan

#include "frame/DrawPreparer.h"

#include <limn/core/DrawError.h>
#include <limn/core/Shader.h>

namespace limn::vulkan
{

namespace
{

/// The sub-mesh's run of indices.
SubMesh IndicesOf(const DrawCommand& draw, const Mesh& mesh)
{
    if (draw.subMesh < 0 || draw.subMesh >= mesh.subMeshCount())
    {
        throw ContractError("a draw asks for sub-mesh " + std::to_string(draw.subMesh) +
                            " of mesh '" + mesh.name() + "', which has " +
                            std::to_string(mesh.subMeshCount()));
    }
    return mesh.subMesh(draw.subMesh);
}

void RequireBuffersFit(const DrawSetup& draw, const VkPhysicalDeviceLimits& limits)
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
                           FrameDescriptors& descriptors, const FrameTables& tables,
                           std::uint64_t number, PreparedFrame& frame)
    : m_Context(context),
      m_Resources(resources),
      m_Descriptors(descriptors),
      m_Tables(tables),
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
    if (m_Last == nullptr || m_Last->setup != draw.setup)
    {
        const DrawSetup& setup = m_Tables.Setup(draw);
        const DrawSetup* last = m_Last != nullptr ? &m_Tables.Setup(*m_Last) : nullptr;
        const bool sameProgram = last != nullptr && last->program == setup.program;
        if (!sameProgram)
        {
            UseProgram(setup);
        }
        if (!sameProgram || last->state != setup.state)
        {
            UseState(setup);
        }
    }
    UseMesh(draw);
    AddRuns(draw);
    m_Frame.draws.push_back(m_Draw);
    m_Last = &draw;
}

void DrawPreparer::UseProgram(const DrawSetup& setup)
{
    RequireBuffersFit(setup, m_Context.capabilities().limits);
    m_Program = &m_Resources.programs.Use(setup.program, m_Number);
    m_Draw.program = m_Program;
    m_HasBindings = HasBindings(setup.program->layout);
}

void DrawPreparer::UseState(const DrawSetup& setup)
{
    const PipelineKey key = MakePipelineKey(setup.state, *m_Formats, m_Context.capabilities());
    m_Draw.pipeline = m_Resources.programs.Pipeline(*m_Program, *setup.program, key);
    m_Draw.state = m_Frame.states.size();
    m_Frame.states.push_back(ToDynamicState(setup.state, key, setup.program->layout.colorOutputs,
                                            m_Tables.usesReversedZBuffer));
}

void DrawPreparer::UseMesh(const DrawCommand& draw)
{
    const std::shared_ptr<const Mesh>& mesh = m_Tables.MeshOf(draw);
    if (m_Last == nullptr || m_Last->mesh != draw.mesh)
    {
        m_Draw.mesh = mesh ? &m_Resources.meshes.Use(mesh, m_Number) : nullptr;
    }
    m_Draw.indices = mesh ? IndicesOf(draw, *mesh) : SubMesh{};
}

void DrawPreparer::AddRuns(const DrawCommand& draw)
{
    const bool isLikeLast = m_Last != nullptr && m_Last->setup == draw.setup &&
                            m_Last->drawsObjects == draw.drawsObjects;
    m_Draw.firstRun = m_Frame.runs.size();
    for (std::uint32_t done = 0; done < draw.instanceCount;)
    {
        PreparedRun run;
        run.instances = m_Descriptors.RunFrom(draw, done);
        if (isLikeLast && m_LastRun.instances.piece == run.instances.piece)
        {
            run.set = m_LastRun.set;
        }
        else if (m_HasBindings)
        {
            run.set = m_Descriptors.Get(draw, *m_Program, run.instances.piece, m_Number);
        }
        m_Frame.runs.push_back(run);
        m_LastRun = run;
        done += run.instances.count;
    }
    m_Draw.runCount = m_Frame.runs.size() - m_Draw.firstRun;
}

} // namespace limn::vulkan

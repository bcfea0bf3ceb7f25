#include "frame/DrawPreparer.h"

#include <algorithm>
#include <limn/core/ComputeShader.h>
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

std::string Subject(const DrawSetup& draw)
{
    return draw.shader ? "shader '" + draw.shader->name() + "', pass " +
                             std::to_string(draw.shaderPass) + ": "
                       : "";
}

std::string Subject(const DispatchSetup& dispatch)
{
    return dispatch.shader ? "compute shader '" + dispatch.shader->name() + "', kernel '" +
                                 dispatch.shader->kernelName(dispatch.kernel) + "': "
                           : "";
}

const char* NameOf(UniformType type)
{
    return type == UniformType::Int ? "int" : type == UniformType::UInt ? "uint" : "float";
}

template <typename Setup>
void RequireBuffersFit(const Setup& setup, const VkPhysicalDeviceLimits& limits)
{
    for (const UniformBuffer& buffer : setup.program->layout.buffers)
    {
        if (buffer.size > limits.maxUniformBufferRange)
        {
            throw DrawError(Subject(setup) + "constant buffer '" + buffer.name + "' has " +
                            std::to_string(buffer.size) + " bytes; the device binds at most " +
                            std::to_string(limits.maxUniformBufferRange) +
                            ", so make it smaller or use a texture");
        }
    }
}

bool HasBindings(const PropertyLayout& layout)
{
    return !layout.buffers.empty() || !layout.textures.empty() || !layout.samplers.empty() ||
           !layout.storageBuffers.empty() || !layout.storageTextures.empty();
}

void RequireOutputsFit(const DrawSetup& setup, const CompiledRenderPass& pass)
{
    const PropertyLayout& layout = setup.program->layout;
    for (std::size_t i = 0; i < std::min(layout.outputTypes.size(), pass.colors.size()); ++i)
    {
        const RenderTexture& target = *pass.colors[i].texture;
        const UniformType type = ComponentType(target.graphicsFormat());
        const auto fail = [&](const std::string& problem)
        {
            throw DrawError(Subject(setup) + "it draws into '" + target.name() + "' of " +
                            ToString(target.graphicsFormat()) + problem);
        };
        if (layout.outputTypes[i] != type)
        {
            fail(std::string(", which takes ") + NameOf(type) + ", but its SV_Target" +
                 std::to_string(i) + " is " + NameOf(layout.outputTypes[i]));
        }
        const auto blend = ToBlendAttachment(setup.state.targets.at(i), i, layout.colorOutputs);
        if (type != UniformType::Float && blend.blendEnable == VK_TRUE)
        {
            fail(" and blends; integers are not blended, write Blend Off");
        }
    }
}

void RequireThreadsFit(const DispatchSetup& setup, const VkPhysicalDeviceLimits& limits)
{
    const auto& size = setup.program->threadGroupSize;
    const std::uint64_t count = std::uint64_t{size[0]} * size[1] * size[2];
    if (size[0] > limits.maxComputeWorkGroupSize[0] ||
        size[1] > limits.maxComputeWorkGroupSize[1] ||
        size[2] > limits.maxComputeWorkGroupSize[2] ||
        count > limits.maxComputeWorkGroupInvocations)
    {
        const auto& most = limits.maxComputeWorkGroupSize;
        throw DrawError(Subject(setup) + "its groups have " + std::to_string(size[0]) + "x" +
                        std::to_string(size[1]) + "x" + std::to_string(size[2]) +
                        " threads; the device runs at most " + std::to_string(most[0]) + "x" +
                        std::to_string(most[1]) + "x" + std::to_string(most[2]) + " and " +
                        std::to_string(limits.maxComputeWorkGroupInvocations) + " in all");
    }
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

void DrawPreparer::BeginPass(const CompiledRenderPass& pass, const TargetFormats& formats)
{
    m_Pass = &pass;
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
    m_Draw.arguments = ArgumentsOf(m_Tables.Setup(draw).bindings.get());
    UseMesh(draw);
    AddRuns(draw);
    m_Frame.draws.push_back(m_Draw);
    m_Last = &draw;
}

void DrawPreparer::Add(const DispatchCommand& dispatch)
{
    const DispatchSetup& setup = m_Tables.Setup(dispatch);
    const VkPhysicalDeviceLimits& limits = m_Context.capabilities().limits;
    RequireBuffersFit(setup, limits);
    RequireThreadsFit(setup, limits);
    ProgramObjects& program = m_Resources.programs.Use(setup.program, m_Number);
    PreparedDispatch prepared;
    prepared.layout = program.layout.get();
    prepared.pipeline =
        m_Resources.programs.KernelPipeline(program, *setup.program, FormatsFor(setup));
    if (HasBindings(setup.program->layout))
    {
        prepared.set = m_Descriptors.Get(dispatch, program);
    }
    prepared.arguments = ArgumentsOf(setup.bindings.get());
    m_Frame.dispatches.push_back(prepared);
}

PreparedArguments DrawPreparer::ArgumentsOf(const DrawBindings* bindings)
{
    const BufferSlot* slot = bindings != nullptr ? bindings->arguments() : nullptr;
    return slot != nullptr ? PreparedArguments{m_Descriptors.Use(slot->buffer), slot->offset}
                           : PreparedArguments();
}

/// Returns the formats of the textures that the kernel both reads and writes, for those that the
/// device can read only if it knows the format.
ImageFormats DrawPreparer::FormatsFor(const DispatchSetup& setup) const
{
    ImageFormats formats;
    bool isNeeded = false;
    for (const StorageTextureBinding& declared : setup.program->layout.storageTextures)
    {
        const auto& slots = setup.bindings->storageTextures;
        const auto slot = std::ranges::find(slots, declared.binding, &StorageTextureSlot::binding);
        if (!declared.isRead || slot == slots.end())
        {
            continue;
        }
        const GraphicsFormat format = slot->texture->graphicsFormat();
        const bool isUntold = m_Context.ReadsWithoutFormat(format);
        const std::uint32_t imageFormat = ToImageFormat(format);
        if (!isUntold && isExtended(imageFormat) &&
            !m_Context.capabilities().features.shaderStorageImageExtendedFormats)
        {
            throw DrawError(Subject(setup) + "it reads '" + declared.name +
                            "' and may write to it, but the device cannot do both for " +
                            ToString(format));
        }
        formats[declared.binding] = imageFormat;
        isNeeded = isNeeded || !isUntold;
    }
    return isNeeded ? formats : ImageFormats();
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
    RequireOutputsFit(setup, *m_Pass);
    const PipelineKey key = MakePipelineKey(setup.state, *m_Formats, m_Context.capabilities());
    m_Draw.pipeline = &m_Resources.programs.Pipeline(*m_Program, *setup.program, key);
    m_Draw.state = m_Frame.states.size();
    m_Frame.states.push_back(ToDynamicState(setup.state, key, setup.program->layout.colorOutputs,
                                            m_Tables.usesReversedZBuffer));
}

void DrawPreparer::UseMesh(const DrawCommand& draw)
{
    const std::shared_ptr<const Mesh>& mesh = m_Tables.MeshOf(draw);
    const bool isIndirect = m_Draw.arguments.buffer != VK_NULL_HANDLE;
    if (m_Last == nullptr || m_Last->mesh != draw.mesh || m_LastIsIndirect != isIndirect)
    {
        m_Draw.mesh = !mesh        ? nullptr
                      : isIndirect ? &m_Resources.meshes.UseDedicatedBuffer(mesh, m_Number)
                                   : &m_Resources.meshes.Use(mesh, m_Number);
        m_LastIsIndirect = isIndirect;
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
        if (m_Draw.arguments.buffer != VK_NULL_HANDLE)
        {
            run.instances.base = 0; // the buffer's instances count from there
        }
        if (isLikeLast && m_LastRun.instances.piece == run.instances.piece)
        {
            run.set = m_LastRun.set;
        }
        else if (m_HasBindings)
        {
            run.set = m_Descriptors.Get(draw, *m_Program, run.instances.piece);
        }
        m_Frame.runs.push_back(run);
        m_LastRun = run;
        done += run.instances.count;
    }
    m_Draw.runCount = m_Frame.runs.size() - m_Draw.firstRun;
}

} // namespace limn::vulkan

#include "frame/BoundState.h"

#include <cstring>

namespace limn::vulkan
{

namespace
{

/// Vulkan's structures of plain numbers.
template <typename T>
bool isSame(const T& a, const T& b)
{
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

void SetStencilFace(VkCommandBuffer commands, VkStencilFaceFlags which,
                    const VkStencilOpState& face)
{
    vkCmdSetStencilOp(commands, which, face.failOp, face.passOp, face.depthFailOp, face.compareOp);
    vkCmdSetStencilCompareMask(commands, which, face.compareMask);
    vkCmdSetStencilWriteMask(commands, which, face.writeMask);
    vkCmdSetStencilReference(commands, which, face.reference);
}

} // namespace

BoundState::BoundState(VkCommandBuffer commands, const ExtensionFunctions& functions,
                       VkBuffer constants)
    : m_Commands(commands), m_Functions(functions), m_Constants(constants)
{
}

void BoundState::SetViewport(const VkViewport& viewport)
{
    if (!m_Viewport || !isSame(*m_Viewport, viewport))
    {
        m_Viewport = viewport;
        vkCmdSetViewport(m_Commands, 0, 1, &viewport);
    }
}

void BoundState::SetScissor(const VkRect2D& scissor)
{
    if (!m_Scissor || !isSame(*m_Scissor, scissor))
    {
        m_Scissor = scissor;
        vkCmdSetScissor(m_Commands, 0, 1, &scissor);
    }
}

void BoundState::BindPipeline(const PreparedDraw& draw, const DynamicState& state)
{
    if (draw.pipeline->get() != m_Pipeline)
    {
        m_Pipeline = draw.pipeline->get();
        m_State = nullptr;
        vkCmdBindPipeline(m_Commands, VK_PIPELINE_BIND_POINT_GRAPHICS, m_Pipeline);
        // What a pipeline has baked in is not set any more.
        m_Blend = state.blend.isDynamic ? m_Blend : std::nullopt;
        if (draw.program->fetches.empty())
        {
            m_Vertices.reset();
        }
    }
    if (m_State != &state)
    {
        m_State = &state;
        SetFixed(state.fixed);
        if (state.blend.isDynamic)
        {
            SetBlend(state.blend);
        }
    }
}

void BoundState::SetFixed(const FixedState& state)
{
    const auto changes = [&](const auto FixedState::*member)
    {
        return !m_Fixed || !isSame((*m_Fixed).*member, state.*member);
    };
    const auto set = [&](const auto FixedState::*member, const auto& command)
    {
        if (changes(member))
        {
            command(m_Commands, state.*member);
        }
    };
    set(&FixedState::topology, vkCmdSetPrimitiveTopology);
    set(&FixedState::cullMode, vkCmdSetCullMode);
    set(&FixedState::frontFace, vkCmdSetFrontFace);
    set(&FixedState::depthTest, vkCmdSetDepthTestEnable);
    set(&FixedState::depthWrite, vkCmdSetDepthWriteEnable);
    set(&FixedState::depthCompare, vkCmdSetDepthCompareOp);
    set(&FixedState::depthBias, vkCmdSetDepthBiasEnable);
    if (changes(&FixedState::depthBiasConstant) || changes(&FixedState::depthBiasSlope))
    {
        vkCmdSetDepthBias(m_Commands, state.depthBiasConstant, 0.0f, state.depthBiasSlope);
    }
    set(&FixedState::stencilTest, vkCmdSetStencilTestEnable);
    const bool front = changes(&FixedState::stencilFront);
    const bool back = changes(&FixedState::stencilBack);
    const bool both = front && back && isSame(state.stencilFront, state.stencilBack);
    if (front)
    {
        SetStencilFace(m_Commands,
                       both ? VK_STENCIL_FACE_FRONT_AND_BACK : VK_STENCIL_FACE_FRONT_BIT,
                       state.stencilFront);
    }
    if (back && !both)
    {
        SetStencilFace(m_Commands, VK_STENCIL_FACE_BACK_BIT, state.stencilBack);
    }
    m_Fixed = state;
}

void BoundState::SetBlend(const BlendState& state)
{
    if (state.targets == 0 ||
        (m_Blend && m_Blend->targets >= state.targets && isSame(m_Blend->enables, state.enables) &&
         isSame(m_Blend->equations, state.equations) && isSame(m_Blend->masks, state.masks)))
    {
        return;
    }
    m_Blend = state;
    m_Functions.setColorBlendEnable(m_Commands, 0, state.targets, state.enables.data());
    m_Functions.setColorBlendEquation(m_Commands, 0, state.targets, state.equations.data());
    m_Functions.setColorWriteMask(m_Commands, 0, state.targets, state.masks.data());
}

void BoundState::BindMesh(const PreparedDraw& draw)
{
    if (!draw.program->fetches.empty()) // else it makes vertices of SV_VertexID
    {
        const VertexBinding vertices = VerticesOf(draw);
        if (m_Vertices != vertices)
        {
            m_Vertices = vertices;
            BindVertices(vertices);
        }
    }
    if (draw.mesh != nullptr && m_Indices != draw.mesh->block->buffer())
    {
        m_Indices = draw.mesh->block->buffer();
        vkCmdBindIndexBuffer(m_Commands, m_Indices, 0, VK_INDEX_TYPE_UINT32);
    }
}

/// SV_VertexID counts from the mesh's first vertex; Vulkan's index counts from the first one bound.
BoundState::VertexBinding BoundState::VerticesOf(const PreparedDraw& draw)
{
    const bool countsFromFirst = draw.mesh != nullptr && draw.program->readsVertexIndex;
    return {draw.program, draw.mesh != nullptr ? draw.mesh->block : nullptr,
            countsFromFirst ? draw.mesh->range.firstVertex : 0};
}

std::int32_t BoundState::VertexOffset(const PreparedDraw& draw) const
{
    return static_cast<std::int32_t>(draw.mesh->range.firstVertex - VerticesOf(draw).first);
}

void BoundState::BindVertices(const VertexBinding& binding)
{
    constexpr std::size_t k_Most = 32;
    std::array<VkBuffer, k_Most> buffers{};
    std::array<VkDeviceSize, k_Most> offsets{};
    std::array<VkDeviceSize, k_Most> strides{};
    const std::vector<VertexFetch>& fetches = binding.program->fetches;
    const MeshBlock* const block = binding.block;
    for (std::size_t i = 0; i < fetches.size(); ++i)
    {
        const std::size_t attribute = fetches[i].attribute;
        const bool carried = block != nullptr && attribute < k_VertexAttributeCount &&
                             block->attributes()[attribute];
        buffers.at(i) = carried ? block->buffer() : m_Constants;
        offsets.at(i) = carried ? block->ArrayOffset(attribute, binding.first)
                                : MeshPool::ConstantOffset(attribute);
        strides.at(i) = carried ? MeshBlock::Stride(attribute) : 0;
    }
    vkCmdBindVertexBuffers2(m_Commands, 0, static_cast<std::uint32_t>(fetches.size()),
                            buffers.data(), offsets.data(), nullptr, strides.data());
}

void BoundState::BindRun(const PreparedDraw& draw, const PreparedRun& run)
{
    const VkPipelineLayout layout = draw.program->layout.get();
    if (run.set != VK_NULL_HANDLE && (run.set != m_Set || layout != m_SetLayout))
    {
        m_Set = run.set;
        m_SetLayout = layout;
        vkCmdBindDescriptorSets(m_Commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1, &m_Set,
                                0, nullptr);
    }
    if (draw.program->pushStages != 0)
    {
        const DrawConstants constants{run.instances.first, run.instances.base};
        vkCmdPushConstants(m_Commands, layout, draw.program->pushStages, 0, sizeof(constants),
                           &constants);
    }
}

} // namespace limn::vulkan

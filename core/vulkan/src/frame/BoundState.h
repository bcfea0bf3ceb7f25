#pragma once

#include "frame/PreparedFrame.h"

namespace limn::vulkan
{

/// What a command buffer has bound and set; records only what changes that.
class BoundState
{
public:
    /// @param constants  see MeshPool::constants
    BoundState(VkCommandBuffer commands, const ExtensionFunctions& functions, VkBuffer constants);

    void SetViewport(const VkViewport& viewport);
    void SetScissor(const VkRect2D& scissor);
    /// @lifetime keeps `state` until the next call
    void BindPipeline(const PreparedDraw& draw, const DynamicState& state);
    void BindMesh(const PreparedDraw& draw);
    void BindRun(const PreparedDraw& draw, const PreparedRun& run);

private:
    void SetFixed(const FixedState& state);
    void SetDepth(const FixedState& state, const FixedState* known);
    void SetStencil(const FixedState& state, const FixedState* known);
    void SetBlend(const BlendState& state);
    void BindVertices(const ProgramObjects& program, const PooledMesh* mesh);

    VkCommandBuffer m_Commands;
    const ExtensionFunctions& m_Functions;
    VkBuffer m_Constants;
    std::optional<VkViewport> m_Viewport;
    std::optional<VkRect2D> m_Scissor;
    VkPipeline m_Pipeline = VK_NULL_HANDLE;
    const DynamicState* m_State = nullptr;
    std::optional<FixedState> m_Fixed;
    std::optional<BlendState> m_Blend;
    const ProgramObjects* m_VertexProgram = nullptr; ///< for which vertices are bound
    const PooledMesh* m_VertexMesh = nullptr;        ///< of them
    const PooledMesh* m_IndexMesh = nullptr;
    VkDescriptorSet m_Set = VK_NULL_HANDLE;
    VkPipelineLayout m_SetLayout = VK_NULL_HANDLE; ///< that m_Set is bound with
};

} // namespace limn::vulkan

#pragma once

#include "frame/PreparedFrame.h"

namespace limn::vulkan
{

/// The state that a command buffer has bound and set. Records only commands that change it.
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
    /// Returns the number to add to each index of the draw's mesh.
    std::int32_t VertexOffset(const PreparedDraw& draw) const;
    void BindRun(const PreparedDraw& draw, const PreparedRun& run);

private:
    struct VertexBinding
    {
        const ProgramObjects* program = nullptr; ///< the program that reads the vertices
        const MeshBlock* block = nullptr;        ///< null = there is none
        std::uint32_t first = 0;                 ///< the vertex of index 0

        bool operator==(const VertexBinding&) const = default;
    };

    static VertexBinding VerticesOf(const PreparedDraw& draw);
    void SetFixed(const FixedState& state);
    void SetBlend(const BlendState& state);
    void BindVertices(const VertexBinding& binding);

    VkCommandBuffer m_Commands;
    const ExtensionFunctions& m_Functions;
    VkBuffer m_Constants;
    std::optional<VkViewport> m_Viewport;
    std::optional<VkRect2D> m_Scissor;
    VkPipeline m_Pipeline = VK_NULL_HANDLE;
    const DynamicState* m_State = nullptr;
    std::optional<FixedState> m_Fixed;
    std::optional<BlendState> m_Blend;
    std::optional<VertexBinding> m_Vertices;
    VkBuffer m_Indices = VK_NULL_HANDLE;
    VkDescriptorSet m_Set = VK_NULL_HANDLE;
    VkPipelineLayout m_SetLayout = VK_NULL_HANDLE; ///< the layout with which m_Set is bound
};

} // namespace limn::vulkan

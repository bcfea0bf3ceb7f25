#pragma once

#include "frame/BoundState.h"

namespace limn::vulkan
{

/// Records one pass of a prepared frame.
/// @lifetime all references must live until Record() returns
class PassRecorder
{
public:
    PassRecorder(const VulkanContext& context, ImagePool& images, VkCommandBuffer commands,
                 const CompiledRenderPass& pass, const PreparedPass& prepared,
                 const PreparedFrame& frame, BoundState& bound);

    void Record();

private:
    void GenerateMips() const;
    void Run(const ClearCommand& clear);
    void Run(const SetViewportCommand& viewport);
    void Run(const DrawCommand& draw);
    void DrawIndirect(const PreparedDraw& draw) const;
    void Run(const DispatchCommand& dispatch);
    void Run(const BeginSampleCommand& sample);
    void Run(const EndSampleCommand& sample);
    void BeginLabel(const std::string& name);
    void EndLabel();

    const VulkanContext& m_Context;
    ImagePool& m_Images;
    VkCommandBuffer m_Commands;
    const CompiledRenderPass& m_Pass;
    const PreparedPass& m_Prepared;
    const PreparedFrame& m_Frame;
    BoundState& m_Bound;
    std::size_t m_NextDraw;
    std::size_t m_NextDispatch;
    VkRect2D m_Scissor{}; ///< the scissor of the viewport
    int m_OpenSamples = 0;
};

} // namespace limn::vulkan

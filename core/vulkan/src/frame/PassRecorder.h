#pragma once

#include "descriptors/FrameDescriptors.h"
#include "frame/DynamicState.h"

namespace limn::vulkan
{

/// Records one pass of a frame. @lifetime of all references: the call of Record()
class PassRecorder
{
public:
    PassRecorder(const VulkanContext& context, DeviceResources& resources, VkCommandBuffer commands,
                 FrameDescriptors& descriptors, const CompiledRenderPass& pass,
                 std::uint64_t number);

    void Record();

private:
    void Run(const ClearCommand& clear);
    void Run(const SetViewportCommand& viewport);
    void Run(const DrawCommand& draw);
    void Run(const BeginSampleCommand& sample);
    void Run(const EndSampleCommand& sample);
    void LimitTo(const std::optional<ViewportRect>& part);
    void BindState(const DrawCommand& draw, ProgramObjects& objects);
    void BindInstances(const DrawCommand& draw, const ProgramObjects& objects,
                       const InstanceRun& run);
    void BindVertices(const ProgramObjects& objects, const PooledMesh* mesh);
    void BeginLabel(const std::string& name);
    void EndLabel();

    const VulkanContext& m_Context;
    DeviceResources& m_Resources;
    VkCommandBuffer m_Commands;
    FrameDescriptors& m_Descriptors;
    const CompiledRenderPass& m_Pass;
    std::uint64_t m_Number;
    TargetFormats m_Formats;
    VkRect2D m_Scissor{};                ///< of the viewport
    std::optional<ViewportRect> m_Limit; ///< of the last draw
    int m_OpenSamples = 0;
    VkPipeline m_BoundPipeline = VK_NULL_HANDLE;
    VkDescriptorSet m_BoundSet = VK_NULL_HANDLE;
    std::optional<PipelineState> m_BoundState;
    int m_BoundOutputs = 0; ///< colorOutputs the blend state was recorded for
};

} // namespace limn::vulkan

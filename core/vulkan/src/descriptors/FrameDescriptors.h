#pragma once

#include "frame/FrameSlot.h"
#include "resources/DeviceResources.h"

namespace limn::vulkan
{

/// The descriptor sets of one frame; draws of equal bindings and layout share one.
class FrameDescriptors
{
public:
    /// Uploads the frame's uniform and per-draw data. @lifetime keeps `frame` by reference
    FrameDescriptors(const VulkanContext& context, DeviceResources& resources, FrameSlot& slot,
                     const CompiledFrame& frame);

    /// @throws ContractError naming what the shader reads and the draw does not bind
    VkDescriptorSet Get(const DrawCommand& draw, const PassObjects& pass);

private:
    VkDescriptorSet Create(const PropertyLayout& layout, const DrawBindings& bindings,
                           VkDescriptorSetLayout setLayout);

    const VulkanContext& m_Context;
    DeviceResources& m_Resources;
    FrameSlot& m_Slot;
    const CompiledFrame& m_Frame;
    UploadedBytes m_Uniforms;
    UploadedBytes m_PerDraw;
    std::map<std::pair<const DrawBindings*, VkDescriptorSetLayout>, VkDescriptorSet> m_Sets;
};

} // namespace limn::vulkan

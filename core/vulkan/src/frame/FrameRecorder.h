#pragma once

#include "descriptors/FrameDescriptors.h"

namespace limn::vulkan
{

/// Turns a compiled frame into the commands of a slot.
class FrameRecorder
{
public:
    /// @param number  that the frame's submission will have
    FrameRecorder(const VulkanContext& context, DeviceResources& resources, FrameSlot& slot,
                  std::uint64_t number);

    /// @throws ContractError if the frame contradicts itself
    void Record(const CompiledFrame& frame);

private:
    void Prepare(const CompiledFrame& frame);
    void PrepareDraw(const DrawCommand& draw);
    void PrepareResolve(const std::shared_ptr<const RenderTexture>& target);
    void RecordBarrierList(const std::vector<TextureBarrier>& barriers, const std::string& where);

    const VulkanContext& m_Context;
    DeviceResources& m_Resources;
    FrameSlot& m_Slot;
    std::uint64_t m_Number;
    bool m_DrawsObjects = false; ///< the frame has draws of the scene's objects
};

} // namespace limn::vulkan

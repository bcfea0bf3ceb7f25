#pragma once

#include "frame/DrawPreparer.h"

namespace limn::vulkan
{

/// Turns a compiled frame into the commands of a slot: Prepare looks everything up, and whatever
/// the device keeps changes there alone; recording only reads.
class FrameRecorder
{
public:
    /// @param number  that the frame's submission will have
    FrameRecorder(const VulkanContext& context, DeviceResources& resources, FrameSlot& slot,
                  std::uint64_t number, PreparedFrame& prepared);

    /// @throws ContractError if the frame contradicts itself
    void Prepare(const CompiledFrame& frame);
    /// @pre Prepare, with the same frame
    void Record(const CompiledFrame& frame);

private:
    void PrepareBarriers(const std::vector<TextureBarrier>& barriers,
                         const CompiledRenderPass* pass);
    void PrepareTargets(const CompiledRenderPass& pass);
    void PrepareCommands(const CompiledRenderPass& pass, DrawPreparer& draws) const;
    void RecordPasses(const CompiledFrame& frame) const;

    const VulkanContext& m_Context;
    DeviceResources& m_Resources;
    FrameSlot& m_Slot;
    std::uint64_t m_Number;
    PreparedFrame& m_Prepared;
};

} // namespace limn::vulkan

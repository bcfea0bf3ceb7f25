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

    /// @return whether what the slot has recorded is this frame's, too, so that it is ready
    /// @throws ContractError if the frame contradicts itself
    bool Prepare(const CompiledFrame& frame);
    /// @pre Prepare, with the same frame, gave false
    void Record(const CompiledFrame& frame);

private:
    bool Repeat(const CompiledFrame& frame);
    void PrepareBarriers(const std::vector<TextureBarrier>& barriers,
                         const CompiledRenderPass* pass);
    void PrepareTargets(const CompiledRenderPass& pass);
    void PrepareBufferBarriers(const CompiledRenderPass& pass, PreparedPass& prepared);
    void PrepareCommands(const CompiledRenderPass& pass, DrawPreparer& draws) const;
    void RecordPasses(const CompiledFrame& frame) const;

    const VulkanContext& m_Context;
    DeviceResources& m_Resources;
    FrameSlot& m_Slot;
    std::uint64_t m_Number;
    PreparedFrame& m_Prepared;
};

} // namespace limn::vulkan

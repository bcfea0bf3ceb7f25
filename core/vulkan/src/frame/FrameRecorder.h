#pragma once

#include "frame/DrawPreparer.h"

namespace limn::vulkan
{

/// Turns a compiled frame into the commands of a slot. Prepare looks everything up, and only it
/// changes what the device keeps; recording only reads.
class FrameRecorder
{
public:
    /// @param number  the number of the frame's submission
    FrameRecorder(const VulkanContext& context, DeviceResources& resources, FrameSlot& slot,
                  std::uint64_t number, PreparedFrame& prepared);

    /// @return true if the commands that the slot has recorded are also those of this frame, so
    ///     that they are ready
    /// @throws ContractError if the frame contradicts itself
    bool Prepare(const CompiledFrame& frame);
    /// @pre Prepare with the same frame returned false
    void Record(const CompiledFrame& frame);

private:
    bool Repeat(const CompiledFrame& frame);
    void PrepareBarriers(const std::vector<TextureBarrier>& barriers,
                         const CompiledRenderPass* pass);
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

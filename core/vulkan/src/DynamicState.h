#pragma once

#include "PassPool.h"

namespace limn::vulkan
{

/// What of a pipeline state is baked into the pipeline on this device.
/// @throws ContractError if the device cannot draw so
PipelineKey MakePipelineKey(const PipelineState& state, const TargetFormats& formats,
                            const DeviceCapabilities& capabilities);

/// Records the rest. @param colorOutputs  of the pass, see PropertyLayout
void RecordDynamicState(VkCommandBuffer commands, const PipelineState& state,
                        const TargetFormats& formats, int colorOutputs,
                        const VulkanContext& context);

} // namespace limn::vulkan

#pragma once

#include "programs/ProgramPool.h"

namespace limn::vulkan
{

/// What of a pipeline state is baked into the pipeline on this device.
/// @throws ContractError if the device cannot draw so
PipelineKey MakePipelineKey(const PipelineState& state, const TargetFormats& formats,
                            const DeviceCapabilities& capabilities);

/// The fixed state that is no part of the pipeline, blending apart, as Vulkan's commands take it.
struct FixedState
{
    VkCullModeFlags cullMode = VK_CULL_MODE_NONE;
    VkFrontFace frontFace = VK_FRONT_FACE_CLOCKWISE;
    bool depthTest = false;
    bool depthWrite = false;
    VkCompareOp depthCompare = VK_COMPARE_OP_ALWAYS;
    bool depthBias = false;
    float depthBiasConstant = 0.0f;
    float depthBiasSlope = 0.0f;
    bool stencilTest = false;
    VkStencilOpState stencilFront{};
    VkStencilOpState stencilBack{};
};

/// Tests are off where the target has nothing to test against.
FixedState ToFixedState(const PipelineState& state, const TargetFormats& formats);

/// Records the rest, for pipelines of this key. @param colorOutputs  of the pass, see
/// PropertyLayout
void RecordDynamicState(VkCommandBuffer commands, const PipelineState& state,
                        const PipelineKey& key, int colorOutputs,
                        const ExtensionFunctions& functions);

} // namespace limn::vulkan

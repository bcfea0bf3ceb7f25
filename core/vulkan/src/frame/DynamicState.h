#pragma once

#include "programs/ProgramPool.h"

namespace limn::vulkan
{

/// Returns the part of a pipeline state that is part of the pipeline on this device.
/// @throws ContractError if the device cannot draw with the state
PipelineKey MakePipelineKey(const PipelineState& state, const TargetFormats& formats,
                            const DeviceCapabilities& capabilities);

/// The fixed state that is not part of the pipeline, without blending, in the form that Vulkan's
/// commands take.
struct FixedState
{
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
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

/// Converts the state. A test is off if the target has nothing to test against.
/// @param usesReversedZBuffer  see ShaderCompilerOptions
FixedState ToFixedState(const PipelineState& state, const TargetFormats& formats,
                        bool usesReversedZBuffer = true);

/// The blending of the colour targets, in the form that Vulkan's commands take.
struct BlendState
{
    bool isDynamic = false; ///< if false, blending is part of the pipeline, and the rest is not set
    std::uint32_t targets = 0;
    std::array<VkBool32, 8> enables{};
    std::array<VkColorBlendEquationEXT, 8> equations{};
    std::array<VkColorComponentFlags, 8> masks{};
};

/// The state that is set for a draw besides its pipeline.
struct DynamicState
{
    FixedState fixed;
    BlendState blend;
};

/// Returns the rest of the state, for pipelines of this key.
/// @param colorOutputs  the colour outputs of the pass, see PropertyLayout
DynamicState ToDynamicState(const PipelineState& state, const PipelineKey& key, int colorOutputs,
                            bool usesReversedZBuffer);

} // namespace limn::vulkan

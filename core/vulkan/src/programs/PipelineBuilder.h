#pragma once

#include "programs/ProgramPool.h"

namespace limn::vulkan
{

/// Returns Vulkan's blend state of target `index`. A target that the fragment function does not
/// write keeps its contents, because the written values would be undefined.
VkPipelineColorBlendAttachmentState ToBlendAttachment(const RenderTargetBlendState& blend,
                                                      std::size_t index, int colorOutputs);

UniquePipeline BuildPipeline(const VulkanContext& context, VkPipelineCache cache,
                             const ProgramObjects& pass, int colorOutputs, const PipelineKey& key);

UniquePipeline BuildComputePipeline(const VulkanContext& context, VkPipelineCache cache,
                                    VkShaderModule kernel, VkPipelineLayout layout);

} // namespace limn::vulkan

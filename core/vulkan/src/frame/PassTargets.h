#pragma once

#include "programs/ProgramPool.h"
#include "resources/ImagePool.h"

namespace limn::vulkan
{

/// The formats of a pass's targets.
/// @throws ContractError naming pass and texture, if a target is of the wrong kind, size, sample
///         count or use, or there are more of them than the device draws into
TargetFormats TargetsOf(const CompiledRenderPass& pass, ImagePool& images,
                        const VkPhysicalDeviceLimits& limits);

/// Notes which samples the pass leaves without resolving them.
void MarkSamples(const CompiledRenderPass& pass, ImagePool& images);

void RecordBeginRendering(VkCommandBuffer commands, const CompiledRenderPass& pass,
                          const ImagePool& images, bool usesReversedZBuffer);

/// @throws ContractError if the rectangle is empty or more than the device draws into
void RequireViewport(const ViewportRect& rect, const CompiledRenderPass& pass,
                     const VkPhysicalDeviceLimits& limits);

/// The part of the pass's area that `rect` covers.
VkRect2D ClipToPass(const ViewportRect& rect, const CompiledRenderPass& pass);
/// The texels that are in both.
VkRect2D Common(const VkRect2D& a, const VkRect2D& b);

/// Clip y = +1 is the rectangle's first row, clip z = depth.
VkViewport ToVkViewport(const ViewportRect& rect);

/// Of integers, those nearest to the colour's components.
VkClearColorValue ColorClearValue(const Color& color, GraphicsFormat format);

/// Unity writes 1 = far; a reversed buffer holds 0 there.
VkClearValue DepthClearValue(float depth, int stencil, bool usesReversedZBuffer);

} // namespace limn::vulkan

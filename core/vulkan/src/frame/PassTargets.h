#pragma once

#include "programs/ProgramPool.h"
#include "resources/ImagePool.h"

namespace limn::vulkan
{

/// Returns the formats of a pass's targets.
/// @throws ContractError naming pass and texture, if a target has the wrong kind, size, sample
///     count or use, or if there are more targets than the device supports
TargetFormats TargetsOf(const CompiledRenderPass& pass, ImagePool& images,
                        const VkPhysicalDeviceLimits& limits);

/// Calls `function` with each attachment of the pass.
template <typename Function>
void ForEachAttachment(const CompiledRenderPass& pass, const Function& function)
{
    std::ranges::for_each(pass.colors, function);
    if (pass.depth)
    {
        function(*pass.depth);
    }
}

/// Records which samples the pass leaves unresolved.
void MarkSamples(const CompiledRenderPass& pass, ImagePool& images);

void RecordBeginRendering(VkCommandBuffer commands, const CompiledRenderPass& pass,
                          ImagePool& images, bool usesReversedZBuffer);

/// @throws ContractError if the rectangle is empty or larger than the device supports
void RequireViewport(const ViewportRect& rect, const CompiledRenderPass& pass,
                     const VkPhysicalDeviceLimits& limits);

VkRect2D AreaOf(const CompiledRenderPass& pass);
/// Returns the part of the area that `rect` covers.
VkRect2D ClipTo(const VkRect2D& area, const ViewportRect& rect);

/// Converts a viewport. Clip y = +1 is the rectangle's first row, and clip z is the depth.
VkViewport ToVkViewport(const ViewportRect& rect);

/// Returns the clear value of a colour. For integer formats it has the integers nearest to the
/// colour's components.
VkClearColorValue ColorClearValue(const Color& color, GraphicsFormat format);

/// Returns the clear value of depth and stencil. In Unity 1 is far; a reversed buffer holds 0
/// there.
VkClearValue DepthClearValue(float depth, int stencil, bool usesReversedZBuffer);

} // namespace limn::vulkan

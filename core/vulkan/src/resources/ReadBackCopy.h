#pragma once

#include "frame/SubmitQueue.h"
#include "resources/BufferPool.h"
#include "resources/ImagePool.h"

namespace limn::vulkan
{

/// Copies one aspect of the image to the CPU and waits for it. Stencil comes as R8_UNorm, depth as
/// D32_SFloat, several samples resolved.
/// @pre its use is CopySource
Image CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator, SubmitQueue& queue,
                const PooledImage& image, const RenderTexture& texture,
                VkImageAspectFlagBits aspect);

/// Copies the first `size` bytes of the buffer to the CPU and waits for it.
std::vector<std::byte> CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator,
                                 SubmitQueue& queue, const PooledBuffer& buffer, std::size_t size);

} // namespace limn::vulkan

#pragma once

#include "ImagePool.h"
#include "SubmitQueue.h"

namespace limn::vulkan
{

/// Copies the image to the CPU and waits for it.
/// @pre its use is CopySource and it has one sample a texel
Image CopyToCpu(const VulkanContext& context, MemoryAllocator& allocator, SubmitQueue& queue,
                PooledImage& image, const RenderTexture& texture);

} // namespace limn::vulkan

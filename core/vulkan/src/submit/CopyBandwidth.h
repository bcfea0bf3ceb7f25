#pragma once

#include "memory/MemoryAllocator.h"
#include "submit/SubmitQueue.h"

namespace limn::vulkan
{

/// Returns the result of VulkanDevice::MeasureCopyBandwidth.
double MeasureCopyBandwidth(const VulkanContext& context, MemoryAllocator& allocator,
                            SubmitQueue& queue);

} // namespace limn::vulkan

#pragma once

#include "submit/SubmitQueue.h"
#include "memory/MemoryAllocator.h"

namespace limn::vulkan
{

/// What VulkanDevice::MeasureCopyBandwidth gives.
double MeasureCopyBandwidth(const VulkanContext& context, MemoryAllocator& allocator,
                            SubmitQueue& queue);

} // namespace limn::vulkan

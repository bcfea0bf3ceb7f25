#pragma once

#include "memory/MemoryAllocator.h"
#include "submit/SubmitQueue.h"

namespace limn::vulkan
{

/// What VulkanDevice::MeasureCopyBandwidth gives.
double MeasureCopyBandwidth(const VulkanContext& context, MemoryAllocator& allocator,
                            SubmitQueue& queue);

} // namespace limn::vulkan

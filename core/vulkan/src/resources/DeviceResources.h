#pragma once

#include "programs/PassPool.h"
#include "resources/ImagePool.h"
#include "resources/MeshPool.h"
#include "resources/SamplerCache.h"

namespace limn::vulkan
{

/// All that outlives a frame.
struct DeviceResources
{
    ImagePool images;
    MeshPool meshes;
    PassPool passes;
    SamplerCache samplers;

    DeviceResources(const VulkanContext& context, MemoryAllocator& allocator,
                    const std::filesystem::path& cacheFolder)
        : images(context, allocator),
          meshes(context.device(), allocator),
          passes(context, cacheFolder),
          samplers(context)
    {
    }
};

} // namespace limn::vulkan

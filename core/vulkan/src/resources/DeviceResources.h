#pragma once

#include "programs/ProgramPool.h"
#include "resources/ImagePool.h"
#include "resources/MeshPool.h"
#include "resources/ObjectPool.h"
#include "resources/SamplerCache.h"

namespace limn::vulkan
{

/// All that outlives a frame.
struct DeviceResources
{
    ImagePool images;
    MeshPool meshes;
    ObjectPool objects;
    ProgramPool programs;
    SamplerCache samplers;

    DeviceResources(const VulkanContext& context, MemoryAllocator& allocator,
                    const std::filesystem::path& cacheFolder)
        : images(context, allocator),
          meshes(context.device(), allocator),
          objects(context.device(), allocator),
          programs(context, cacheFolder),
          samplers(context)
    {
    }
};

} // namespace limn::vulkan

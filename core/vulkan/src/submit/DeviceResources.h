#pragma once

#include "programs/ProgramPool.h"
#include "resources/BufferPool.h"
#include "resources/ImagePool.h"
#include "resources/MeshPool.h"
#include "resources/ObjectPool.h"
#include "resources/SamplerCache.h"

namespace limn::vulkan
{

/// All objects that outlive a frame.
struct DeviceResources
{
    ImagePool images;
    MeshPool meshes;
    ObjectPool objects;
    BufferPool buffers;
    ProgramPool programs;
    SamplerCache samplers;

    DeviceResources(const VulkanContext& context, MemoryAllocator& allocator,
                    const std::filesystem::path& cacheFolder)
        : images(context, allocator),
          meshes(context.device(), allocator),
          objects(context.device(), allocator),
          buffers(context.device(), allocator, context.capabilities().limits),
          programs(context, cacheFolder),
          samplers(context),
          m_Allocator(allocator)
    {
    }

    /// Returns a count that grows whenever an image, a buffer, a mesh, a sampler or a layout that a
    /// frame uses is destroyed or replaced.
    std::uint64_t changeCount() const
    {
        return m_Allocator.returnedCount() + images.changeCount() + meshes.freedCount() +
               programs.freedCount() + samplers.freedCount();
    }
    /// Frees the objects that have no owner and no use.
    void Sweep(std::uint64_t finished)
    {
        images.Sweep(finished);
        meshes.Sweep(finished);
        objects.Sweep(finished);
        buffers.Sweep(finished);
        programs.Sweep(finished);
        samplers.Sweep(finished);
    }
    /// Undoes the uses of a submission that will never happen.
    void Rollback(std::uint64_t number) noexcept
    {
        images.Rollback(number);
        meshes.Rollback(number);
        objects.Rollback(number);
        buffers.Rollback(number);
        programs.Rollback(number);
        samplers.Rollback(number);
    }

private:
    const MemoryAllocator& m_Allocator;
};

} // namespace limn::vulkan

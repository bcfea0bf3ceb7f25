#pragma once

#include "descriptors/DescriptorCache.h"
#include "descriptors/FrameData.h"
#include "programs/ProgramPool.h"
#include "resources/BufferPool.h"
#include "resources/ImagePool.h"
#include "resources/ObjectPool.h"
#include "resources/SamplerCache.h"
#include "submit/SubmitQueue.h"
#include <deque>

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

/// The objects on which the recorded commands of a frame depend. As long as they are unchanged, the
/// commands may be submitted again for a frame of the same structure.
struct FrameRecording
{
    struct UsedImage
    {
        PooledImage* image = nullptr;
        ImageUse before;
        ImageUse after;
    };

    std::uint64_t structure = 0;      ///< CompiledFrame::structure; 0 = not to be submitted again
    std::uint64_t changes = 0;        ///< DeviceResources::changeCount, for all following members
    std::vector<UsedImage> images;    ///< all images of the frame
    std::vector<std::uint64_t*> uses; ///< `lastUse` of its meshes, programs, samplers
    std::vector<std::weak_ptr<const GraphicsBuffer>> buffers;
    std::optional<FrameData> data;
    VkBuffer objects = VK_NULL_HANDLE; ///< null = no draw has any
    std::uint32_t objectCount = 0;

    /// Records the objects that the frame used.
    /// @param number  the number of its submission
    void Take(DeviceResources& resources, std::uint64_t number);
    /// Returns whether all of these objects are unchanged.
    bool isValid(const CompiledFrame& frame, std::uint64_t changeCount) const;
    /// Marks all of them as used by submission `number`, too.
    void Use(std::uint64_t number) const;
};

/// The objects that one frame in flight owns, and commands that may be submitted again. A slot is
/// reused when the GPU is done with its frame.
class FrameSlot
{
public:
    FrameSlot(const VulkanContext& context, MemoryAllocator& allocator);

    VkCommandBuffer commands() const { return m_Commands.handle(); }
    LinearMemory& data() { return m_Data; } ///< the memory that the commands read
    UploadCommands& uploads() { return m_Uploads; }
    DescriptorCache& descriptors() { return m_Descriptors; }
    const DescriptorCache& descriptors() const { return m_Descriptors; }
    FrameRecording& recording() { return m_Recording; }
    const FrameRecording& recording() const { return m_Recording; }
    /// Returns the number of its last submission, 0 = none.
    std::uint64_t number() const { return m_Number; }

    /// Begins a frame: drops the uploads and keeps the commands.
    /// @pre the slot's last submission is finished
    void Begin() { m_Uploads.Reset(); }
    /// Begins recording: drops the commands and data of the frame before.
    /// @param structure  CompiledFrame::structure
    void BeginRecording(std::size_t passCount, std::uint64_t structure = 0);
    void EndRecording() { m_Commands.End(); }
    /// Drops the recorded commands, which will not be submitted.
    void Abandon() noexcept;
    /// Submits the uploads and then the commands.
    void Submit(SubmitQueue& queue);

    void BeginTiming(const CompiledRenderPass& pass);
    void EndTiming();
    /// @pre the slot's last submission is finished
    void ReadTimings(std::vector<PassTiming>& timings);

private:
    void ReserveQueries(std::size_t passCount);

    const VulkanContext& m_Context;
    Commands m_Commands;
    LinearMemory m_Data;
    UploadCommands m_Uploads;
    DescriptorCache m_Descriptors;
    FrameRecording m_Recording;
    UniqueQueryPool m_Queries; ///< two per pass
    std::uint32_t m_QueryCapacity = 0;
    std::vector<std::string> m_TimedPasses; ///< the first `m_TimedCount` are of this frame
    std::vector<std::uint64_t> m_Ticks;     ///< memory of ReadTimings
    std::size_t m_TimedCount = 0;
    std::uint64_t m_Number = 0;
};

/// Two slots for the frames in flight, or up to four if frames of so many structures alternate, so
/// that each finds its commands again. Each slot has its own memory for a frame's data.
class FrameSlots
{
public:
    FrameSlots(const VulkanContext& context, MemoryAllocator& allocator);

    /// Returns the number of the frame before the last one, for which the caller must wait before
    /// Take.
    std::uint64_t beforeLast() const;
    /// Returns a slot that is not the last frame's: if possible, one that has recorded this
    /// structure.
    FrameSlot& Take(std::uint64_t structure);

    auto begin() { return m_Slots.begin(); }
    auto end() { return m_Slots.end(); }

private:
    FrameSlot& Add() { return m_Slots.emplace_back(m_Context, m_Allocator); }

    const VulkanContext& m_Context;
    MemoryAllocator& m_Allocator;
    std::deque<FrameSlot> m_Slots;
    std::array<std::uint64_t, 4> m_Given{}; ///< structures whose commands were replaced
    std::size_t m_NextGiven = 0;
};

} // namespace limn::vulkan

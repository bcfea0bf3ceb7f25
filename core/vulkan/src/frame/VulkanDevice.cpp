#include <limn/core/Timeline.h>
#include <limn/vulkan/VulkanDevice.h>

#include "device/Translate.h"
#include "frame/FrameRecorder.h"
#include "resources/ImageSupport.h"
#include "submit/ReadBackCopy.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace limn
{

namespace vulkan
{

namespace
{

constexpr VkDeviceSize k_Bytes = VkDeviceSize{64} << 20; // more than a processor's caches hold
constexpr int k_Copies = 4;                              // beside which submitting takes no time
constexpr int k_Rounds = 5;                              // the first meets memory never touched

/// Seconds until all copies are done.
double TimeCopies(const VulkanContext& context, MemoryAllocator& allocator, SubmitQueue& queue,
                  VkBuffer from, VkBuffer to)
{
    FrameSlot slot{context, allocator};
    slot.BeginRecording(0);
    const VkBufferCopy region{0, 0, k_Bytes};
    constexpr UsageScope k_BothWays{VK_PIPELINE_STAGE_2_COPY_BIT,
                                    VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT};
    for (int i = 0; i < k_Copies; ++i)
    {
        RecordBarrier(slot.commands(), k_BothWays, k_BothWays);
        vkCmdCopyBuffer(slot.commands(), from, to, 1, &region);
    }
    slot.EndRecording();
    const auto begin = std::chrono::steady_clock::now();
    slot.Submit(queue);
    queue.Wait(slot.number());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Returns the result of VulkanDevice::MeasureCopyBandwidth.
double MeasureCopyBandwidth(const VulkanContext& context, MemoryAllocator& allocator,
                            SubmitQueue& queue)
{
    const auto make = [&](VkBufferUsageFlags usage)
    {
        return Buffer{context.device(), allocator,       k_Bytes, usage,
                      MemoryUse::Gpu,   "buffer to copy"};
    };
    const Buffer from = make(VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    const Buffer to = make(VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    double shortest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < k_Rounds; ++i)
    {
        shortest = std::min(
            shortest, TimeCopies(context, allocator, queue, from.handle.get(), to.handle.get()));
    }
    return 2.0 * k_Copies * static_cast<double>(k_Bytes) / shortest;
}

} // namespace

} // namespace vulkan

/// Members die bottom up: the queue waits for the device first, then resources go, then memory.
class VulkanDevice::Impl
{
public:
    explicit Impl(const VulkanDeviceOptions& options)
        : context(options),
          allocator(context.device(), context.physicalDevice()),
          resources(context, allocator, options.cacheFolder),
          slots(context, allocator),
          queue(context)
    {
    }
    /// Requests end with the device.
    ~Impl()
    {
        for (const auto& copy : copies)
        {
            copy->callback = {};
            copy->Finish(true);
        }
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    /// The slot for the next frame, once the GPU is done with it.
    vulkan::FrameSlot& TakeSlot(std::uint64_t structure)
    {
        Measure(timeline, "wait for a slot", [&] { queue.Wait(slots.beforeLast()); });
        vulkan::FrameSlot& slot = slots.Take(structure);
        KeepTimings(slot);
        return slot;
    }

    void Record(const CompiledFrame& frame, vulkan::FrameSlot& slot)
    {
        const std::uint64_t number = queue.nextNumber();
        try
        {
            slot.Begin();
            vulkan::FrameRecorder recorder{context, resources, slot, number, prepared};
            if (!Measure(timeline, "prepare", [&] { return recorder.Prepare(frame); }))
            {
                ++recordedFrames;
                Measure(timeline, "record commands", [&] { recorder.Record(frame); });
            }
            Measure(timeline, "submit", [&] { slot.Submit(queue); });
        }
        catch (...)
        {
            // Nothing here may throw, because the first error is the one that is reported.
            resources.Rollback(number);
            slot.Abandon();
            throw;
        }
    }

    void KeepTimings(vulkan::FrameSlot& slot)
    {
        if (slot.number() > timedFrame)
        {
            slot.ReadTimings(timings);
            timedFrame = slot.number();
        }
    }

    Image ReadBack(const RenderTexture& texture, VkImageAspectFlagBits aspect)
    {
        Image image =
            Measure(timeline, "wait", [&] { return Copy(texture, aspect)->WaitAndTake(); });
        if (!texture.descriptor().isTopRowFirst)
        {
            image.texels = FlipRows(image.texels, image.height);
        }
        return image;
    }

    std::shared_ptr<vulkan::ReadBackCopy> Copy(const RenderTexture& texture,
                                               VkImageAspectFlagBits aspect)
    {
        const std::string subject = "texture '" + texture.name() + "' cannot be read back: ";
        vulkan::PooledImage* image = resources.images.Find(texture);
        if (image == nullptr)
        {
            throw ContractError(subject + "no frame has drawn it");
        }
        if (image->use.usage != TextureUsage::CopySource)
        {
            throw ContractError(subject + "the last frame left it as " +
                                vulkan::ToString(image->use.usage) +
                                "; make it an output (CopySource)");
        }
        if (image->use.isStale)
        {
            throw ContractError(subject + "the last pass that drew into it did not resolve its " +
                                std::to_string(image->samples) + " samples per texel");
        }
        auto copy = vulkan::CopyToCpu(context, allocator, queue, *image, texture, aspect);
        image->lastUse = copy->number();
        return copy;
    }

    std::shared_ptr<vulkan::ReadBackCopy> Copy(const GraphicsBuffer& buffer)
    {
        vulkan::PooledBuffer* pooled = resources.buffers.Find(buffer);
        if (pooled == nullptr)
        {
            throw ContractError("buffer '" + buffer.name() +
                                "' cannot be read back: no frame has used it");
        }
        auto copy = vulkan::CopyToCpu(context, allocator, queue, *pooled, buffer.bytes().size());
        pooled->lastUse = copy->number();
        return copy;
    }

    /// Finishes the copies that are under way.
    void FinishCopies()
    {
        // A callback may begin others.
        for (const auto& copy : std::vector(copies))
        {
            copy->Finish(false);
        }
        std::erase_if(copies, [](const auto& copy) { return copy->isDone(); });
    }

    vulkan::VulkanContext context;
    vulkan::MemoryAllocator allocator;
    vulkan::DeviceResources resources;
    vulkan::FrameSlots slots;
    vulkan::PreparedFrame prepared; ///< of the last frame
    std::uint64_t timedFrame = 0;
    std::uint64_t recordedFrames = 0;
    Timeline* timeline = nullptr; ///< may be null
    std::vector<PassTiming> timings;
    TextureStates textureStates;     ///< after the last frame submitted
    std::uint64_t lastStructure = 0; ///< of that frame
    vulkan::SubmitQueue queue;
    std::vector<std::shared_ptr<vulkan::ReadBackCopy>> copies; ///< that are under way
};

VulkanDevice::VulkanDevice(const VulkanDeviceOptions& options)
    : m_Impl(std::make_unique<Impl>(options))
{
}

VulkanDevice::~VulkanDevice() = default;

void VulkanDevice::Execute(const CompiledFrame& frame)
{
    m_Impl->FinishCopies();
    vulkan::FrameSlot& slot = m_Impl->TakeSlot(frame.structure);
    m_Impl->resources.Sweep(m_Impl->queue.finishedNumber());
    m_Impl->allocator.Sweep();
    m_Impl->Record(frame, slot);
    m_Impl->resources.images.Commit();
    if (frame.structure == 0 || frame.structure != m_Impl->lastStructure)
    {
        m_Impl->textureStates = frame.states;
        m_Impl->lastStructure = frame.structure;
    }
}

void VulkanDevice::Wait()
{
    m_Impl->queue.Wait(m_Impl->queue.lastNumber());
    m_Impl->FinishCopies();
}

namespace
{

VkImageAspectFlagBits AspectOf(const RenderTexture& texture)
{
    return IsDepthFormat(texture.graphicsFormat()) ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                   : VK_IMAGE_ASPECT_COLOR_BIT;
}

} // namespace

Image VulkanDevice::ReadBack(const RenderTexture& texture)
{
    return m_Impl->ReadBack(texture, AspectOf(texture));
}

std::vector<std::byte> VulkanDevice::ReadBackBuffer(const GraphicsBuffer& buffer)
{
    return Measure(m_Impl->timeline, "wait",
                   [&] { return m_Impl->Copy(buffer)->WaitAndTake().texels; });
}

std::shared_ptr<PendingReadback> VulkanDevice::BeginReadBack(const RenderTexture& texture)
{
    return m_Impl->copies.emplace_back(m_Impl->Copy(texture, AspectOf(texture)));
}

std::shared_ptr<PendingReadback> VulkanDevice::BeginReadBack(const GraphicsBuffer& buffer)
{
    return m_Impl->copies.emplace_back(m_Impl->Copy(buffer));
}

double VulkanDevice::MeasureCopyBandwidth()
{
    return vulkan::MeasureCopyBandwidth(m_Impl->context, m_Impl->allocator, m_Impl->queue);
}

Image VulkanDevice::ReadBackStencil(const RenderTexture& texture)
{
    if (!HasStencil(texture.graphicsFormat()))
    {
        throw ContractError("texture '" + texture.name() + "' has no stencil to read back: it is " +
                            ToString(texture.graphicsFormat()) + ", not D32_SFloat_S8_UInt");
    }
    return m_Impl->ReadBack(texture, VK_IMAGE_ASPECT_STENCIL_BIT);
}

std::vector<PassTiming> VulkanDevice::LastFrameTimings()
{
    const std::uint64_t finished = m_Impl->queue.finishedNumber();
    for (vulkan::FrameSlot& slot : m_Impl->slots)
    {
        if (slot.number() <= finished)
        {
            m_Impl->KeepTimings(slot);
        }
    }
    return m_Impl->timings;
}

TextureFootprint VulkanDevice::Footprint(const RenderTexture& texture)
{
    return m_Impl->resources.images.Footprint(texture);
}

void VulkanDevice::SetTimeline(Timeline* timeline)
{
    m_Impl->timeline = timeline;
}

const TextureStates& VulkanDevice::textureStates() const
{
    return m_Impl->textureStates;
}

int VulkanDevice::GetRenderTextureSupportedMSAASampleCount(
    const RenderTextureDescriptor& descriptor) const
{
    return vulkan::SupportedSampleCount(m_Impl->context, RenderTexture("", descriptor));
}

bool VulkanDevice::IsFormatSupported(GraphicsFormat format, FormatUsage usage) const
{
    return vulkan::IsFormatSupported(m_Impl->context, format, usage);
}

const std::vector<std::string>& VulkanDevice::missingShaderFeatures() const
{
    return m_Impl->context.capabilities().missingShaderFeatures;
}

const std::string& VulkanDevice::deviceName() const
{
    return m_Impl->context.deviceName();
}

const std::string& VulkanDevice::ChoiceSentence() const
{
    return m_Impl->context.choiceSentence();
}

std::vector<ValidationMessage> VulkanDevice::validationMessages() const
{
    return m_Impl->context.instance().log().messages();
}

VulkanDeviceStatistics VulkanDevice::statistics() const
{
    VulkanDeviceStatistics statistics;
    statistics.allocatedBytes = m_Impl->allocator.allocatedBytes();
    statistics.usedBytes = m_Impl->allocator.usedBytes();
    statistics.images = m_Impl->resources.images.size();
    statistics.meshes = m_Impl->resources.meshes.size();
    statistics.meshUploads = m_Impl->resources.meshes.uploadCount();
    for (const vulkan::FrameSlot& slot : m_Impl->slots)
    {
        statistics.descriptorWrites += slot.descriptors().writeCount();
    }
    statistics.recordedFrames = m_Impl->recordedFrames;
    statistics.pipelines = m_Impl->resources.programs.pipelineCount();
    return statistics;
}

} // namespace limn

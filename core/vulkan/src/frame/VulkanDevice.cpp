#include <limn/core/Timeline.h>
#include <limn/vulkan/VulkanDevice.h>

#include "device/Translate.h"
#include "frame/FrameRecorder.h"
#include "resources/ImageSupport.h"
#include "submit/CopyBandwidth.h"
#include "submit/ReadBackCopy.h"

namespace limn
{

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
    vulkan::FrameSlot& TakeSlot(std::uint64_t structure);
    void Record(const CompiledFrame& frame, vulkan::FrameSlot& slot);
    void KeepTimings(vulkan::FrameSlot& slot);
    Image ReadBack(const RenderTexture& texture, VkImageAspectFlagBits aspect);
    std::shared_ptr<vulkan::ReadBackCopy> Copy(const RenderTexture& texture,
                                               VkImageAspectFlagBits aspect);
    std::shared_ptr<vulkan::ReadBackCopy> Copy(const GraphicsBuffer& buffer);
    /// Finishes the copies that are under way.
    void FinishCopies();

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

vulkan::FrameSlot& VulkanDevice::Impl::TakeSlot(std::uint64_t structure)
{
    Measure(timeline, "wait for a slot", [&] { queue.Wait(slots.beforeLast()); });
    vulkan::FrameSlot& slot = slots.Take(structure);
    KeepTimings(slot);
    return slot;
}

void VulkanDevice::Impl::Record(const CompiledFrame& frame, vulkan::FrameSlot& slot)
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

void VulkanDevice::Impl::KeepTimings(vulkan::FrameSlot& slot)
{
    if (slot.number() > timedFrame)
    {
        slot.ReadTimings(timings);
        timedFrame = slot.number();
    }
}

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

void VulkanDevice::Impl::FinishCopies()
{
    // A callback may begin others.
    for (const auto& copy : std::vector(copies))
    {
        copy->Finish(false);
    }
    std::erase_if(copies, [](const auto& copy) { return copy->isDone(); });
}

std::shared_ptr<vulkan::ReadBackCopy> VulkanDevice::Impl::Copy(const RenderTexture& texture,
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

std::shared_ptr<vulkan::ReadBackCopy> VulkanDevice::Impl::Copy(const GraphicsBuffer& buffer)
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

Image VulkanDevice::Impl::ReadBack(const RenderTexture& texture, VkImageAspectFlagBits aspect)
{
    Image image = Measure(timeline, "wait", [&] { return Copy(texture, aspect)->WaitAndTake(); });
    if (!texture.descriptor().isTopRowFirst)
    {
        image.texels = FlipRows(image.texels, image.height);
    }
    return image;
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
    statistics.sharedBytes = m_Impl->resources.images.sharedSize();
    statistics.images = m_Impl->resources.images.size();
    statistics.meshes = m_Impl->resources.meshes.size();
    statistics.meshUploads = m_Impl->resources.meshes.uploadCount();
    for (const vulkan::FrameSlot& slot : m_Impl->slots)
    {
        statistics.descriptorSets += slot.descriptors().size();
        statistics.descriptorWrites += slot.descriptors().writeCount();
    }
    statistics.recordedFrames = m_Impl->recordedFrames;
    statistics.pipelines = m_Impl->resources.programs.pipelineCount();
    return statistics;
}

} // namespace limn

#include "resources/ImagePool.h"

#include "device/Check.h"
#include "resources/ImageSupport.h"
#include <algorithm>

namespace limn::vulkan
{

namespace
{

/// Images that ask for more have memory of their own.
constexpr VkDeviceSize k_SharedAlignment = 65536;

VkImageMemoryBarrier2 ScopeBarrier(const PooledImage& image, const UsageScope& from,
                                   const UsageScope& to)
{
    return ImageBarrier(image.image.get(),
                        {image.aspects, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS},
                        from, to);
}

/// Returns the uses that must end before something begins that ignores the image's contents.
UsageScope ScopeToForget(const PooledImage& image, TextureUsage last)
{
    if (image.shared) // others were in its place
    {
        return ToUsageScope(TextureUsage::Undefined);
    }
    if (last == TextureUsage::Undefined) // nobody has used it, and its memory only in frames done
    {
        return {};
    }
    UsageScope scope = ToUsageScope(last, image.samples, image.use.readers);
    scope.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    return scope;
}

void RecordCopy(UploadCommands& uploads, const PooledImage& image, const TexelTexture& texture)
{
    const UploadedBytes bytes = uploads.staging().Upload(texture.texels());
    const auto texel = static_cast<VkDeviceSize>(BytesPerTexel(texture.graphicsFormat()));
    const auto levels = static_cast<std::uint32_t>(texture.levelsOfTexels());
    std::vector<VkBufferImageCopy> regions(levels);
    VkDeviceSize offset = bytes.offset;
    for (std::uint32_t level = 0; level < levels; ++level)
    {
        VkBufferImageCopy& region = regions[level];
        region.bufferOffset = offset;
        region.imageSubresource = {image.aspects, level, 0, LayerCount(texture)};
        region.imageExtent = Extent(texture, level);
        offset += texel * region.imageExtent.width * region.imageExtent.height *
                  region.imageExtent.depth * LayerCount(texture);
    }
    vkCmdCopyBufferToImage(uploads.commands(), bytes.buffer, image.image.get(),
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, levels, regions.data());
}

/// Returns whether the device makes mip levels after the texels are there.
bool HasMipsToMake(const TexelTexture& texture)
{
    return texture.levelsOfTexels() < texture.mipmapCount();
}

constexpr UsageScope k_Source{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                              VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
constexpr UsageScope k_Target{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};

VkOffset3D End(const Texture& texture, std::uint32_t level)
{
    const VkExtent3D size = Extent(texture, level);
    return {static_cast<std::int32_t>(size.width), static_cast<std::int32_t>(size.height),
            static_cast<std::int32_t>(size.depth)};
}

/// Records the copy from the level before.
void RecordBlit(VkCommandBuffer commands, VkImage image, const Texture& texture,
                std::uint32_t level)
{
    VkImageBlit region{};
    region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level - 1, 0, LayerCount(texture)};
    region.srcOffsets[1] = End(texture, level - 1);
    region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, LayerCount(texture)};
    region.dstOffsets[1] = End(texture, level);
    vkCmdBlitImage(commands, image, k_Source.layout, image, k_Target.layout, 1, &region,
                   VK_FILTER_LINEAR);
}

} // namespace

void ChangeUsage(PooledImage& image, const TextureBarrier& change,
                 std::vector<VkImageMemoryBarrier2>& barriers)
{
    const bool isWorthless = change.before == TextureUsage::Undefined;
    const auto from = [&](TextureUsage last)
    {
        return isWorthless ? ScopeToForget(image, last)
                           : ToUsageScope(last, image.samples, image.use.readers);
    };
    const UsageScope to = ToUsageScope(change.after, image.samples, change.readers);
    if (image.samples == 1)
    {
        barriers.push_back(ScopeBarrier(image, from(image.use.usage), to));
    }
    else
    {
        const bool isDepth = (image.aspects & VK_IMAGE_ASPECT_COLOR_BIT) == 0;
        const TextureUsage drawn =
            isDepth ? TextureUsage::DepthStencilAttachment : TextureUsage::ColorAttachment;
        if (isWorthless || change.after == drawn)
        {
            barriers.push_back(
                ScopeBarrier(image, from(drawn), ToUsageScope(drawn, image.samples)));
        }
        if (image.resolved)
        {
            barriers.push_back(ScopeBarrier(image, from(image.use.resolvedUsage), to));
            barriers.back().image = image.resolved->image.get();
            image.use.resolvedUsage = change.after;
        }
    }
    image.use.usage = change.after;
    image.use.readers = change.readers;
}

ImagePool::ImagePool(const VulkanContext& context, MemoryAllocator& allocator)
    : m_Context(context), m_Allocator(allocator)
{
}

PooledImage& ImagePool::Use(const std::shared_ptr<const Texture>& texture, std::uint64_t number)
{
    const auto found = m_Images.find(texture->id());
    if (found == m_Images.end())
    {
        return Add(texture, number, nullptr);
    }
    const bool isPlaced = std::ranges::find(m_Placed, texture->id()) != m_Placed.end();
    if (found->second.shared && !isPlaced)
    {
        Retire(texture->id(), number); // others have its place now
        return Add(texture, number, nullptr);
    }
    found->second.lastUse = number;
    return found->second;
}

PooledImage& ImagePool::Add(const std::shared_ptr<const Texture>& texture, std::uint64_t number,
                            const PlacedTexture* place)
{
    PooledImage image;
    image.owner = texture;
    image.name = texture->name();
    image.createdBy = number;
    image.lastUse = number;
    image.samples = SampleCount(*texture);
    Create(image, *texture, place);
    PooledImage& stored = m_Images.emplace(texture->id(), std::move(image)).first->second;
    if (auto source = std::dynamic_pointer_cast<const TexelTexture>(texture))
    {
        stored.use.usage = TextureUsage::ShaderRead; // before the frame's first pass
        stored.submitted = stored.use;
        m_Uploads.push_back({&stored, std::move(source)});
    }
    return stored;
}

TextureFootprint ImagePool::Footprint(const RenderTexture& texture)
{
    const RenderTextureDescriptor& descriptor = texture.descriptor();
    if (descriptor.msaaSamples > 1)
    {
        return {};
    }
    const std::uint64_t isWritten = descriptor.enableRandomWrite ? 1 : 0;
    const auto key = (isWritten << 63U) |
                     (static_cast<std::uint64_t>(texture.graphicsFormat()) << 48U) |
                     (static_cast<std::uint64_t>(texture.width()) << 26U) |
                     (static_cast<std::uint64_t>(texture.height()) << 5U) |
                     static_cast<std::uint64_t>(texture.mipmapCount());
    const auto [found, isNew] = m_Footprints.try_emplace(key);
    if (isNew)
    {
        const VkImageCreateInfo info = Describe(texture, 1);
        RequireSupport(m_Context, info, texture);
        const UniqueImage image = CreateUnbound(info, texture.name());
        VkMemoryRequirements needs{};
        vkGetImageMemoryRequirements(m_Context.device(), image.get(), &needs);
        if (needs.alignment <= k_SharedAlignment)
        {
            found->second = {needs.size, needs.alignment, needs.memoryTypeBits};
        }
    }
    return found->second;
}

void ImagePool::Place(const std::vector<PlacedTexture>& placed, std::uint64_t number)
{
    Grow(placed);
    m_Placed.clear();
    for (const PlacedTexture& place : placed)
    {
        const std::uint64_t id = place.texture->id();
        m_Placed.push_back(id);
        const auto found = m_Images.find(id);
        if (found != m_Images.end() && found->second.shared == m_Shared.at(place.kind).memory &&
            found->second.sharedOffset == place.offset)
        {
            continue;
        }
        Retire(id, number);
        Add(place.texture, number, &place);
    }
}

/// Images in what was too small keep it until they move.
void ImagePool::Grow(const std::vector<PlacedTexture>& placed)
{
    for (const PlacedTexture& place : placed)
    {
        SharedMemory& shared = m_Shared[place.kind];
        shared.needed = std::max(shared.needed, place.offset + place.size);
    }
    for (auto& [kind, shared] : m_Shared)
    {
        if (shared.size < shared.needed)
        {
            VkMemoryRequirements needs{};
            needs.size = shared.needed;
            needs.alignment = k_SharedAlignment;
            needs.memoryTypeBits = kind;
            shared.memory = std::make_shared<MemoryAllocation>(m_Allocator.Allocate(
                needs, MemoryUse::Gpu, MemoryContent::Images, "memory that textures share"));
            shared.size = shared.needed;
            ++m_Changes;
        }
    }
}

void ImagePool::Retire(std::uint64_t id, std::uint64_t number)
{
    const auto found = m_Images.find(id);
    if (found != m_Images.end())
    {
        m_Retired.push_back({id, std::move(found->second), number});
        m_Images.erase(found);
        ++m_Changes;
    }
}

PooledImage& ImagePool::UseResolved(const std::shared_ptr<const Texture>& texture,
                                    std::uint64_t number)
{
    PooledImage& image = Use(texture, number);
    if (image.samples > 1 && !image.resolved)
    {
        CreateResolved(image, *texture);
    }
    return image;
}

void ImagePool::RecordUploads(UploadCommands& uploads)
{
    if (m_Uploads.empty())
    {
        return;
    }
    constexpr UsageScope k_TexelsCopied{VK_PIPELINE_STAGE_2_COPY_BIT,
                                        VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                        VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
    const UsageScope read = ToUsageScope(TextureUsage::ShaderRead);
    std::vector<VkImageMemoryBarrier2> before;
    std::vector<VkImageMemoryBarrier2> after;
    for (const Upload& upload : m_Uploads)
    {
        before.push_back(ScopeBarrier(*upload.image, {}, k_TexelsCopied));
        if (!HasMipsToMake(*upload.texture))
        {
            after.push_back(ScopeBarrier(*upload.image, k_TexelsCopied, read));
        }
    }
    RecordBarriers(uploads.commands(), before);
    for (const Upload& upload : m_Uploads)
    {
        RecordCopy(uploads, *upload.image, *upload.texture);
        if (HasMipsToMake(*upload.texture))
        {
            RecordMips(uploads.commands(), upload.image->image.get(), *upload.texture,
                       k_TexelsCopied, read);
        }
    }
    RecordBarriers(uploads.commands(), after);
    m_Uploads.clear();
}

void ImagePool::Commit()
{
    for (auto& [id, image] : m_Images)
    {
        image.submitted = image.use;
    }
}

void ImagePool::Rollback(std::uint64_t number) noexcept
{
    m_Uploads.clear();
    ++m_Changes;
    ErasePooledOf(m_Images, number);
    for (Retired& retired : m_Retired)
    {
        if (retired.number == number)
        {
            m_Images[retired.id] = std::move(retired.image);
        }
    }
    std::erase_if(m_Retired, [&](const Retired& retired) { return retired.number == number; });
    for (auto& [id, image] : m_Images)
    {
        image.use = image.submitted;
    }
    UndoPooledUses(m_Images, number);
}

void ImagePool::Sweep(std::uint64_t finished)
{
    m_Changes += std::erase_if(m_Retired, [&](const Retired& retired)
                               { return retired.image.lastUse <= finished; });
    m_Changes += SweepPooled(m_Images, finished);
    std::erase_if(m_Shared, [](const auto& entry) { return entry.second.memory.use_count() == 1; });
}

void ImagePool::Create(PooledImage& image, const Texture& texture, const PlacedTexture* place) const
{
    image.isRenderTexture = dynamic_cast<const RenderTexture*>(&texture) != nullptr;
    image.aspects = Aspects(texture.graphicsFormat());
    const VkImageCreateInfo info = Describe(texture, image.samples);
    RequireSupport(m_Context, info, texture);
    if (place != nullptr)
    {
        image.shared = m_Shared.at(place->kind).memory;
        image.sharedOffset = place->offset;
        image.image = CreateUnbound(info, image.name);
        Bind(image.image, *image.shared, place->offset, image.name);
    }
    else
    {
        image.image = CreateImage(info, image.name, image.memory);
    }
    if (image.samples == 1)
    {
        CreateViews(image, texture);
    }
    else
    {
        image.view = CreateView(image.image.get(), texture, image.aspects);
    }
}

void ImagePool::CreateResolved(PooledImage& image, const Texture& texture)
{
    const VkImageCreateInfo info = Describe(texture, 1);
    RequireSupport(m_Context, info, texture);
    ImageObjects resolved;
    resolved.image = CreateImage(info, image.name + " (resolved)", resolved.memory);
    CreateViews(resolved, texture);
    image.resolved = std::move(resolved);
    ++m_Changes;
}

UniqueImage ImagePool::CreateUnbound(const VkImageCreateInfo& info, const std::string& name) const
{
    return {m_Context.device(), vkCreateImage, info, "vkCreateImage", name};
}

void ImagePool::Bind(const UniqueImage& image, const MemoryAllocation& memory, VkDeviceSize offset,
                     const std::string& name) const
{
    Check(vkBindImageMemory(m_Context.device(), image.get(), memory.memory(),
                            memory.offset() + offset),
          "vkBindImageMemory", name);
    m_Context.SetName(VK_OBJECT_TYPE_IMAGE, image.get(), name);
}

UniqueImage ImagePool::CreateImage(const VkImageCreateInfo& info, const std::string& name,
                                   MemoryAllocation& memory) const
{
    UniqueImage image = CreateUnbound(info, name);
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(m_Context.device(), image.get(), &needs);
    const bool isTransient = (info.usage & VK_IMAGE_USAGE_TRANSIENT_ATTACHMENT_BIT) != 0;
    memory = m_Allocator.Allocate(needs, isTransient ? MemoryUse::Transient : MemoryUse::Gpu,
                                  MemoryContent::Images, name);
    Bind(image, memory, 0, name);
    return image;
}

void ImagePool::CreateViews(ImageObjects& objects, const Texture& texture) const
{
    const VkImage image = objects.image.get();
    const VkImageAspectFlags aspects = Aspects(texture.graphicsFormat());
    objects.view = CreateView(image, texture, aspects);
    if (texture.mipmapCount() > 1)
    {
        objects.mipView = CreateView(image, texture, aspects, texture.mipmapCount());
    }
    if (HasStencil(texture.graphicsFormat()))
    {
        objects.depthView = CreateView(image, texture, VK_IMAGE_ASPECT_DEPTH_BIT);
    }
}

UniqueImageView ImagePool::CreateView(VkImage image, const Texture& texture,
                                      VkImageAspectFlags aspects, int mipCount) const
{
    auto info = Make<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    info.image = image;
    info.viewType = ViewType(texture.dimension());
    info.format = ToVkFormat(texture.graphicsFormat());
    info.subresourceRange = {aspects, 0, static_cast<std::uint32_t>(mipCount), 0,
                             LayerCount(texture)};
    return {m_Context.device(), vkCreateImageView, info, "vkCreateImageView", texture.name()};
}

void RecordMips(VkCommandBuffer commands, VkImage image, const Texture& texture,
                const UsageScope& before, const UsageScope& after)
{
    const auto change =
        [&](std::uint32_t first, std::uint32_t count, const UsageScope& from, const UsageScope& to)
    {
        const VkImageMemoryBarrier2 barrier = ImageBarrier(
            image, {VK_IMAGE_ASPECT_COLOR_BIT, first, count, 0, VK_REMAINING_ARRAY_LAYERS}, from,
            to);
        RecordBarriers(commands, {&barrier, 1});
    };
    const auto count = static_cast<std::uint32_t>(texture.mipmapCount());
    change(0, 1, before, k_Source);
    change(1, count - 1, {before.stages, before.access}, k_Target); // what is in them is worthless
    for (std::uint32_t level = 1; level < count; ++level)
    {
        RecordBlit(commands, image, texture, level);
        change(level, 1, k_Target, k_Source);
    }
    change(0, count, k_Source, after);
}

} // namespace limn::vulkan

#pragma once

#include "device/VulkanContext.h"
#include "memory/UploadCommands.h"
#include "resources/Pooled.h"
#include <limn/core/FrameCompiler.h>

namespace limn::vulkan
{

/// An image with its memory and the views of it.
struct ImageObjects
{
    MemoryAllocation memory;                  ///< empty if it lies in shared memory
    std::shared_ptr<MemoryAllocation> shared; ///< null if it has its own memory
    UniqueImage image;
    UniqueImageView view;      ///< all aspects of mip level 0, for attachments
    UniqueImageView depthView; ///< the depth alone, if there is also stencil
    UniqueImageView mipView;   ///< all mip levels, if there are several
};

/// The use of an image, and that of its samples.
struct ImageUse
{
    TextureUsage usage = TextureUsage::Undefined;
    TextureUsage resolvedUsage = TextureUsage::Undefined; ///< the use of PooledImage::resolved
    bool isStale = false;                    ///< the last draw into the samples is not resolved yet
    ShaderStage readers = ShaderStage::None; ///< see TextureBarrier

    bool operator==(const ImageUse&) const = default;
};

/// The image behind one texture.
struct PooledImage : ImageObjects
{
    std::weak_ptr<const Texture> owner;
    std::string name;
    std::uint64_t sharedOffset = 0; ///< from the beginning of `shared`
    /// The image with one sample per texel that readers of a texture with several samples see, once
    /// there are readers. It changes its use like the texture, while the samples stay an
    /// attachment.
    std::optional<ImageObjects> resolved;
    VkImageAspectFlags aspects = 0;
    std::uint32_t samples = 1; ///< samples per texel
    bool isRenderTexture = false;
    ImageUse use;                ///< after the passes prepared so far
    ImageUse submitted;          ///< after the last submission
    std::uint64_t createdBy = 0; ///< number of the submission
    std::uint64_t lastUse = 0;   ///< likewise

    /// Returns the objects that readers see.
    const ImageObjects& read() const { return resolved ? *resolved : *this; }
    VkImageView sampledView() const
    {
        const ImageObjects& from = read();
        return from.depthView ? from.depthView.get()
               : from.mipView ? from.mipView.get()
                              : from.view.get();
    }
};

/// All images, found by their texture. An image is made on first use and freed when the texture is
/// gone and the GPU is done with it.
class ImagePool
{
public:
    ImagePool(const VulkanContext& context, MemoryAllocator& allocator);

    /// Returns the size that the texture's image would take in shared memory; size 0 if it cannot
    /// share memory.
    TextureFootprint Footprint(const RenderTexture& texture);

    /// Must be called before everything else of a frame. Places these textures in shared memory,
    /// and no others. A texture that moves loses its content.
    void Place(const std::vector<PlacedTexture>& placed, std::uint64_t number);

    /// Returns the texture's image, which submission `number` uses. The texels of a TexelTexture
    /// are queued for RecordUploads.
    /// @throws ContractError if the device cannot make such an image
    PooledImage& Use(const std::shared_ptr<const Texture>& texture, std::uint64_t number);

    /// Returns the texture's image like Use. Also makes the image into which several samples are
    /// resolved.
    PooledImage& UseResolved(const std::shared_ptr<const Texture>& texture, std::uint64_t number);

    /// Returns the texture's image, or null if no frame has used the texture.
    PooledImage* Find(const Texture& texture) { return FindPooled(m_Images, texture.id()); }

    /// Records the copies of all queued texels.
    void RecordUploads(UploadCommands& uploads);

    /// Calls `function` with each image that submission `number` uses.
    template <typename Function>
    void ForEachUsed(std::uint64_t number, const Function& function)
    {
        for (auto& [id, image] : m_Images)
        {
            if (image.lastUse == number)
            {
                function(image);
            }
        }
    }
    void Commit();                                ///< the prepared frame is submitted
    void Rollback(std::uint64_t number) noexcept; ///< the frame will never be submitted
    void Sweep(std::uint64_t finished);           ///< frees images that have no owner and no use

    std::size_t size() const { return m_Images.size(); }
    /// Returns a count that grows whenever an image is destroyed or moved.
    std::uint64_t changeCount() const { return m_Changes; }

private:
    struct Upload
    {
        PooledImage* image = nullptr;
        std::shared_ptr<const TexelTexture> texture;
    };

    /// An image that another image of the same texture has replaced.
    struct Retired
    {
        std::uint64_t id = 0; ///< Texture::id
        PooledImage image;
        std::uint64_t number = 0; ///< the number of the submission that moved it
    };

    /// Memory that textures share.
    struct SharedMemory
    {
        std::shared_ptr<MemoryAllocation> memory;
        VkDeviceSize size = 0;
        VkDeviceSize needed = 0; ///< the size that the frames so far needed
    };

    PooledImage& Add(const std::shared_ptr<const Texture>& texture, std::uint64_t number,
                     const PlacedTexture* place);
    void Retire(std::uint64_t id, std::uint64_t number);
    void Grow(const std::vector<PlacedTexture>& placed);
    void Create(PooledImage& image, const Texture& texture, const PlacedTexture* place) const;
    void CreateResolved(PooledImage& image, const Texture& texture);
    UniqueImage CreateUnbound(const VkImageCreateInfo& info, const std::string& name) const;
    UniqueImage CreateImage(const VkImageCreateInfo& info, const std::string& name,
                            MemoryAllocation& memory) const;
    void Bind(const UniqueImage& image, const MemoryAllocation& memory, VkDeviceSize offset,
              const std::string& name) const;
    UniqueImageView CreateView(VkImage image, const Texture& texture, VkImageAspectFlags aspects,
                               int mipCount = 1) const;
    /// Makes the views that readers need.
    void CreateViews(ImageObjects& objects, const Texture& texture) const;

    const VulkanContext& m_Context;
    MemoryAllocator& m_Allocator;
    std::unordered_map<std::uint64_t, PooledImage> m_Images; ///< by Texture::id
    std::vector<Upload> m_Uploads;
    std::uint64_t m_Changes = 0;
    std::vector<Retired> m_Retired;                 ///< the GPU may still use them
    std::map<std::uint32_t, SharedMemory> m_Shared; ///< by TextureFootprint::kind
    std::unordered_map<std::uint64_t, TextureFootprint> m_Footprints; ///< by format and size
    std::vector<std::uint64_t> m_Placed; ///< ids of the textures of this frame that share memory
};

/// Adds the barriers that change the texture's use, and records its new use.
/// @pre `change.before` is Undefined, or the use it has
void ChangeUsage(PooledImage& image, const TextureBarrier& change,
                 std::vector<VkImageMemoryBarrier2>& barriers);

/// Makes mip levels 1, 2 ... of a colour texture, each from the level before by the device's linear
/// filter.
/// @param image  all its levels and layers change from the use `before` to the use `after`; all
///     levels but 0 lose their content
void RecordMips(VkCommandBuffer commands, VkImage image, const Texture& texture,
                const UsageScope& before, const UsageScope& after);

} // namespace limn::vulkan

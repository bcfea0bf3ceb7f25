#pragma once

#include "device/VulkanContext.h"
#include "memory/UploadCommands.h"
#include <limn/core/FrameCompiler.h>
#include <map>
#include <unordered_map>

namespace limn::vulkan
{

/// One sample a texel of an image with several: what readers of the texture get to see. It goes
/// from use to use as the texture does, while the samples stay an attachment.
struct ResolvedImage
{
    MemoryAllocation memory;
    UniqueImage image;
    UniqueImageView view;
    UniqueImageView depthView;
    UniqueImageView mipView;
};

/// What an image is used for, and what its samples are.
struct ImageUse
{
    TextureUsage usage = TextureUsage::Undefined;
    TextureUsage resolvedUsage = TextureUsage::Undefined; ///< of PooledImage::resolved
    bool isStale = false;                    ///< what samples were drawn last is not resolved
    ShaderStage readers = ShaderStage::None; ///< see TextureBarrier

    bool operator==(const ImageUse&) const = default;
};

/// The image behind one texture.
struct PooledImage
{
    std::weak_ptr<const Texture> owner;
    std::string name;
    MemoryAllocation memory;                  ///< empty where it lies in shared memory
    std::shared_ptr<MemoryAllocation> shared; ///< null where it has its own
    std::uint64_t sharedOffset = 0;           ///< from the beginning of `shared`
    UniqueImage image;
    UniqueImageView view;                  ///< all aspects of mip level 0, for attachments
    UniqueImageView depthView;             ///< the depth alone, where there is stencil too
    UniqueImageView mipView;               ///< all mip levels, where there are several
    std::optional<ResolvedImage> resolved; ///< of several samples, once something reads them
    VkImageAspectFlags aspects = 0;
    std::uint32_t samples = 1; ///< a texel
    bool isRenderTexture = false;
    ImageUse use;                ///< after what is prepared so far
    ImageUse submitted;          ///< after the last submission
    std::uint64_t createdBy = 0; ///< number of the submission
    std::uint64_t lastUse = 0;   ///< likewise

    VkImage readImage() const { return resolved ? resolved->image.get() : image.get(); }
    VkImageView resolveView() const { return resolved ? resolved->view.get() : view.get(); }
    VkImageView sampledView() const
    {
        const UniqueImageView& whole = resolved ? resolved->view : view;
        const UniqueImageView& depth = resolved ? resolved->depthView : depthView;
        const UniqueImageView& mips = resolved ? resolved->mipView : mipView;
        return depth ? depth.get() : mips ? mips.get() : whole.get();
    }
};

/// All images, found by their texture; made on first use, freed when the texture is gone and the
/// GPU is done with it.
class ImagePool
{
public:
    ImagePool(const VulkanContext& context, MemoryAllocator& allocator);

    /// What its image would take of memory that it shares; size 0 if it cannot.
    TextureFootprint Footprint(const RenderTexture& texture);

    /// Before all else of a frame: from now on these textures lie there, and no others in shared
    /// memory. What a texture held is lost where it moves.
    void Place(const std::vector<PlacedTexture>& placed, std::uint64_t number);

    /// The texture's image, used by submission `number`; a TexelTexture's texels are queued for
    /// RecordUploads.
    /// @throws ContractError if the device cannot make such an image
    PooledImage& Use(const std::shared_ptr<const Texture>& texture, std::uint64_t number);

    /// As Use, and what several samples are resolved to is there.
    PooledImage& UseResolved(const std::shared_ptr<const Texture>& texture, std::uint64_t number);

    /// Null if no frame has used the texture.
    PooledImage* Find(const Texture& texture);
    const PooledImage* Find(const Texture& texture) const;

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
    void Commit();                                ///< what was prepared is submitted
    void Rollback(std::uint64_t number) noexcept; ///< it never will be
    void Sweep(std::uint64_t finished);           ///< frees what nobody owns or uses

    std::size_t size() const { return m_Images.size(); }
    /// Grows where an image is not, or not where it was, any more.
    std::uint64_t changeCount() const { return m_Changes; }
    std::size_t sharedSize() const; ///< bytes of memory that textures share

private:
    struct Upload
    {
        PooledImage* image = nullptr;
        std::shared_ptr<const TexelTexture> texture;
    };

    /// An image that gave its place to another one of the same texture.
    struct Retired
    {
        std::uint64_t id = 0; ///< Texture::id
        PooledImage image;
        std::uint64_t number = 0; ///< of the submission that moved it
    };

    /// Memory that textures share.
    struct SharedMemory
    {
        std::shared_ptr<MemoryAllocation> memory;
        VkDeviceSize size = 0;
        VkDeviceSize needed = 0; ///< by the frames so far
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
    /// Null where there is one level only.
    UniqueImageView CreateMipView(VkImage image, const Texture& texture,
                                  VkImageAspectFlags aspects) const;

    const VulkanContext& m_Context;
    MemoryAllocator& m_Allocator;
    std::unordered_map<std::uint64_t, PooledImage> m_Images; ///< by Texture::id
    std::vector<Upload> m_Uploads;
    std::uint64_t m_Changes = 0;
    std::vector<Retired> m_Retired;                 ///< may be in use by the GPU still
    std::map<std::uint32_t, SharedMemory> m_Shared; ///< by TextureFootprint::kind
    std::unordered_map<std::uint64_t, TextureFootprint> m_Footprints; ///< by format and size
    std::vector<std::uint64_t> m_Placed; ///< ids of the textures of this frame that share memory
};

/// Adds the barriers that take the texture from one use to another, which it has then.
/// @pre `change.before` is Undefined, or the use it has
void ChangeUsage(PooledImage& image, const TextureBarrier& change,
                 std::vector<VkImageMemoryBarrier2>& barriers);

/// Records the barriers; nothing if there are none.
void RecordBarriers(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier2> barriers,
                    std::span<const VkMemoryBarrier2> memoryBarriers = {});

} // namespace limn::vulkan

#pragma once

#include "device/VulkanContext.h"
#include "memory/LinearMemory.h"
#include <limn/core/CompiledFrame.h>
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
    TextureUsage usage = TextureUsage::Undefined;
    TextureUsage submittedUsage = TextureUsage::Undefined;
};

/// The image behind one texture.
struct PooledImage
{
    std::weak_ptr<const Texture> owner;
    std::string name;
    MemoryAllocation memory;
    UniqueImage image;
    UniqueImageView view;                  ///< all aspects, for attachments
    UniqueImageView depthView;             ///< the depth alone, where there is stencil too
    std::optional<ResolvedImage> resolved; ///< of several samples, once something reads them
    VkImageAspectFlags aspects = 0;
    std::uint32_t samples = 1; ///< a texel
    bool isRenderTexture = false;
    bool isStale = false;                         ///< what samples were drawn last is not resolved
    bool submittedIsStale = false;                ///< likewise, after the last submission
    TextureUsage usage = TextureUsage::Undefined; ///< after what is recorded so far
    TextureUsage submittedUsage = TextureUsage::Undefined; ///< after the last submission
    std::uint64_t createdBy = 0;                           ///< number of the submission
    std::uint64_t lastUse = 0;                             ///< likewise

    VkImage readImage() const { return resolved ? resolved->image.get() : image.get(); }
    VkImageView resolveView() const { return resolved ? resolved->view.get() : view.get(); }
    VkImageView sampledView() const
    {
        const UniqueImageView& whole = resolved ? resolved->view : view;
        const UniqueImageView& depth = resolved ? resolved->depthView : depthView;
        return depth ? depth.get() : whole.get();
    }
};

/// All images, found by their texture; made on first use, freed when the texture is gone and the
/// GPU is done with it.
class ImagePool
{
public:
    ImagePool(const VulkanContext& context, MemoryAllocator& allocator);

    /// The texture's image, used by submission `number`; a TexelTexture's texels are queued for
    /// RecordUploads.
    /// @throws ContractError if the device cannot make such an image
    PooledImage& Use(const std::shared_ptr<const Texture>& texture, std::uint64_t number);

    /// As Use, and what several samples are resolved to is there.
    PooledImage& UseResolved(const std::shared_ptr<const Texture>& texture, std::uint64_t number);

    /// Null if no frame has used the texture.
    PooledImage* Find(const Texture& texture);
    const PooledImage* Find(const Texture& texture) const;

    /// Records the copies of all queued texels. @param commands  outside of a render pass
    void RecordUploads(VkCommandBuffer commands, LinearMemory& staging);

    void Commit();                                ///< what was recorded is submitted
    void Rollback(std::uint64_t number) noexcept; ///< it never will be
    void Sweep(std::uint64_t finished);           ///< frees what nobody owns or uses

    /// The samples a texel that the device does of the texture: at most as many as it has.
    int SupportedSampleCount(const RenderTexture& texture) const;

    std::size_t size() const { return m_Images.size(); }

private:
    struct Upload
    {
        PooledImage* image = nullptr;
        std::shared_ptr<const TexelTexture> texture;
    };

    void Create(PooledImage& image, const Texture& texture) const;
    void CreateResolved(PooledImage& image, const Texture& texture) const;
    void RequireSupport(const VkImageCreateInfo& info, const Texture& texture) const;
    UniqueImage CreateImage(const VkImageCreateInfo& info, const std::string& name,
                            MemoryAllocation& memory) const;
    UniqueImageView CreateView(VkImage image, const Texture& texture,
                               VkImageAspectFlags aspects) const;

    const VulkanContext& m_Context;
    MemoryAllocator& m_Allocator;
    std::unordered_map<std::uint64_t, PooledImage> m_Images; ///< by Texture::id
    std::vector<Upload> m_Uploads;
};

/// Adds the barriers that take the texture from one use to another, which it has then.
/// @param before  Undefined, or the use it has
void ChangeUsage(PooledImage& image, TextureUsage before, TextureUsage after,
                 std::vector<VkImageMemoryBarrier2>& barriers);

/// Records the barriers; nothing if there are none.
void RecordBarriers(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier2> barriers);

} // namespace limn::vulkan

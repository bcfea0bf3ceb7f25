#pragma once

#include "device/VulkanContext.h"
#include "memory/LinearMemory.h"
#include <limn/core/CompiledFrame.h>
#include <unordered_map>

namespace limn::vulkan
{

/// One sample a texel of a colour image with several: what readers of the texture get to see. Each
/// pass that stores the texture resolves into it; the two are in the same use always.
struct ResolvedImage
{
    MemoryAllocation memory;
    UniqueImage image;
    UniqueImageView view;
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
    std::optional<ResolvedImage> resolved; ///< of colour with several samples
    VkImageAspectFlags aspects = 0;
    std::uint32_t samples = 1; ///< a texel
    bool isRenderTexture = false;
    TextureUsage usage = TextureUsage::Undefined;          ///< after what is recorded so far
    TextureUsage submittedUsage = TextureUsage::Undefined; ///< after the last submission
    std::uint64_t createdBy = 0;                           ///< number of the submission
    std::uint64_t lastUse = 0;                             ///< likewise

    VkImage readImage() const { return resolved ? resolved->image.get() : image.get(); }
    VkImageView sampledView() const
    {
        const UniqueImageView& whole = resolved ? resolved->view : view;
        return depthView ? depthView.get() : whole.get();
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

    /// Null if no frame has used the texture.
    PooledImage* Find(const Texture& texture);

    /// Records the copies of all queued texels. @param commands  outside of a render pass
    void RecordUploads(VkCommandBuffer commands, LinearMemory& staging);

    void Commit();                                ///< what was recorded is submitted
    void Rollback(std::uint64_t number) noexcept; ///< it never will be
    void Sweep(std::uint64_t finished);           ///< frees what nobody owns or uses

    std::size_t size() const { return m_Images.size(); }

private:
    struct Upload
    {
        PooledImage* image = nullptr;
        std::shared_ptr<const TexelTexture> texture;
    };

    void Create(PooledImage& image, const Texture& texture) const;
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

/// A barrier over the whole image from one use to another; the resolved image needs one, too.
VkImageMemoryBarrier2 UsageBarrier(const PooledImage& image, TextureUsage before,
                                   TextureUsage after);

/// Records the barriers; nothing if there are none.
void RecordBarriers(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier2> barriers);

} // namespace limn::vulkan

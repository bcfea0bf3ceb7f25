#include "resources/MipChain.h"

#include "resources/ImageDescription.h"
#include <algorithm>

namespace limn::vulkan
{

namespace
{

constexpr UsageScope k_Source{VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_BLIT_BIT,
                              VK_ACCESS_2_TRANSFER_READ_BIT};
constexpr UsageScope k_Target{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_BLIT_BIT,
                              VK_ACCESS_2_TRANSFER_WRITE_BIT};

/// Commands that go from level to level.
class ChainRecorder
{
public:
    ChainRecorder(VkCommandBuffer commands, VkImage image, const Texture& texture)
        : m_Commands(commands), m_Image(image), m_Texture(texture)
    {
    }

    void Change(std::uint32_t first, std::uint32_t count, const UsageScope& before,
                const UsageScope& after) const
    {
        VkImageMemoryBarrier2 barrier{};
        barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
        barrier.srcStageMask = before.stages;
        barrier.srcAccessMask = before.access;
        barrier.dstStageMask = after.stages;
        barrier.dstAccessMask = after.access;
        barrier.oldLayout = before.layout;
        barrier.newLayout = after.layout;
        barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.image = m_Image;
        barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, first, count, 0,
                                    VK_REMAINING_ARRAY_LAYERS};
        VkDependencyInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
        info.imageMemoryBarrierCount = 1;
        info.pImageMemoryBarriers = &barrier;
        vkCmdPipelineBarrier2(m_Commands, &info);
    }

    /// From the level before.
    void Blit(std::uint32_t level) const
    {
        VkImageBlit region{};
        region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level - 1, 0, LayerCount(m_Texture)};
        region.srcOffsets[1] = Size(level - 1);
        region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, LayerCount(m_Texture)};
        region.dstOffsets[1] = Size(level);
        vkCmdBlitImage(m_Commands, m_Image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, m_Image,
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, VK_FILTER_LINEAR);
    }

private:
    VkOffset3D Size(std::uint32_t level) const
    {
        const VkExtent3D whole = Extent(m_Texture);
        const auto part = [level](std::uint32_t size)
        {
            return static_cast<std::int32_t>(std::max(size >> level, 1u));
        };
        return {part(whole.width), part(whole.height), part(whole.depth)};
    }

    VkCommandBuffer m_Commands;
    VkImage m_Image;
    const Texture& m_Texture;
};

} // namespace

void RecordMips(VkCommandBuffer commands, VkImage image, const Texture& texture,
                const UsageScope& before, const UsageScope& after)
{
    const ChainRecorder chain(commands, image, texture);
    const auto count = static_cast<std::uint32_t>(texture.mipmapCount());
    UsageScope worthless = before;
    worthless.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    chain.Change(0, 1, before, k_Source);
    chain.Change(1, count - 1, worthless, k_Target);
    for (std::uint32_t level = 1; level < count; ++level)
    {
        chain.Blit(level);
        chain.Change(level, 1, k_Target, k_Source);
    }
    chain.Change(0, count, k_Source, after);
}

} // namespace limn::vulkan

#pragma once

#include <limn/core/CompiledFrame.h>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

/// @throws ContractError if the format is None
VkFormat ToVkFormat(GraphicsFormat format);

/// Converts a comparison for a depth buffer where 1 is near, so nearer is greater. Disabled becomes
/// Always; the caller must turn the test off.
VkCompareOp ToReversedDepthCompare(CompareFunction function);

/// Converts a comparison for stencil values and depth buffers where 0 is near.
VkCompareOp ToStencilCompare(CompareFunction function);

VkStencilOp ToVkStencilOp(StencilOp op);
VkBlendFactor ToVkBlendFactor(BlendMode mode);

/// Returns whether the operation is a logical one, which replaces blending. isAdvanced returns
/// whether it is a blend operation that only some devices have.
constexpr bool isLogical(BlendOp op)
{
    return op >= BlendOp::LogicalClear && op <= BlendOp::LogicalOrInverted;
}
constexpr bool isAdvanced(BlendOp op)
{
    return op >= BlendOp::Multiply;
}
/// Converts a blend operation. A logical one becomes Add, because it turns blending off.
VkBlendOp ToVkBlendOp(BlendOp op);
/// @param op  must be a logical one
VkLogicOp ToVkLogicOp(BlendOp op);

VkCullModeFlags ToVkCullMode(CullMode mode);
/// @pre the device supports the topology
VkPrimitiveTopology ToVkTopology(MeshTopology topology);

/// Returns the winding of front faces: clockwise on the screen. The viewport's negative height
/// flips the picture before Vulkan tests the winding, so "clockwise" means the same to both.
VkFrontFace ToVkFrontFace(bool flipped);

/// Converts bits of ColorWriteMask.
VkColorComponentFlags ToVkColorMask(int writeMask);

VkShaderStageFlags ToVkStages(ShaderStage stages);

/// Returns the stages of the readers. For all readers, one bit stands for all stages before
/// rasterization that the device has.
/// @param readers  None = all
VkPipelineStageFlags2 ToPipelineStages(ShaderStage readers);

struct UsageScope
{
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED; ///< of an image
};

/// Returns the barrier between two uses of memory, or of levels of an image.
VkMemoryBarrier2 MemoryBarrier(const UsageScope& from, const UsageScope& to);
VkImageMemoryBarrier2 ImageBarrier(VkImage image, const VkImageSubresourceRange& range,
                                   const UsageScope& from, const UsageScope& to);

/// Returns the layout, stages and accesses of a use. Undefined waits for everything before, because
/// an earlier frame may still use the image's memory.
/// @param samples  the number of samples per texel; several are resolved in the stage that writes
///     colours, also those of depth
/// @param readers  see TextureBarrier
UsageScope ToUsageScope(TextureUsage usage, std::uint32_t samples = 1,
                        ShaderStage readers = ShaderStage::None);

VkMemoryBarrier2 ToMemoryBarrier(const BufferBarrier& barrier);

const char* ToString(TextureUsage usage);

VkAttachmentLoadOp ToVkLoadOp(LoadOp op);
VkAttachmentStoreOp ToVkStoreOp(StoreOp op);

/// Returns the ticks from one timestamp to a later one. Only the low bits of a timestamp count: the
/// counter wraps to 0 after them, and the other bits are undefined.
/// @param validBits  1...64
constexpr std::uint64_t ElapsedTicks(std::uint64_t begin, std::uint64_t end,
                                     std::uint32_t validBits)
{
    return (end - begin) & (~std::uint64_t{0} >> (64U - validBits));
}

} // namespace limn::vulkan

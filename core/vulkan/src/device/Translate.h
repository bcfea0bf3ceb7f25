#pragma once

#include <limn/core/CompiledFrame.h>
#include <vulkan/vulkan.h>

namespace limn::vulkan
{

/// @throws ContractError for None
VkFormat ToVkFormat(GraphicsFormat format);

/// Unity's compare as the device needs it: in a depth buffer where 1 is near, nearer is greater.
/// Disabled becomes Always; whoever calls turns the test off.
VkCompareOp ToReversedDepthCompare(CompareFunction function);

/// The same comparison, for stencil values and depth buffers where 0 is near.
VkCompareOp ToStencilCompare(CompareFunction function);

VkStencilOp ToVkStencilOp(StencilOp op);
VkBlendFactor ToVkBlendFactor(BlendMode mode);

/// Those that take the place of blending, and those that only some devices blend by.
constexpr bool isLogical(BlendOp op)
{
    return op >= BlendOp::LogicalClear && op <= BlendOp::LogicalOrInverted;
}
constexpr bool isAdvanced(BlendOp op)
{
    return op >= BlendOp::Multiply;
}
/// A logical one is Add: blending is off where it is used.
VkBlendOp ToVkBlendOp(BlendOp op);
/// @param op  a logical one
VkLogicOp ToVkLogicOp(BlendOp op);
VkConservativeRasterizationModeEXT ToVkConservative(bool conservative);

VkCullModeFlags ToVkCullMode(CullMode mode);
/// @pre the device draws it
VkPrimitiveTopology ToVkTopology(MeshTopology topology);

/// Clockwise as seen on screen is front. The viewport's negative height turns the picture over
/// before Vulkan looks at the winding, so "clockwise" means the same to both.
VkFrontFace ToVkFrontFace(bool flipped);

/// Bits of ColorWriteMask.
VkColorComponentFlags ToVkColorMask(int writeMask);

VkShaderStageFlags ToVkStages(ShaderStage stages);

/// That may read. The first bit of all of them is every one before rasterization that the device
/// has.
/// @param readers  None = all
VkPipelineStageFlags2 ToPipelineStages(ShaderStage readers);

VkMemoryBarrier2 ToMemoryBarrier(const BufferBarrier& barrier);

struct UsageScope
{
    VkImageLayout layout;
    VkPipelineStageFlags2 stages;
    VkAccessFlags2 access;
};

/// Undefined waits for everything before: an earlier frame may still use the image's memory.
/// @param samples  a texel: several are resolved where colours are written, depth too
/// @param readers  see TextureBarrier
UsageScope ToUsageScope(TextureUsage usage, std::uint32_t samples = 1,
                        ShaderStage readers = ShaderStage::None);

const char* ToString(TextureUsage usage);

VkAttachmentLoadOp ToVkLoadOp(LoadOp op);
VkAttachmentStoreOp ToVkStoreOp(StoreOp op);

/// From one timestamp to a later one, of which only the low bits count: the counter starts again
/// at 0 behind them, and the others may hold anything.
/// @param validBits  1...64
constexpr std::uint64_t ElapsedTicks(std::uint64_t begin, std::uint64_t end,
                                     std::uint32_t validBits)
{
    return (end - begin) & (~std::uint64_t{0} >> (64U - validBits));
}

} // namespace limn::vulkan

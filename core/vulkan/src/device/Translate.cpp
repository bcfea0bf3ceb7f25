#include "device/Translate.h"

#include <limn/base/Diagnostic.h>

namespace limn::vulkan
{

namespace
{

/// The texel formats from R8_SRGB on, in their order.
constexpr VkFormat k_Formats[] = {VK_FORMAT_R8_SRGB,          VK_FORMAT_R8G8_SRGB,
                                  VK_FORMAT_R8G8B8_SRGB,      VK_FORMAT_R8G8B8A8_SRGB,
                                  VK_FORMAT_R8_UNORM,         VK_FORMAT_R8G8_UNORM,
                                  VK_FORMAT_R8G8B8_UNORM,     VK_FORMAT_R8G8B8A8_UNORM,
                                  VK_FORMAT_R8_SNORM,         VK_FORMAT_R8G8_SNORM,
                                  VK_FORMAT_R8G8B8_SNORM,     VK_FORMAT_R8G8B8A8_SNORM,
                                  VK_FORMAT_R8_UINT,          VK_FORMAT_R8G8_UINT,
                                  VK_FORMAT_R8G8B8_UINT,      VK_FORMAT_R8G8B8A8_UINT,
                                  VK_FORMAT_R8_SINT,          VK_FORMAT_R8G8_SINT,
                                  VK_FORMAT_R8G8B8_SINT,      VK_FORMAT_R8G8B8A8_SINT,
                                  VK_FORMAT_R16_UNORM,        VK_FORMAT_R16G16_UNORM,
                                  VK_FORMAT_R16G16B16_UNORM,  VK_FORMAT_R16G16B16A16_UNORM,
                                  VK_FORMAT_R16_SNORM,        VK_FORMAT_R16G16_SNORM,
                                  VK_FORMAT_R16G16B16_SNORM,  VK_FORMAT_R16G16B16A16_SNORM,
                                  VK_FORMAT_R16_UINT,         VK_FORMAT_R16G16_UINT,
                                  VK_FORMAT_R16G16B16_UINT,   VK_FORMAT_R16G16B16A16_UINT,
                                  VK_FORMAT_R16_SINT,         VK_FORMAT_R16G16_SINT,
                                  VK_FORMAT_R16G16B16_SINT,   VK_FORMAT_R16G16B16A16_SINT,
                                  VK_FORMAT_R32_UINT,         VK_FORMAT_R32G32_UINT,
                                  VK_FORMAT_R32G32B32_UINT,   VK_FORMAT_R32G32B32A32_UINT,
                                  VK_FORMAT_R32_SINT,         VK_FORMAT_R32G32_SINT,
                                  VK_FORMAT_R32G32B32_SINT,   VK_FORMAT_R32G32B32A32_SINT,
                                  VK_FORMAT_R16_SFLOAT,       VK_FORMAT_R16G16_SFLOAT,
                                  VK_FORMAT_R16G16B16_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT,
                                  VK_FORMAT_R32_SFLOAT,       VK_FORMAT_R32G32_SFLOAT,
                                  VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT};
/// The texel formats from B8G8R8_SRGB on, in their order.
constexpr VkFormat k_ReversedAndPackedFormats[] = {VK_FORMAT_B8G8R8_SRGB,
                                                   VK_FORMAT_B8G8R8A8_SRGB,
                                                   VK_FORMAT_B8G8R8_UNORM,
                                                   VK_FORMAT_B8G8R8A8_UNORM,
                                                   VK_FORMAT_B8G8R8_SNORM,
                                                   VK_FORMAT_B8G8R8A8_SNORM,
                                                   VK_FORMAT_B8G8R8_UINT,
                                                   VK_FORMAT_B8G8R8A8_UINT,
                                                   VK_FORMAT_B8G8R8_SINT,
                                                   VK_FORMAT_B8G8R8A8_SINT,
                                                   VK_FORMAT_R4G4B4A4_UNORM_PACK16,
                                                   VK_FORMAT_B4G4R4A4_UNORM_PACK16,
                                                   VK_FORMAT_R5G6B5_UNORM_PACK16,
                                                   VK_FORMAT_B5G6R5_UNORM_PACK16,
                                                   VK_FORMAT_R5G5B5A1_UNORM_PACK16,
                                                   VK_FORMAT_B5G5R5A1_UNORM_PACK16,
                                                   VK_FORMAT_A1R5G5B5_UNORM_PACK16,
                                                   VK_FORMAT_E5B9G9R9_UFLOAT_PACK32,
                                                   VK_FORMAT_B10G11R11_UFLOAT_PACK32,
                                                   VK_FORMAT_A2B10G10R10_UNORM_PACK32,
                                                   VK_FORMAT_A2B10G10R10_UINT_PACK32,
                                                   VK_FORMAT_A2B10G10R10_SINT_PACK32,
                                                   VK_FORMAT_A2R10G10B10_UNORM_PACK32,
                                                   VK_FORMAT_A2R10G10B10_UINT_PACK32,
                                                   VK_FORMAT_A2R10G10B10_SINT_PACK32};

constexpr UsageScope k_ColorScope{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                  VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT |
                                      VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                                  VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};

/// Returns the element of a table that belongs to an enumerator.
/// @param first  the enumerator of the first element
/// @throws ContractError if the table has no such element
template <typename Element, std::size_t Count, typename Enum>
Element At(const Element (&table)[Count], const char* type, Enum value, Enum first = Enum{})
{
    const int index = static_cast<int>(value) - static_cast<int>(first);
    if (index < 0 || index >= static_cast<int>(Count))
    {
        throw ContractError(std::string(type) + " has no value " +
                            std::to_string(static_cast<int>(value)));
    }
    return table[index];
}

} // namespace

VkFormat ToVkFormat(GraphicsFormat format)
{
    switch (format)
    {
    case GraphicsFormat::None:
        throw ContractError("a texture of format None has no texels; give it a format");
    case GraphicsFormat::D32_SFloat:
        return VK_FORMAT_D32_SFLOAT;
    case GraphicsFormat::D32_SFloat_S8_UInt:
        return VK_FORMAT_D32_SFLOAT_S8_UINT;
    default: // of the others between and behind the tables no texture is made
        return format < GraphicsFormat::B8G8R8_SRGB
                   ? At(k_Formats, "GraphicsFormat", format, GraphicsFormat::R8_SRGB)
                   : At(k_ReversedAndPackedFormats, "GraphicsFormat", format,
                        GraphicsFormat::B8G8R8_SRGB);
    }
}

VkCompareOp ToReversedDepthCompare(CompareFunction function)
{
    static constexpr VkCompareOp k_Reversed[] = {VK_COMPARE_OP_ALWAYS,
                                                 VK_COMPARE_OP_NEVER,
                                                 VK_COMPARE_OP_GREATER,
                                                 VK_COMPARE_OP_EQUAL,
                                                 VK_COMPARE_OP_GREATER_OR_EQUAL,
                                                 VK_COMPARE_OP_LESS,
                                                 VK_COMPARE_OP_NOT_EQUAL,
                                                 VK_COMPARE_OP_LESS_OR_EQUAL,
                                                 VK_COMPARE_OP_ALWAYS};
    return At(k_Reversed, "CompareFunction", function);
}

VkCompareOp ToStencilCompare(CompareFunction function)
{
    static constexpr VkCompareOp k_Compares[] = {
        VK_COMPARE_OP_ALWAYS,        VK_COMPARE_OP_NEVER,
        VK_COMPARE_OP_LESS,          VK_COMPARE_OP_EQUAL,
        VK_COMPARE_OP_LESS_OR_EQUAL, VK_COMPARE_OP_GREATER,
        VK_COMPARE_OP_NOT_EQUAL,     VK_COMPARE_OP_GREATER_OR_EQUAL,
        VK_COMPARE_OP_ALWAYS};
    return At(k_Compares, "CompareFunction", function);
}

VkStencilOp ToVkStencilOp(StencilOp op)
{
    static constexpr VkStencilOp k_Operations[] = {VK_STENCIL_OP_KEEP,
                                                   VK_STENCIL_OP_ZERO,
                                                   VK_STENCIL_OP_REPLACE,
                                                   VK_STENCIL_OP_INCREMENT_AND_CLAMP,
                                                   VK_STENCIL_OP_DECREMENT_AND_CLAMP,
                                                   VK_STENCIL_OP_INVERT,
                                                   VK_STENCIL_OP_INCREMENT_AND_WRAP,
                                                   VK_STENCIL_OP_DECREMENT_AND_WRAP};
    return At(k_Operations, "StencilOp", op);
}

VkBlendFactor ToVkBlendFactor(BlendMode mode)
{
    static constexpr VkBlendFactor k_Factors[] = {VK_BLEND_FACTOR_ZERO,
                                                  VK_BLEND_FACTOR_ONE,
                                                  VK_BLEND_FACTOR_DST_COLOR,
                                                  VK_BLEND_FACTOR_SRC_COLOR,
                                                  VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR,
                                                  VK_BLEND_FACTOR_SRC_ALPHA,
                                                  VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR,
                                                  VK_BLEND_FACTOR_DST_ALPHA,
                                                  VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA,
                                                  VK_BLEND_FACTOR_SRC_ALPHA_SATURATE,
                                                  VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA};
    return At(k_Factors, "BlendMode", mode);
}

VkBlendOp ToVkBlendOp(BlendOp op)
{
    static constexpr VkBlendOp k_Plain[] = {VK_BLEND_OP_ADD, VK_BLEND_OP_SUBTRACT,
                                            VK_BLEND_OP_REVERSE_SUBTRACT, VK_BLEND_OP_MIN,
                                            VK_BLEND_OP_MAX};
    static constexpr VkBlendOp k_Advanced[] = {
        VK_BLEND_OP_MULTIPLY_EXT,       VK_BLEND_OP_SCREEN_EXT,    VK_BLEND_OP_OVERLAY_EXT,
        VK_BLEND_OP_DARKEN_EXT,         VK_BLEND_OP_LIGHTEN_EXT,   VK_BLEND_OP_COLORDODGE_EXT,
        VK_BLEND_OP_COLORBURN_EXT,      VK_BLEND_OP_HARDLIGHT_EXT, VK_BLEND_OP_SOFTLIGHT_EXT,
        VK_BLEND_OP_DIFFERENCE_EXT,     VK_BLEND_OP_EXCLUSION_EXT, VK_BLEND_OP_HSL_HUE_EXT,
        VK_BLEND_OP_HSL_SATURATION_EXT, VK_BLEND_OP_HSL_COLOR_EXT, VK_BLEND_OP_HSL_LUMINOSITY_EXT};
    return isLogical(op)    ? VK_BLEND_OP_ADD
           : isAdvanced(op) ? At(k_Advanced, "BlendOp", op, BlendOp::Multiply)
                            : At(k_Plain, "BlendOp", op);
}

VkLogicOp ToVkLogicOp(BlendOp op)
{
    static constexpr VkLogicOp k_Logical[] = {
        VK_LOGIC_OP_CLEAR,         VK_LOGIC_OP_SET,          VK_LOGIC_OP_COPY,
        VK_LOGIC_OP_COPY_INVERTED, VK_LOGIC_OP_NO_OP,        VK_LOGIC_OP_INVERT,
        VK_LOGIC_OP_AND,           VK_LOGIC_OP_NAND,         VK_LOGIC_OP_OR,
        VK_LOGIC_OP_NOR,           VK_LOGIC_OP_XOR,          VK_LOGIC_OP_EQUIVALENT,
        VK_LOGIC_OP_AND_REVERSE,   VK_LOGIC_OP_AND_INVERTED, VK_LOGIC_OP_OR_REVERSE,
        VK_LOGIC_OP_OR_INVERTED};
    return At(k_Logical, "logical BlendOp", op, BlendOp::LogicalClear);
}

VkPrimitiveTopology ToVkTopology(MeshTopology topology)
{
    return topology == MeshTopology::Lines       ? VK_PRIMITIVE_TOPOLOGY_LINE_LIST
           : topology == MeshTopology::LineStrip ? VK_PRIMITIVE_TOPOLOGY_LINE_STRIP
           : topology == MeshTopology::Points    ? VK_PRIMITIVE_TOPOLOGY_POINT_LIST
                                                 : VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
}

VkCullModeFlags ToVkCullMode(CullMode mode)
{
    static constexpr VkCullModeFlags k_Modes[] = {VK_CULL_MODE_NONE, VK_CULL_MODE_FRONT_BIT,
                                                  VK_CULL_MODE_BACK_BIT};
    return At(k_Modes, "CullMode", mode);
}

VkFrontFace ToVkFrontFace(bool flipped)
{
    return flipped ? VK_FRONT_FACE_COUNTER_CLOCKWISE : VK_FRONT_FACE_CLOCKWISE;
}

VkColorComponentFlags ToVkColorMask(int writeMask)
{
    const auto flag = [&](int bit, VkColorComponentFlags component)
    {
        return (writeMask & bit) != 0 ? component : 0U;
    };
    return flag(ColorWriteMask::Red, VK_COLOR_COMPONENT_R_BIT) |
           flag(ColorWriteMask::Green, VK_COLOR_COMPONENT_G_BIT) |
           flag(ColorWriteMask::Blue, VK_COLOR_COMPONENT_B_BIT) |
           flag(ColorWriteMask::Alpha, VK_COLOR_COMPONENT_A_BIT);
}

VkShaderStageFlags ToVkStages(ShaderStage stages)
{
    const auto flag = [&](ShaderStage stage, VkShaderStageFlags bit)
    {
        return stages & stage ? bit : 0U;
    };
    return flag(ShaderStage::Vertex, VK_SHADER_STAGE_VERTEX_BIT) |
           flag(ShaderStage::Geometry, VK_SHADER_STAGE_GEOMETRY_BIT) |
           flag(ShaderStage::Compute, VK_SHADER_STAGE_COMPUTE_BIT) |
           flag(ShaderStage::Fragment, VK_SHADER_STAGE_FRAGMENT_BIT);
}

VkPipelineStageFlags2 ToPipelineStages(ShaderStage readers)
{
    const auto flag = [&](ShaderStage stage, VkPipelineStageFlags2 bit)
    {
        return readers & stage ? bit : VK_PIPELINE_STAGE_2_NONE;
    };
    return readers == ShaderStage::None
               ? VK_PIPELINE_STAGE_2_PRE_RASTERIZATION_SHADERS_BIT |
                     VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                     VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT
               : flag(ShaderStage::Vertex, VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT) |
                     flag(ShaderStage::Geometry, VK_PIPELINE_STAGE_2_GEOMETRY_SHADER_BIT) |
                     flag(ShaderStage::Fragment, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT) |
                     flag(ShaderStage::Compute, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT) |
                     flag(ShaderStage::Indirect, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT);
}

VkMemoryBarrier2 MemoryBarrier(const UsageScope& from, const UsageScope& to)
{
    return {VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
            nullptr,
            from.stages,
            from.access,
            to.stages,
            to.access};
}

VkImageMemoryBarrier2 ImageBarrier(VkImage image, const VkImageSubresourceRange& range,
                                   const UsageScope& from, const UsageScope& to)
{
    return {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
            nullptr,
            from.stages,
            from.access,
            to.stages,
            to.access,
            from.layout,
            to.layout,
            VK_QUEUE_FAMILY_IGNORED,
            VK_QUEUE_FAMILY_IGNORED,
            image,
            range};
}

VkMemoryBarrier2 ToMemoryBarrier(const BufferBarrier& barrier)
{
    constexpr ShaderStage k_Functions =
        ShaderStage::Both | ShaderStage::Geometry | ShaderStage::Compute;
    const bool isAny = barrier.after == ShaderStage::None;
    VkAccessFlags2 read = VK_ACCESS_2_NONE;
    if (isAny || (barrier.after & k_Functions))
    {
        read |= VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_UNIFORM_READ_BIT;
    }
    if (barrier.after & ShaderStage::Indirect)
    {
        read |= VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT;
    }
    const VkAccessFlags2 write = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    return MemoryBarrier(
        {ToPipelineStages(barrier.before), barrier.wasWritten ? write : VK_ACCESS_2_NONE},
        {ToPipelineStages(barrier.after), read | (barrier.isWritten ? write : VK_ACCESS_2_NONE)});
}

UsageScope ToUsageScope(TextureUsage usage, std::uint32_t samples, ShaderStage readers)
{
    static constexpr UsageScope k_Scopes[] = {
        {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT},
        k_ColorScope,
        {VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
         VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
             VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
         VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL},
        {VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
        {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
         VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL},
        {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
         VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
         VK_IMAGE_LAYOUT_GENERAL}};
    UsageScope scope = At(k_Scopes, "TextureUsage", usage);
    if (usage == TextureUsage::ShaderRead)
    {
        scope.stages = ToPipelineStages(readers);
    }
    if (usage == TextureUsage::DepthStencilAttachment && samples > 1)
    {
        scope.stages |= k_ColorScope.stages;
        scope.access |= k_ColorScope.access;
    }
    return scope;
}

const char* ToString(TextureUsage usage)
{
    static constexpr const char* k_Names[] = {
        "Undefined",  "ColorAttachment", "DepthStencilAttachment",
        "ShaderRead", "CopySource",      "RandomWrite"};
    return At(k_Names, "TextureUsage", usage);
}

VkAttachmentLoadOp ToVkLoadOp(LoadOp op)
{
    static constexpr VkAttachmentLoadOp k_Operations[] = {
        VK_ATTACHMENT_LOAD_OP_LOAD, VK_ATTACHMENT_LOAD_OP_CLEAR, VK_ATTACHMENT_LOAD_OP_DONT_CARE};
    return At(k_Operations, "LoadOp", op);
}

VkAttachmentStoreOp ToVkStoreOp(StoreOp op)
{
    static constexpr VkAttachmentStoreOp k_Operations[] = {VK_ATTACHMENT_STORE_OP_STORE,
                                                           VK_ATTACHMENT_STORE_OP_DONT_CARE};
    return At(k_Operations, "StoreOp", op);
}

} // namespace limn::vulkan

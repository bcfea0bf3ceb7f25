#include "device/Translate.h"

#include <array>
#include <limn/base/Diagnostic.h>

namespace limn::vulkan
{

namespace
{

[[noreturn]] void RefuseValue(const char* type, int value)
{
    throw ContractError(std::string(type) + " has no value " + std::to_string(value));
}

} // namespace

VkFormat ToVkFormat(GraphicsFormat format)
{
    switch (format)
    {
    case GraphicsFormat::None:
        throw ContractError("a texture of format None has no texels; give it a format");
    case GraphicsFormat::R8_SRGB:
        return VK_FORMAT_R8_SRGB;
    case GraphicsFormat::R8G8_SRGB:
        return VK_FORMAT_R8G8_SRGB;
    case GraphicsFormat::R8G8B8_SRGB:
        return VK_FORMAT_R8G8B8_SRGB;
    case GraphicsFormat::R8G8B8A8_SRGB:
        return VK_FORMAT_R8G8B8A8_SRGB;
    case GraphicsFormat::R8_UNorm:
        return VK_FORMAT_R8_UNORM;
    case GraphicsFormat::R8G8_UNorm:
        return VK_FORMAT_R8G8_UNORM;
    case GraphicsFormat::R8G8B8_UNorm:
        return VK_FORMAT_R8G8B8_UNORM;
    case GraphicsFormat::R8G8B8A8_UNorm:
        return VK_FORMAT_R8G8B8A8_UNORM;
    case GraphicsFormat::R8_SNorm:
        return VK_FORMAT_R8_SNORM;
    case GraphicsFormat::R8G8_SNorm:
        return VK_FORMAT_R8G8_SNORM;
    case GraphicsFormat::R8G8B8_SNorm:
        return VK_FORMAT_R8G8B8_SNORM;
    case GraphicsFormat::R8G8B8A8_SNorm:
        return VK_FORMAT_R8G8B8A8_SNORM;
    case GraphicsFormat::R8_UInt:
        return VK_FORMAT_R8_UINT;
    case GraphicsFormat::R8G8_UInt:
        return VK_FORMAT_R8G8_UINT;
    case GraphicsFormat::R8G8B8_UInt:
        return VK_FORMAT_R8G8B8_UINT;
    case GraphicsFormat::R8G8B8A8_UInt:
        return VK_FORMAT_R8G8B8A8_UINT;
    case GraphicsFormat::R8_SInt:
        return VK_FORMAT_R8_SINT;
    case GraphicsFormat::R8G8_SInt:
        return VK_FORMAT_R8G8_SINT;
    case GraphicsFormat::R8G8B8_SInt:
        return VK_FORMAT_R8G8B8_SINT;
    case GraphicsFormat::R8G8B8A8_SInt:
        return VK_FORMAT_R8G8B8A8_SINT;
    case GraphicsFormat::R16_UNorm:
        return VK_FORMAT_R16_UNORM;
    case GraphicsFormat::R16G16_UNorm:
        return VK_FORMAT_R16G16_UNORM;
    case GraphicsFormat::R16G16B16_UNorm:
        return VK_FORMAT_R16G16B16_UNORM;
    case GraphicsFormat::R16G16B16A16_UNorm:
        return VK_FORMAT_R16G16B16A16_UNORM;
    case GraphicsFormat::R16_SNorm:
        return VK_FORMAT_R16_SNORM;
    case GraphicsFormat::R16G16_SNorm:
        return VK_FORMAT_R16G16_SNORM;
    case GraphicsFormat::R16G16B16_SNorm:
        return VK_FORMAT_R16G16B16_SNORM;
    case GraphicsFormat::R16G16B16A16_SNorm:
        return VK_FORMAT_R16G16B16A16_SNORM;
    case GraphicsFormat::R16_UInt:
        return VK_FORMAT_R16_UINT;
    case GraphicsFormat::R16G16_UInt:
        return VK_FORMAT_R16G16_UINT;
    case GraphicsFormat::R16G16B16_UInt:
        return VK_FORMAT_R16G16B16_UINT;
    case GraphicsFormat::R16G16B16A16_UInt:
        return VK_FORMAT_R16G16B16A16_UINT;
    case GraphicsFormat::R16_SInt:
        return VK_FORMAT_R16_SINT;
    case GraphicsFormat::R16G16_SInt:
        return VK_FORMAT_R16G16_SINT;
    case GraphicsFormat::R16G16B16_SInt:
        return VK_FORMAT_R16G16B16_SINT;
    case GraphicsFormat::R16G16B16A16_SInt:
        return VK_FORMAT_R16G16B16A16_SINT;
    case GraphicsFormat::R32_UInt:
        return VK_FORMAT_R32_UINT;
    case GraphicsFormat::R32G32_UInt:
        return VK_FORMAT_R32G32_UINT;
    case GraphicsFormat::R32G32B32_UInt:
        return VK_FORMAT_R32G32B32_UINT;
    case GraphicsFormat::R32G32B32A32_UInt:
        return VK_FORMAT_R32G32B32A32_UINT;
    case GraphicsFormat::R32_SInt:
        return VK_FORMAT_R32_SINT;
    case GraphicsFormat::R32G32_SInt:
        return VK_FORMAT_R32G32_SINT;
    case GraphicsFormat::R32G32B32_SInt:
        return VK_FORMAT_R32G32B32_SINT;
    case GraphicsFormat::R32G32B32A32_SInt:
        return VK_FORMAT_R32G32B32A32_SINT;
    case GraphicsFormat::R16_SFloat:
        return VK_FORMAT_R16_SFLOAT;
    case GraphicsFormat::R16G16_SFloat:
        return VK_FORMAT_R16G16_SFLOAT;
    case GraphicsFormat::R16G16B16_SFloat:
        return VK_FORMAT_R16G16B16_SFLOAT;
    case GraphicsFormat::R16G16B16A16_SFloat:
        return VK_FORMAT_R16G16B16A16_SFLOAT;
    case GraphicsFormat::R32_SFloat:
        return VK_FORMAT_R32_SFLOAT;
    case GraphicsFormat::R32G32_SFloat:
        return VK_FORMAT_R32G32_SFLOAT;
    case GraphicsFormat::R32G32B32_SFloat:
        return VK_FORMAT_R32G32B32_SFLOAT;
    case GraphicsFormat::R32G32B32A32_SFloat:
        return VK_FORMAT_R32G32B32A32_SFLOAT;
    case GraphicsFormat::B8G8R8_SRGB:
        return VK_FORMAT_B8G8R8_SRGB;
    case GraphicsFormat::B8G8R8A8_SRGB:
        return VK_FORMAT_B8G8R8A8_SRGB;
    case GraphicsFormat::B8G8R8_UNorm:
        return VK_FORMAT_B8G8R8_UNORM;
    case GraphicsFormat::B8G8R8A8_UNorm:
        return VK_FORMAT_B8G8R8A8_UNORM;
    case GraphicsFormat::B8G8R8_SNorm:
        return VK_FORMAT_B8G8R8_SNORM;
    case GraphicsFormat::B8G8R8A8_SNorm:
        return VK_FORMAT_B8G8R8A8_SNORM;
    case GraphicsFormat::B8G8R8_UInt:
        return VK_FORMAT_B8G8R8_UINT;
    case GraphicsFormat::B8G8R8A8_UInt:
        return VK_FORMAT_B8G8R8A8_UINT;
    case GraphicsFormat::B8G8R8_SInt:
        return VK_FORMAT_B8G8R8_SINT;
    case GraphicsFormat::B8G8R8A8_SInt:
        return VK_FORMAT_B8G8R8A8_SINT;
    case GraphicsFormat::R4G4B4A4_UNormPack16:
        return VK_FORMAT_R4G4B4A4_UNORM_PACK16;
    case GraphicsFormat::B4G4R4A4_UNormPack16:
        return VK_FORMAT_B4G4R4A4_UNORM_PACK16;
    case GraphicsFormat::R5G6B5_UNormPack16:
        return VK_FORMAT_R5G6B5_UNORM_PACK16;
    case GraphicsFormat::B5G6R5_UNormPack16:
        return VK_FORMAT_B5G6R5_UNORM_PACK16;
    case GraphicsFormat::R5G5B5A1_UNormPack16:
        return VK_FORMAT_R5G5B5A1_UNORM_PACK16;
    case GraphicsFormat::B5G5R5A1_UNormPack16:
        return VK_FORMAT_B5G5R5A1_UNORM_PACK16;
    case GraphicsFormat::A1R5G5B5_UNormPack16:
        return VK_FORMAT_A1R5G5B5_UNORM_PACK16;
    case GraphicsFormat::E5B9G9R9_UFloatPack32:
        return VK_FORMAT_E5B9G9R9_UFLOAT_PACK32;
    case GraphicsFormat::B10G11R11_UFloatPack32:
        return VK_FORMAT_B10G11R11_UFLOAT_PACK32;
    case GraphicsFormat::A2B10G10R10_UNormPack32:
        return VK_FORMAT_A2B10G10R10_UNORM_PACK32;
    case GraphicsFormat::A2B10G10R10_UIntPack32:
        return VK_FORMAT_A2B10G10R10_UINT_PACK32;
    case GraphicsFormat::A2B10G10R10_SIntPack32:
        return VK_FORMAT_A2B10G10R10_SINT_PACK32;
    case GraphicsFormat::A2R10G10B10_UNormPack32:
        return VK_FORMAT_A2R10G10B10_UNORM_PACK32;
    case GraphicsFormat::A2R10G10B10_UIntPack32:
        return VK_FORMAT_A2R10G10B10_UINT_PACK32;
    case GraphicsFormat::A2R10G10B10_SIntPack32:
        return VK_FORMAT_A2R10G10B10_SINT_PACK32;
    case GraphicsFormat::D32_SFloat:
        return VK_FORMAT_D32_SFLOAT;
    case GraphicsFormat::D32_SFloat_S8_UInt:
        return VK_FORMAT_D32_SFLOAT_S8_UINT;
    default: // of these no texture is made
        break;
    }
    RefuseValue("GraphicsFormat", static_cast<int>(format));
}

VkCompareOp ToReversedDepthCompare(CompareFunction function)
{
    switch (function)
    {
    case CompareFunction::Less:
        return VK_COMPARE_OP_GREATER;
    case CompareFunction::LessEqual:
        return VK_COMPARE_OP_GREATER_OR_EQUAL;
    case CompareFunction::Greater:
        return VK_COMPARE_OP_LESS;
    case CompareFunction::GreaterEqual:
        return VK_COMPARE_OP_LESS_OR_EQUAL;
    default:
        return ToStencilCompare(function);
    }
}

VkCompareOp ToStencilCompare(CompareFunction function)
{
    switch (function)
    {
    case CompareFunction::Disabled:
    case CompareFunction::Always:
        return VK_COMPARE_OP_ALWAYS;
    case CompareFunction::Never:
        return VK_COMPARE_OP_NEVER;
    case CompareFunction::Less:
        return VK_COMPARE_OP_LESS;
    case CompareFunction::Equal:
        return VK_COMPARE_OP_EQUAL;
    case CompareFunction::LessEqual:
        return VK_COMPARE_OP_LESS_OR_EQUAL;
    case CompareFunction::Greater:
        return VK_COMPARE_OP_GREATER;
    case CompareFunction::NotEqual:
        return VK_COMPARE_OP_NOT_EQUAL;
    case CompareFunction::GreaterEqual:
        return VK_COMPARE_OP_GREATER_OR_EQUAL;
    }
    RefuseValue("CompareFunction", static_cast<int>(function));
}

VkStencilOp ToVkStencilOp(StencilOp op)
{
    switch (op)
    {
    case StencilOp::Keep:
        return VK_STENCIL_OP_KEEP;
    case StencilOp::Zero:
        return VK_STENCIL_OP_ZERO;
    case StencilOp::Replace:
        return VK_STENCIL_OP_REPLACE;
    case StencilOp::IncrementSaturate:
        return VK_STENCIL_OP_INCREMENT_AND_CLAMP;
    case StencilOp::DecrementSaturate:
        return VK_STENCIL_OP_DECREMENT_AND_CLAMP;
    case StencilOp::Invert:
        return VK_STENCIL_OP_INVERT;
    case StencilOp::IncrementWrap:
        return VK_STENCIL_OP_INCREMENT_AND_WRAP;
    case StencilOp::DecrementWrap:
        return VK_STENCIL_OP_DECREMENT_AND_WRAP;
    }
    RefuseValue("StencilOp", static_cast<int>(op));
}

VkBlendFactor ToVkBlendFactor(BlendMode mode)
{
    switch (mode)
    {
    case BlendMode::Zero:
        return VK_BLEND_FACTOR_ZERO;
    case BlendMode::One:
        return VK_BLEND_FACTOR_ONE;
    case BlendMode::DstColor:
        return VK_BLEND_FACTOR_DST_COLOR;
    case BlendMode::SrcColor:
        return VK_BLEND_FACTOR_SRC_COLOR;
    case BlendMode::OneMinusDstColor:
        return VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR;
    case BlendMode::SrcAlpha:
        return VK_BLEND_FACTOR_SRC_ALPHA;
    case BlendMode::OneMinusSrcColor:
        return VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR;
    case BlendMode::DstAlpha:
        return VK_BLEND_FACTOR_DST_ALPHA;
    case BlendMode::OneMinusDstAlpha:
        return VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA;
    case BlendMode::SrcAlphaSaturate:
        return VK_BLEND_FACTOR_SRC_ALPHA_SATURATE;
    case BlendMode::OneMinusSrcAlpha:
        return VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    }
    RefuseValue("BlendMode", static_cast<int>(mode));
}

VkBlendOp ToVkBlendOp(BlendOp op)
{
    switch (op)
    {
    case BlendOp::Add:
        return VK_BLEND_OP_ADD;
    case BlendOp::Subtract:
        return VK_BLEND_OP_SUBTRACT;
    case BlendOp::ReverseSubtract:
        return VK_BLEND_OP_REVERSE_SUBTRACT;
    case BlendOp::Min:
        return VK_BLEND_OP_MIN;
    case BlendOp::Max:
        return VK_BLEND_OP_MAX;
    default:
        break;
    }
    if (isLogical(op))
    {
        return VK_BLEND_OP_ADD;
    }
    constexpr std::array k_Advanced = {
        VK_BLEND_OP_MULTIPLY_EXT,       VK_BLEND_OP_SCREEN_EXT,    VK_BLEND_OP_OVERLAY_EXT,
        VK_BLEND_OP_DARKEN_EXT,         VK_BLEND_OP_LIGHTEN_EXT,   VK_BLEND_OP_COLORDODGE_EXT,
        VK_BLEND_OP_COLORBURN_EXT,      VK_BLEND_OP_HARDLIGHT_EXT, VK_BLEND_OP_SOFTLIGHT_EXT,
        VK_BLEND_OP_DIFFERENCE_EXT,     VK_BLEND_OP_EXCLUSION_EXT, VK_BLEND_OP_HSL_HUE_EXT,
        VK_BLEND_OP_HSL_SATURATION_EXT, VK_BLEND_OP_HSL_COLOR_EXT, VK_BLEND_OP_HSL_LUMINOSITY_EXT};
    const auto index = static_cast<std::size_t>(op) - static_cast<std::size_t>(BlendOp::Multiply);
    if (!isAdvanced(op) || index >= k_Advanced.size())
    {
        RefuseValue("BlendOp", static_cast<int>(op));
    }
    return k_Advanced.at(index);
}

VkLogicOp ToVkLogicOp(BlendOp op)
{
    constexpr std::array k_Logical = {
        VK_LOGIC_OP_CLEAR,         VK_LOGIC_OP_SET,          VK_LOGIC_OP_COPY,
        VK_LOGIC_OP_COPY_INVERTED, VK_LOGIC_OP_NO_OP,        VK_LOGIC_OP_INVERT,
        VK_LOGIC_OP_AND,           VK_LOGIC_OP_NAND,         VK_LOGIC_OP_OR,
        VK_LOGIC_OP_NOR,           VK_LOGIC_OP_XOR,          VK_LOGIC_OP_EQUIVALENT,
        VK_LOGIC_OP_AND_REVERSE,   VK_LOGIC_OP_AND_INVERTED, VK_LOGIC_OP_OR_REVERSE,
        VK_LOGIC_OP_OR_INVERTED};
    if (!isLogical(op))
    {
        RefuseValue("logical BlendOp", static_cast<int>(op));
    }
    return k_Logical.at(static_cast<std::size_t>(op) -
                        static_cast<std::size_t>(BlendOp::LogicalClear));
}

VkConservativeRasterizationModeEXT ToVkConservative(bool conservative)
{
    return conservative ? VK_CONSERVATIVE_RASTERIZATION_MODE_OVERESTIMATE_EXT
                        : VK_CONSERVATIVE_RASTERIZATION_MODE_DISABLED_EXT;
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
    switch (mode)
    {
    case CullMode::Off:
        return VK_CULL_MODE_NONE;
    case CullMode::Front:
        return VK_CULL_MODE_FRONT_BIT;
    case CullMode::Back:
        return VK_CULL_MODE_BACK_BIT;
    }
    RefuseValue("CullMode", static_cast<int>(mode));
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
    VkMemoryBarrier2 result{};
    result.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    result.srcStageMask = ToPipelineStages(barrier.before);
    result.srcAccessMask =
        barrier.wasWritten ? VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT : VK_ACCESS_2_NONE;
    result.dstStageMask = ToPipelineStages(barrier.after);
    result.dstAccessMask =
        read | (barrier.isWritten ? VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT : VK_ACCESS_2_NONE);
    return result;
}

UsageScope ToUsageScope(TextureUsage usage, std::uint32_t samples, ShaderStage readers)
{
    if (usage == TextureUsage::DepthStencilAttachment && samples > 1)
    {
        UsageScope scope = ToUsageScope(usage);
        const UsageScope resolve = ToUsageScope(TextureUsage::ColorAttachment);
        scope.stages |= resolve.stages;
        scope.access |= resolve.access;
        return scope;
    }
    switch (usage)
    {
    case TextureUsage::Undefined:
        return {VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                VK_ACCESS_2_MEMORY_WRITE_BIT};
    case TextureUsage::ColorAttachment:
        return {VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
    case TextureUsage::DepthStencilAttachment:
        return {VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
                VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT |
                    VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
                VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
    case TextureUsage::ShaderRead:
        return {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, ToPipelineStages(readers),
                VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
    case TextureUsage::CopySource:
        return {VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_COPY_BIT,
                VK_ACCESS_2_TRANSFER_READ_BIT};
    case TextureUsage::RandomWrite:
        return {VK_IMAGE_LAYOUT_GENERAL, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
    }
    RefuseValue("TextureUsage", static_cast<int>(usage));
}

const char* ToString(TextureUsage usage)
{
    switch (usage)
    {
    case TextureUsage::Undefined:
        return "Undefined";
    case TextureUsage::ColorAttachment:
        return "ColorAttachment";
    case TextureUsage::DepthStencilAttachment:
        return "DepthStencilAttachment";
    case TextureUsage::ShaderRead:
        return "ShaderRead";
    case TextureUsage::CopySource:
        return "CopySource";
    case TextureUsage::RandomWrite:
        return "RandomWrite";
    }
    RefuseValue("TextureUsage", static_cast<int>(usage));
}

VkAttachmentLoadOp ToVkLoadOp(LoadOp op)
{
    switch (op)
    {
    case LoadOp::Load:
        return VK_ATTACHMENT_LOAD_OP_LOAD;
    case LoadOp::Clear:
        return VK_ATTACHMENT_LOAD_OP_CLEAR;
    case LoadOp::DontCare:
        return VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    }
    RefuseValue("LoadOp", static_cast<int>(op));
}

VkAttachmentStoreOp ToVkStoreOp(StoreOp op)
{
    switch (op)
    {
    case StoreOp::Store:
        return VK_ATTACHMENT_STORE_OP_STORE;
    case StoreOp::DontCare:
        return VK_ATTACHMENT_STORE_OP_DONT_CARE;
    }
    RefuseValue("StoreOp", static_cast<int>(op));
}

} // namespace limn::vulkan

#include <limn/core/GraphicsFormat.h>

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <string>
#include <string_view>

namespace limn
{

namespace
{

struct FormatFacts
{
    GraphicsFormat format;
    const char* name;
    int bytes;
    int channels;
    UniformType type;
};

constexpr UniformType k_Float = UniformType::Float;
constexpr UniformType k_UInt = UniformType::UInt;
constexpr UniformType k_Int = UniformType::Int;

using enum GraphicsFormat;
constexpr FormatFacts k_Formats[] = {
    {R8_SRGB, "R8_SRGB", 1, 1, k_Float},
    {R8G8_SRGB, "R8G8_SRGB", 2, 2, k_Float},
    {R8G8B8_SRGB, "R8G8B8_SRGB", 3, 3, k_Float},
    {R8G8B8A8_SRGB, "R8G8B8A8_SRGB", 4, 4, k_Float},
    {R8_UNorm, "R8_UNorm", 1, 1, k_Float},
    {R8G8_UNorm, "R8G8_UNorm", 2, 2, k_Float},
    {R8G8B8_UNorm, "R8G8B8_UNorm", 3, 3, k_Float},
    {R8G8B8A8_UNorm, "R8G8B8A8_UNorm", 4, 4, k_Float},
    {R8_SNorm, "R8_SNorm", 1, 1, k_Float},
    {R8G8_SNorm, "R8G8_SNorm", 2, 2, k_Float},
    {R8G8B8_SNorm, "R8G8B8_SNorm", 3, 3, k_Float},
    {R8G8B8A8_SNorm, "R8G8B8A8_SNorm", 4, 4, k_Float},
    {R8_UInt, "R8_UInt", 1, 1, k_UInt},
    {R8G8_UInt, "R8G8_UInt", 2, 2, k_UInt},
    {R8G8B8_UInt, "R8G8B8_UInt", 3, 3, k_UInt},
    {R8G8B8A8_UInt, "R8G8B8A8_UInt", 4, 4, k_UInt},
    {R8_SInt, "R8_SInt", 1, 1, k_Int},
    {R8G8_SInt, "R8G8_SInt", 2, 2, k_Int},
    {R8G8B8_SInt, "R8G8B8_SInt", 3, 3, k_Int},
    {R8G8B8A8_SInt, "R8G8B8A8_SInt", 4, 4, k_Int},
    {R16_UNorm, "R16_UNorm", 2, 1, k_Float},
    {R16G16_UNorm, "R16G16_UNorm", 4, 2, k_Float},
    {R16G16B16_UNorm, "R16G16B16_UNorm", 6, 3, k_Float},
    {R16G16B16A16_UNorm, "R16G16B16A16_UNorm", 8, 4, k_Float},
    {R16_SNorm, "R16_SNorm", 2, 1, k_Float},
    {R16G16_SNorm, "R16G16_SNorm", 4, 2, k_Float},
    {R16G16B16_SNorm, "R16G16B16_SNorm", 6, 3, k_Float},
    {R16G16B16A16_SNorm, "R16G16B16A16_SNorm", 8, 4, k_Float},
    {R16_UInt, "R16_UInt", 2, 1, k_UInt},
    {R16G16_UInt, "R16G16_UInt", 4, 2, k_UInt},
    {R16G16B16_UInt, "R16G16B16_UInt", 6, 3, k_UInt},
    {R16G16B16A16_UInt, "R16G16B16A16_UInt", 8, 4, k_UInt},
    {R16_SInt, "R16_SInt", 2, 1, k_Int},
    {R16G16_SInt, "R16G16_SInt", 4, 2, k_Int},
    {R16G16B16_SInt, "R16G16B16_SInt", 6, 3, k_Int},
    {R16G16B16A16_SInt, "R16G16B16A16_SInt", 8, 4, k_Int},
    {R32_UInt, "R32_UInt", 4, 1, k_UInt},
    {R32G32_UInt, "R32G32_UInt", 8, 2, k_UInt},
    {R32G32B32_UInt, "R32G32B32_UInt", 12, 3, k_UInt},
    {R32G32B32A32_UInt, "R32G32B32A32_UInt", 16, 4, k_UInt},
    {R32_SInt, "R32_SInt", 4, 1, k_Int},
    {R32G32_SInt, "R32G32_SInt", 8, 2, k_Int},
    {R32G32B32_SInt, "R32G32B32_SInt", 12, 3, k_Int},
    {R32G32B32A32_SInt, "R32G32B32A32_SInt", 16, 4, k_Int},
    {R16_SFloat, "R16_SFloat", 2, 1, k_Float},
    {R16G16_SFloat, "R16G16_SFloat", 4, 2, k_Float},
    {R16G16B16_SFloat, "R16G16B16_SFloat", 6, 3, k_Float},
    {R16G16B16A16_SFloat, "R16G16B16A16_SFloat", 8, 4, k_Float},
    {R32_SFloat, "R32_SFloat", 4, 1, k_Float},
    {R32G32_SFloat, "R32G32_SFloat", 8, 2, k_Float},
    {R32G32B32_SFloat, "R32G32B32_SFloat", 12, 3, k_Float},
    {R32G32B32A32_SFloat, "R32G32B32A32_SFloat", 16, 4, k_Float},
    {B8G8R8_SRGB, "B8G8R8_SRGB", 3, 3, k_Float},
    {B8G8R8A8_SRGB, "B8G8R8A8_SRGB", 4, 4, k_Float},
    {B8G8R8_UNorm, "B8G8R8_UNorm", 3, 3, k_Float},
    {B8G8R8A8_UNorm, "B8G8R8A8_UNorm", 4, 4, k_Float},
    {B8G8R8_SNorm, "B8G8R8_SNorm", 3, 3, k_Float},
    {B8G8R8A8_SNorm, "B8G8R8A8_SNorm", 4, 4, k_Float},
    {B8G8R8_UInt, "B8G8R8_UInt", 3, 3, k_UInt},
    {B8G8R8A8_UInt, "B8G8R8A8_UInt", 4, 4, k_UInt},
    {B8G8R8_SInt, "B8G8R8_SInt", 3, 3, k_Int},
    {B8G8R8A8_SInt, "B8G8R8A8_SInt", 4, 4, k_Int},
    {R4G4B4A4_UNormPack16, "R4G4B4A4_UNormPack16", 2, 4, k_Float},
    {B4G4R4A4_UNormPack16, "B4G4R4A4_UNormPack16", 2, 4, k_Float},
    {R5G6B5_UNormPack16, "R5G6B5_UNormPack16", 2, 3, k_Float},
    {B5G6R5_UNormPack16, "B5G6R5_UNormPack16", 2, 3, k_Float},
    {R5G5B5A1_UNormPack16, "R5G5B5A1_UNormPack16", 2, 4, k_Float},
    {B5G5R5A1_UNormPack16, "B5G5R5A1_UNormPack16", 2, 4, k_Float},
    {A1R5G5B5_UNormPack16, "A1R5G5B5_UNormPack16", 2, 4, k_Float},
    {E5B9G9R9_UFloatPack32, "E5B9G9R9_UFloatPack32", 4, 3, k_Float},
    {B10G11R11_UFloatPack32, "B10G11R11_UFloatPack32", 4, 3, k_Float},
    {A2B10G10R10_UNormPack32, "A2B10G10R10_UNormPack32", 4, 4, k_Float},
    {A2B10G10R10_UIntPack32, "A2B10G10R10_UIntPack32", 4, 4, k_UInt},
    {A2B10G10R10_SIntPack32, "A2B10G10R10_SIntPack32", 4, 4, k_Int},
    {A2R10G10B10_UNormPack32, "A2R10G10B10_UNormPack32", 4, 4, k_Float},
    {A2R10G10B10_UIntPack32, "A2R10G10B10_UIntPack32", 4, 4, k_UInt},
    {A2R10G10B10_SIntPack32, "A2R10G10B10_SIntPack32", 4, 4, k_Int},
    {D16_UNorm, "D16_UNorm", 2, 1, k_Float},
    {D24_UNorm, "D24_UNorm", 4, 1, k_Float},
    {D24_UNorm_S8_UInt, "D24_UNorm_S8_UInt", 4, 2, k_Float},
    {D32_SFloat, "D32_SFloat", 4, 1, k_Float},
    {D32_SFloat_S8_UInt, "D32_SFloat_S8_UInt", 8, 2, k_Float},
    {S8_UInt, "S8_UInt", 1, 1, k_UInt},
    {D16_UNorm_S8_UInt, "D16_UNorm_S8_UInt", 4, 2, k_Float},
};

/// A format that no texture can be of.
struct RefusedFormat
{
    GraphicsFormat format;
    const char* name;
    const char* reason;
    GraphicsFormat instead;
};

constexpr const char* k_Compressed = "is compressed";
constexpr const char* k_ExtendedRange =
    "is of an extended range, for displays that limn does not draw to";
constexpr const char* k_Video = "is for video, which limn does not have";
constexpr const char* k_Auto = "leaves the choice to Unity";

constexpr RefusedFormat k_Refused[] = {
    {A2R10G10B10_XRSRGBPack32, "A2R10G10B10_XRSRGBPack32", k_ExtendedRange, R16G16B16A16_SFloat},
    {A2R10G10B10_XRUNormPack32, "A2R10G10B10_XRUNormPack32", k_ExtendedRange, R16G16B16A16_SFloat},
    {R10G10B10_XRSRGBPack32, "R10G10B10_XRSRGBPack32", k_ExtendedRange, R16G16B16A16_SFloat},
    {R10G10B10_XRUNormPack32, "R10G10B10_XRUNormPack32", k_ExtendedRange, R16G16B16A16_SFloat},
    {A10R10G10B10_XRSRGBPack32, "A10R10G10B10_XRSRGBPack32", k_ExtendedRange, R16G16B16A16_SFloat},
    {A10R10G10B10_XRUNormPack32, "A10R10G10B10_XRUNormPack32", k_ExtendedRange,
     R16G16B16A16_SFloat},
    {RGBA_DXT1_SRGB, "RGBA_DXT1_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_DXT1_UNorm, "RGBA_DXT1_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGBA_DXT3_SRGB, "RGBA_DXT3_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_DXT3_UNorm, "RGBA_DXT3_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGBA_DXT5_SRGB, "RGBA_DXT5_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_DXT5_UNorm, "RGBA_DXT5_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {R_BC4_UNorm, "R_BC4_UNorm", k_Compressed, R8_UNorm},
    {R_BC4_SNorm, "R_BC4_SNorm", k_Compressed, R8_SNorm},
    {RG_BC5_UNorm, "RG_BC5_UNorm", k_Compressed, R8G8_UNorm},
    {RG_BC5_SNorm, "RG_BC5_SNorm", k_Compressed, R8G8_SNorm},
    {RGB_BC6H_UFloat, "RGB_BC6H_UFloat", k_Compressed, R16G16B16A16_SFloat},
    {RGB_BC6H_SFloat, "RGB_BC6H_SFloat", k_Compressed, R16G16B16A16_SFloat},
    {RGBA_BC7_SRGB, "RGBA_BC7_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_BC7_UNorm, "RGBA_BC7_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGB_PVRTC_2Bpp_SRGB, "RGB_PVRTC_2Bpp_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGB_PVRTC_2Bpp_UNorm, "RGB_PVRTC_2Bpp_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGB_PVRTC_4Bpp_SRGB, "RGB_PVRTC_4Bpp_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGB_PVRTC_4Bpp_UNorm, "RGB_PVRTC_4Bpp_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGBA_PVRTC_2Bpp_SRGB, "RGBA_PVRTC_2Bpp_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_PVRTC_2Bpp_UNorm, "RGBA_PVRTC_2Bpp_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGBA_PVRTC_4Bpp_SRGB, "RGBA_PVRTC_4Bpp_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_PVRTC_4Bpp_UNorm, "RGBA_PVRTC_4Bpp_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGB_ETC_UNorm, "RGB_ETC_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGB_ETC2_SRGB, "RGB_ETC2_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGB_ETC2_UNorm, "RGB_ETC2_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGB_A1_ETC2_SRGB, "RGB_A1_ETC2_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGB_A1_ETC2_UNorm, "RGB_A1_ETC2_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGBA_ETC2_SRGB, "RGBA_ETC2_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_ETC2_UNorm, "RGBA_ETC2_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {R_EAC_UNorm, "R_EAC_UNorm", k_Compressed, R8_UNorm},
    {R_EAC_SNorm, "R_EAC_SNorm", k_Compressed, R8_SNorm},
    {RG_EAC_UNorm, "RG_EAC_UNorm", k_Compressed, R8G8_UNorm},
    {RG_EAC_SNorm, "RG_EAC_SNorm", k_Compressed, R8G8_SNorm},
    {RGBA_ASTC4X4_SRGB, "RGBA_ASTC4X4_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_ASTC4X4_UNorm, "RGBA_ASTC4X4_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGBA_ASTC5X5_SRGB, "RGBA_ASTC5X5_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_ASTC5X5_UNorm, "RGBA_ASTC5X5_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGBA_ASTC6X6_SRGB, "RGBA_ASTC6X6_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_ASTC6X6_UNorm, "RGBA_ASTC6X6_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGBA_ASTC8X8_SRGB, "RGBA_ASTC8X8_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_ASTC8X8_UNorm, "RGBA_ASTC8X8_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGBA_ASTC10X10_SRGB, "RGBA_ASTC10X10_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_ASTC10X10_UNorm, "RGBA_ASTC10X10_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {RGBA_ASTC12X12_SRGB, "RGBA_ASTC12X12_SRGB", k_Compressed, R8G8B8A8_SRGB},
    {RGBA_ASTC12X12_UNorm, "RGBA_ASTC12X12_UNorm", k_Compressed, R8G8B8A8_UNorm},
    {YUV2, "YUV2", k_Video, R8G8B8A8_UNorm},
    {DepthAuto, "DepthAuto", k_Auto, D32_SFloat_S8_UInt},
    {ShadowAuto, "ShadowAuto", k_Auto, D32_SFloat},
    {VideoAuto, "VideoAuto", k_Video, R8G8B8A8_UNorm},
    {RGBA_ASTC4X4_UFloat, "RGBA_ASTC4X4_UFloat", k_Compressed, R16G16B16A16_SFloat},
    {RGBA_ASTC5X5_UFloat, "RGBA_ASTC5X5_UFloat", k_Compressed, R16G16B16A16_SFloat},
    {RGBA_ASTC6X6_UFloat, "RGBA_ASTC6X6_UFloat", k_Compressed, R16G16B16A16_SFloat},
    {RGBA_ASTC8X8_UFloat, "RGBA_ASTC8X8_UFloat", k_Compressed, R16G16B16A16_SFloat},
    {RGBA_ASTC10X10_UFloat, "RGBA_ASTC10X10_UFloat", k_Compressed, R16G16B16A16_SFloat},
    {RGBA_ASTC12X12_UFloat, "RGBA_ASTC12X12_UFloat", k_Compressed, R16G16B16A16_SFloat},
};

const RefusedFormat* FindRefused(GraphicsFormat format)
{
    const auto found = std::ranges::find(k_Refused, format, &RefusedFormat::format);
    return found == std::end(k_Refused) ? nullptr : found;
}

const FormatFacts* Find(GraphicsFormat format)
{
    const auto found = std::ranges::find(k_Formats, format, &FormatFacts::format);
    return found == std::end(k_Formats) ? nullptr : found;
}

/// @param what  that it lacks otherwise: "texels"
const FormatFacts& FactsOf(GraphicsFormat format, const char* what)
{
    if (const FormatFacts* facts = Find(format))
    {
        return *facts;
    }
    const std::string problem = GraphicsFormatProblem(format);
    throw ContractError(
        "GraphicsFormat " + std::string(ToString(format)) +
        (problem.empty() ? " has no " + std::string(what) + "; a format that limn knows is needed"
                         : " " + problem));
}

} // namespace

GraphicsFormat ToGraphicsFormat(RenderTextureFormat format, bool sRGB)
{
    switch (format)
    {
    case RenderTextureFormat::ARGB32:
    case RenderTextureFormat::Default:
        return sRGB ? R8G8B8A8_SRGB : R8G8B8A8_UNorm;
    case RenderTextureFormat::BGRA32:
        return sRGB ? B8G8R8A8_SRGB : B8G8R8A8_UNorm;
    case RenderTextureFormat::Depth:
    case RenderTextureFormat::Shadowmap:
        return D32_SFloat;
    case RenderTextureFormat::RGB565:
        return B5G6R5_UNormPack16;
    case RenderTextureFormat::ARGB4444:
        return B4G4R4A4_UNormPack16;
    case RenderTextureFormat::ARGB1555:
        return B5G5R5A1_UNormPack16;
    case RenderTextureFormat::BGRA10101010_XR:
        return A10R10G10B10_XRUNormPack32;
    case RenderTextureFormat::BGR101010_XR:
        return R10G10B10_XRUNormPack32;
    case RenderTextureFormat::ARGBHalf:
        return R16G16B16A16_SFloat;
    case RenderTextureFormat::ARGB2101010:
        return A2B10G10R10_UNormPack32;
    case RenderTextureFormat::ARGB64:
        return R16G16B16A16_UNorm;
    case RenderTextureFormat::ARGBFloat:
        return R32G32B32A32_SFloat;
    case RenderTextureFormat::RGFloat:
        return R32G32_SFloat;
    case RenderTextureFormat::RGHalf:
        return R16G16_SFloat;
    case RenderTextureFormat::RFloat:
        return R32_SFloat;
    case RenderTextureFormat::RHalf:
        return R16_SFloat;
    case RenderTextureFormat::R8:
        return R8_UNorm;
    case RenderTextureFormat::ARGBInt:
        return R32G32B32A32_SInt;
    case RenderTextureFormat::RGInt:
        return R32G32_SInt;
    case RenderTextureFormat::RInt:
        return R32_SInt;
    case RenderTextureFormat::RGB111110Float:
    case RenderTextureFormat::DefaultHDR:
        return B10G11R11_UFloatPack32;
    case RenderTextureFormat::RG32:
        return R16G16_UNorm;
    case RenderTextureFormat::RGBAUShort:
        return R16G16B16A16_UInt;
    case RenderTextureFormat::RG16:
        return R8G8_UNorm;
    case RenderTextureFormat::R16:
        return R16_UNorm;
    }
    throw ContractError("RenderTextureFormat " + std::to_string(static_cast<int>(format)) +
                        " is not one that limn knows");
}

GraphicsFormat ToGraphicsFormat(TextureFormat format, bool sRGB)
{
    switch (format)
    {
    case TextureFormat::Alpha8:
        return R8_UNorm;
    case TextureFormat::ARGB4444:
    case TextureFormat::ARGB32:
        return None;
    case TextureFormat::RGB24:
        return sRGB ? R8G8B8_SRGB : R8G8B8_UNorm;
    case TextureFormat::RGBA32:
        return sRGB ? R8G8B8A8_SRGB : R8G8B8A8_UNorm;
    case TextureFormat::RGB565:
        return R5G6B5_UNormPack16;
    case TextureFormat::R16:
        return R16_UNorm;
    case TextureFormat::DXT1:
        return sRGB ? RGBA_DXT1_SRGB : RGBA_DXT1_UNorm;
    case TextureFormat::DXT5:
        return sRGB ? RGBA_DXT5_SRGB : RGBA_DXT5_UNorm;
    case TextureFormat::RGBA4444:
        return R4G4B4A4_UNormPack16;
    case TextureFormat::BGRA32:
        return sRGB ? B8G8R8A8_SRGB : B8G8R8A8_UNorm;
    case TextureFormat::RHalf:
        return R16_SFloat;
    case TextureFormat::RGHalf:
        return R16G16_SFloat;
    case TextureFormat::RGBAHalf:
        return R16G16B16A16_SFloat;
    case TextureFormat::RFloat:
        return R32_SFloat;
    case TextureFormat::RGFloat:
        return R32G32_SFloat;
    case TextureFormat::RGBAFloat:
        return R32G32B32A32_SFloat;
    case TextureFormat::RGB9e5Float:
        return E5B9G9R9_UFloatPack32;
    case TextureFormat::BC6H:
        return RGB_BC6H_UFloat;
    case TextureFormat::BC7:
        return sRGB ? RGBA_BC7_SRGB : RGBA_BC7_UNorm;
    case TextureFormat::BC4:
        return R_BC4_UNorm;
    case TextureFormat::BC5:
        return RG_BC5_UNorm;
    case TextureFormat::RG16:
        return sRGB ? R8G8_SRGB : R8G8_UNorm;
    case TextureFormat::R8:
        return sRGB ? R8_SRGB : R8_UNorm;
    case TextureFormat::RG32:
        return R16G16_UNorm;
    case TextureFormat::RGB48:
        return R16G16B16_UNorm;
    case TextureFormat::RGBA64:
        return R16G16B16A16_UNorm;
    }
    throw ContractError("TextureFormat " + std::to_string(static_cast<int>(format)) +
                        " is not one that limn knows");
}

std::string GraphicsFormatProblem(GraphicsFormat format)
{
    const RefusedFormat* refused = FindRefused(format);
    return refused == nullptr
               ? ""
               : std::string(refused->reason) + "; " + ToString(refused->instead) + " would do";
}

GraphicsFormat MadeFormat(GraphicsFormat format)
{
    return !IsDepthFormat(format) ? format : HasStencil(format) ? D32_SFloat_S8_UInt : D32_SFloat;
}

bool IsSRGBFormat(GraphicsFormat format)
{
    return std::string_view(ToString(format)).find("SRGB") != std::string_view::npos;
}

int BytesPerTexel(GraphicsFormat format)
{
    return FactsOf(format, "texels").bytes;
}

int ChannelCount(GraphicsFormat format)
{
    return FactsOf(format, "components").channels;
}

UniformType ComponentType(GraphicsFormat format)
{
    return FactsOf(format, "components").type;
}

const char* ToString(GraphicsFormat format)
{
    if (const FormatFacts* facts = Find(format))
    {
        return facts->name;
    }
    const RefusedFormat* refused = FindRefused(format);
    return refused != nullptr ? refused->name : format == None ? "None" : "(unknown)";
}

} // namespace limn

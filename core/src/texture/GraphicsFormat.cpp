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

/// A format under one of the older names.
template <typename Name>
struct NamedFormat
{
    Name name;
    GraphicsFormat linear;
    GraphicsFormat sRGB = linear;
};

constexpr NamedFormat<RenderTextureFormat> k_RenderTextureFormats[] = {
    {RenderTextureFormat::ARGB32, R8G8B8A8_UNorm, R8G8B8A8_SRGB},
    {RenderTextureFormat::Default, R8G8B8A8_UNorm, R8G8B8A8_SRGB},
    {RenderTextureFormat::BGRA32, B8G8R8A8_UNorm, B8G8R8A8_SRGB},
    {RenderTextureFormat::Depth, D32_SFloat},
    {RenderTextureFormat::Shadowmap, D32_SFloat},
    {RenderTextureFormat::RGB565, B5G6R5_UNormPack16},
    {RenderTextureFormat::ARGB4444, B4G4R4A4_UNormPack16},
    {RenderTextureFormat::ARGB1555, B5G5R5A1_UNormPack16},
    {RenderTextureFormat::BGRA10101010_XR, A10R10G10B10_XRUNormPack32},
    {RenderTextureFormat::BGR101010_XR, R10G10B10_XRUNormPack32},
    {RenderTextureFormat::ARGBHalf, R16G16B16A16_SFloat},
    {RenderTextureFormat::ARGB2101010, A2B10G10R10_UNormPack32},
    {RenderTextureFormat::ARGB64, R16G16B16A16_UNorm},
    {RenderTextureFormat::ARGBFloat, R32G32B32A32_SFloat},
    {RenderTextureFormat::RGFloat, R32G32_SFloat},
    {RenderTextureFormat::RGHalf, R16G16_SFloat},
    {RenderTextureFormat::RFloat, R32_SFloat},
    {RenderTextureFormat::RHalf, R16_SFloat},
    {RenderTextureFormat::R8, R8_UNorm},
    {RenderTextureFormat::ARGBInt, R32G32B32A32_SInt},
    {RenderTextureFormat::RGInt, R32G32_SInt},
    {RenderTextureFormat::RInt, R32_SInt},
    {RenderTextureFormat::RGB111110Float, B10G11R11_UFloatPack32},
    {RenderTextureFormat::DefaultHDR, B10G11R11_UFloatPack32},
    {RenderTextureFormat::RG32, R16G16_UNorm},
    {RenderTextureFormat::RGBAUShort, R16G16B16A16_UInt},
    {RenderTextureFormat::RG16, R8G8_UNorm},
    {RenderTextureFormat::R16, R16_UNorm},
};

constexpr NamedFormat<TextureFormat> k_TextureFormats[] = {
    {TextureFormat::Alpha8, R8_UNorm},
    {TextureFormat::ARGB4444, None},
    {TextureFormat::ARGB32, None},
    {TextureFormat::RGB24, R8G8B8_UNorm, R8G8B8_SRGB},
    {TextureFormat::RGBA32, R8G8B8A8_UNorm, R8G8B8A8_SRGB},
    {TextureFormat::RGB565, R5G6B5_UNormPack16},
    {TextureFormat::R16, R16_UNorm},
    {TextureFormat::DXT1, RGBA_DXT1_UNorm, RGBA_DXT1_SRGB},
    {TextureFormat::DXT5, RGBA_DXT5_UNorm, RGBA_DXT5_SRGB},
    {TextureFormat::RGBA4444, R4G4B4A4_UNormPack16},
    {TextureFormat::BGRA32, B8G8R8A8_UNorm, B8G8R8A8_SRGB},
    {TextureFormat::RHalf, R16_SFloat},
    {TextureFormat::RGHalf, R16G16_SFloat},
    {TextureFormat::RGBAHalf, R16G16B16A16_SFloat},
    {TextureFormat::RFloat, R32_SFloat},
    {TextureFormat::RGFloat, R32G32_SFloat},
    {TextureFormat::RGBAFloat, R32G32B32A32_SFloat},
    {TextureFormat::RGB9e5Float, E5B9G9R9_UFloatPack32},
    {TextureFormat::BC6H, RGB_BC6H_UFloat},
    {TextureFormat::BC7, RGBA_BC7_UNorm, RGBA_BC7_SRGB},
    {TextureFormat::BC4, R_BC4_UNorm},
    {TextureFormat::BC5, RG_BC5_UNorm},
    {TextureFormat::RG16, R8G8_UNorm, R8G8_SRGB},
    {TextureFormat::R8, R8_UNorm, R8_SRGB},
    {TextureFormat::RG32, R16G16_UNorm},
    {TextureFormat::RGB48, R16G16B16_UNorm},
    {TextureFormat::RGBA64, R16G16B16A16_UNorm},
};

template <typename Name, std::size_t Count>
GraphicsFormat FormatOf(const NamedFormat<Name> (&formats)[Count], const char* type, Name name,
                        bool sRGB)
{
    const auto found = std::ranges::find(formats, name, &NamedFormat<Name>::name);
    if (found == std::end(formats))
    {
        throw ContractError(std::string(type) + " " + std::to_string(static_cast<int>(name)) +
                            " is not one that limn knows");
    }
    return sRGB ? found->sRGB : found->linear;
}

} // namespace

GraphicsFormat ToGraphicsFormat(RenderTextureFormat format, bool sRGB)
{
    return FormatOf(k_RenderTextureFormats, "RenderTextureFormat", format, sRGB);
}

GraphicsFormat ToGraphicsFormat(TextureFormat format, bool sRGB)
{
    return FormatOf(k_TextureFormats, "TextureFormat", format, sRGB);
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

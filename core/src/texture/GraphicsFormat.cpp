#include <limn/core/GraphicsFormatUtility.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <limn/base/Diagnostic.h>
#include <limn/base/WordList.h>

namespace limn
{

namespace
{

using enum GraphicsFormat;

/// Returns the names of the formats at their numbers.
const std::vector<std::string>& FormatNames()
{
    static const std::vector<std::string_view> words = SplitWords(
        "None R8_SRGB R8G8_SRGB R8G8B8_SRGB R8G8B8A8_SRGB R8_UNorm R8G8_UNorm R8G8B8_UNorm "
        "R8G8B8A8_UNorm R8_SNorm R8G8_SNorm R8G8B8_SNorm R8G8B8A8_SNorm R8_UInt R8G8_UInt "
        "R8G8B8_UInt R8G8B8A8_UInt R8_SInt R8G8_SInt R8G8B8_SInt R8G8B8A8_SInt R16_UNorm "
        "R16G16_UNorm R16G16B16_UNorm R16G16B16A16_UNorm R16_SNorm R16G16_SNorm "
        "R16G16B16_SNorm R16G16B16A16_SNorm R16_UInt R16G16_UInt R16G16B16_UInt "
        "R16G16B16A16_UInt R16_SInt R16G16_SInt R16G16B16_SInt R16G16B16A16_SInt R32_UInt "
        "R32G32_UInt R32G32B32_UInt R32G32B32A32_UInt R32_SInt R32G32_SInt R32G32B32_SInt "
        "R32G32B32A32_SInt R16_SFloat R16G16_SFloat R16G16B16_SFloat R16G16B16A16_SFloat "
        "R32_SFloat R32G32_SFloat R32G32B32_SFloat R32G32B32A32_SFloat (unknown) (unknown) "
        "(unknown) B8G8R8_SRGB B8G8R8A8_SRGB B8G8R8_UNorm B8G8R8A8_UNorm B8G8R8_SNorm "
        "B8G8R8A8_SNorm B8G8R8_UInt B8G8R8A8_UInt B8G8R8_SInt B8G8R8A8_SInt "
        "R4G4B4A4_UNormPack16 B4G4R4A4_UNormPack16 R5G6B5_UNormPack16 B5G6R5_UNormPack16 "
        "R5G5B5A1_UNormPack16 B5G5R5A1_UNormPack16 A1R5G5B5_UNormPack16 "
        "E5B9G9R9_UFloatPack32 B10G11R11_UFloatPack32 A2B10G10R10_UNormPack32 "
        "A2B10G10R10_UIntPack32 A2B10G10R10_SIntPack32 A2R10G10B10_UNormPack32 "
        "A2R10G10B10_UIntPack32 A2R10G10B10_SIntPack32 A2R10G10B10_XRSRGBPack32 "
        "A2R10G10B10_XRUNormPack32 R10G10B10_XRSRGBPack32 R10G10B10_XRUNormPack32 "
        "A10R10G10B10_XRSRGBPack32 A10R10G10B10_XRUNormPack32 (unknown) (unknown) (unknown) "
        "D16_UNorm D24_UNorm D24_UNorm_S8_UInt D32_SFloat D32_SFloat_S8_UInt S8_UInt "
        "RGBA_DXT1_SRGB RGBA_DXT1_UNorm RGBA_DXT3_SRGB RGBA_DXT3_UNorm RGBA_DXT5_SRGB "
        "RGBA_DXT5_UNorm R_BC4_UNorm R_BC4_SNorm RG_BC5_UNorm RG_BC5_SNorm RGB_BC6H_UFloat "
        "RGB_BC6H_SFloat RGBA_BC7_SRGB RGBA_BC7_UNorm RGB_PVRTC_2Bpp_SRGB "
        "RGB_PVRTC_2Bpp_UNorm RGB_PVRTC_4Bpp_SRGB RGB_PVRTC_4Bpp_UNorm RGBA_PVRTC_2Bpp_SRGB "
        "RGBA_PVRTC_2Bpp_UNorm RGBA_PVRTC_4Bpp_SRGB RGBA_PVRTC_4Bpp_UNorm RGB_ETC_UNorm "
        "RGB_ETC2_SRGB RGB_ETC2_UNorm RGB_A1_ETC2_SRGB RGB_A1_ETC2_UNorm RGBA_ETC2_SRGB "
        "RGBA_ETC2_UNorm R_EAC_UNorm R_EAC_SNorm RG_EAC_UNorm RG_EAC_SNorm "
        "RGBA_ASTC4X4_SRGB RGBA_ASTC4X4_UNorm RGBA_ASTC5X5_SRGB RGBA_ASTC5X5_UNorm "
        "RGBA_ASTC6X6_SRGB RGBA_ASTC6X6_UNorm RGBA_ASTC8X8_SRGB RGBA_ASTC8X8_UNorm "
        "RGBA_ASTC10X10_SRGB RGBA_ASTC10X10_UNorm RGBA_ASTC12X12_SRGB RGBA_ASTC12X12_UNorm "
        "YUV2 DepthAuto ShadowAuto VideoAuto RGBA_ASTC4X4_UFloat RGBA_ASTC5X5_UFloat "
        "RGBA_ASTC6X6_UFloat RGBA_ASTC8X8_UFloat RGBA_ASTC10X10_UFloat "
        "RGBA_ASTC12X12_UFloat D16_UNorm_S8_UInt");
    static const std::vector<std::string> names(words.begin(), words.end());
    return names;
}

struct FormatFacts
{
    unsigned bytes = 0;
    int channels = 0;
    UniformType type = UniformType::Float;
};

/// Returns the facts about a format that its name tells, component by component: "R5G6B5_UNorm";
/// no bytes for a format that limn does not make.
FormatFacts ReadFacts(GraphicsFormat format)
{
    const std::string_view name = ToString(format);
    const bool isMade = format <= A2R10G10B10_SIntPack32 || IsDepthFormat(format);
    FormatFacts facts;
    unsigned bits = 0;
    for (std::size_t i = 1; isMade && i < name.size(); ++i)
    {
        unsigned bitsOfOne = 0;
        if (name[i - 1] >= 'A' && name[i - 1] <= 'Z' &&
            std::from_chars(&name[i], name.data() + name.size(), bitsOfOne).ec == std::errc())
        {
            bits += bitsOfOne;
            facts.channels += name[i - 1] != 'E' ? 1 : 0; // an exponent is of all components
        }
    }
    if (bits == 0)
    {
        return facts;
    }
    facts.bytes = IsDepthFormat(format) ? std::bit_ceil(bits / 8) : bits / 8;
    const std::string_view type = name.substr(name.find('_'));
    facts.type = type.starts_with("_UInt")   ? UniformType::UInt
                 : type.starts_with("_SInt") ? UniformType::Int
                                             : UniformType::Float;
    return facts;
}

/// @param what  the part that another format lacks: "texels"
const FormatFacts& FactsOf(GraphicsFormat format, const char* what)
{
    static const std::vector<FormatFacts> all = []
    {
        std::vector<FormatFacts> facts;
        for (std::size_t i = 0; i < FormatNames().size(); ++i)
        {
            facts.push_back(ReadFacts(static_cast<GraphicsFormat>(i)));
        }
        return facts;
    }();
    const auto number = static_cast<std::size_t>(format);
    if (number >= all.size() || all[number].bytes == 0)
    {
        const std::string problem = GraphicsFormatProblem(format);
        throw ContractError("GraphicsFormat " + std::string(ToString(format)) +
                            (problem.empty() ? " has no " + std::string(what) +
                                                   "; a format that limn knows is needed"
                                             : " " + problem));
    }
    return all[number];
}

/// Returns the format that holds the components of a compressed one.
GraphicsFormat Uncompressed(GraphicsFormat format)
{
    const std::string_view name = ToString(format);
    const bool isSigned = name.ends_with("SNorm");
    return name.ends_with("Float")   ? R16G16B16A16_SFloat
           : name.starts_with("R_")  ? (isSigned ? R8_SNorm : R8_UNorm)
           : name.starts_with("RG_") ? (isSigned ? R8G8_SNorm : R8G8_UNorm)
           : IsSRGBFormat(format)    ? R8G8B8A8_SRGB
                                     : R8G8B8A8_UNorm;
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
    const auto problem = [](const std::string& reason, GraphicsFormat instead)
    {
        return reason + "; " + ToString(instead) + " would do";
    };
    if (format < A2R10G10B10_XRSRGBPack32 || IsDepthFormat(format)) // nearly all, asked each frame
    {
        return "";
    }
    if (GraphicsFormatUtility::IsCompressedFormat(format))
    {
        return problem("is compressed", Uncompressed(format));
    }
    if (format >= A2R10G10B10_XRSRGBPack32 && format <= A10R10G10B10_XRUNormPack32)
    {
        return problem("is of an extended range, for displays that limn does not draw to",
                       R16G16B16A16_SFloat);
    }
    switch (format)
    {
    case YUV2:
    case VideoAuto:
        return problem("is for video, which limn does not have", R8G8B8A8_UNorm);
    case DepthAuto:
        return problem("leaves the choice to Unity", D32_SFloat_S8_UInt);
    case ShadowAuto:
        return problem("leaves the choice to Unity", D32_SFloat);
    default:
        return "";
    }
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
    return static_cast<int>(FactsOf(format, "texels").bytes);
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
    const auto number = static_cast<std::size_t>(format);
    return number < FormatNames().size() ? FormatNames()[number].c_str() : "(unknown)";
}

} // namespace limn

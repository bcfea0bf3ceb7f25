#include <limn/core/GraphicsFormatUtility.h>

#include <algorithm>
#include <limn/base/Diagnostic.h>

namespace limn
{

namespace
{

std::string_view NameOf(GraphicsFormat format)
{
    return ToString(format);
}

/// Returns the components that a name lists: of "R16G16_SFloat" RG, of "RGBA_BC7_SRGB" RGBA.
std::string Letters(GraphicsFormat format)
{
    std::string letters(NameOf(format).substr(0, NameOf(format).find('_')));
    std::erase_if(letters, [](char c)
                  { return std::string_view("RGBA").find(c) == std::string_view::npos; });
    return letters;
}

/// Compressed formats by a part of their names.
struct BlockFacts
{
    std::string_view part;
    std::uint32_t width;
    std::uint32_t height;
    std::uint32_t bytes;
};
constexpr BlockFacts k_Blocks[] = {
    {"DXT1", 4, 4, 8},         {"DXT3", 4, 4, 16},        {"DXT5", 4, 4, 16},
    {"BC4", 4, 4, 8},          {"BC5", 4, 4, 16},         {"BC6H", 4, 4, 16},
    {"BC7", 4, 4, 16},         {"PVRTC_2Bpp", 8, 4, 8},   {"PVRTC_4Bpp", 4, 4, 8},
    {"RGB_ETC", 4, 4, 8},      {"RGB_A1_ETC2", 4, 4, 8},  {"RGBA_ETC2", 4, 4, 16},
    {"R_EAC", 4, 4, 8},        {"RG_EAC", 4, 4, 16},      {"ASTC4X4", 4, 4, 16},
    {"ASTC5X5", 5, 5, 16},     {"ASTC6X6", 6, 6, 16},     {"ASTC8X8", 8, 8, 16},
    {"ASTC10X10", 10, 10, 16}, {"ASTC12X12", 12, 12, 16},
};

/// Returns the facts about a compressed format; a block of any other is a texel.
const BlockFacts& BlockOf(GraphicsFormat format)
{
    static constexpr BlockFacts k_Texel{"", 1, 1, 0};
    const auto isOf = [&](const BlockFacts& block)
    {
        const std::size_t at = NameOf(format).find(block.part);
        return block.part.starts_with("R") ? at == 0 : at != std::string_view::npos;
    };
    const auto found = std::ranges::find_if(k_Blocks, isOf);
    return found == std::end(k_Blocks) ? k_Texel : *found;
}

/// Returns the format of a name with another word in it, or the format itself if there is none.
GraphicsFormat WithWord(GraphicsFormat format, std::string_view word, std::string_view instead)
{
    std::string name(NameOf(format));
    const std::size_t at = name.find(word);
    if (at == std::string::npos)
    {
        return format;
    }
    name.replace(at, word.size(), instead);
    for (int i = 1; i <= static_cast<int>(GraphicsFormat::D16_UNorm_S8_UInt); ++i)
    {
        if (const auto other = static_cast<GraphicsFormat>(i); NameOf(other) == name)
        {
            return other;
        }
    }
    return format;
}

} // namespace

RenderTextureFormat GraphicsFormatUtility::GetRenderTextureFormat(GraphicsFormat format)
{
    using enum RenderTextureFormat;
    if (limn::IsDepthFormat(format))
    {
        return Depth;
    }
    for (const RenderTextureFormat name :
         {ARGB32,      BGRA32,     ARGBHalf,  RGB565,          ARGB4444,     ARGB1555,
          ARGB2101010, ARGB64,     ARGBFloat, RGFloat,         RGHalf,       RFloat,
          RHalf,       R8,         ARGBInt,   RGInt,           RInt,         RGB111110Float,
          RG32,        RGBAUShort, RG16,      BGRA10101010_XR, BGR101010_XR, R16})
    {
        if (ToGraphicsFormat(name, true) == format || ToGraphicsFormat(name, false) == format)
        {
            return name;
        }
    }
    return Default;
}

GraphicsFormat GraphicsFormatUtility::GetDepthStencilFormat(int minimumDepthBits,
                                                            int minimumStencilBits)
{
    if (minimumDepthBits < 0 || minimumDepthBits > 32 || minimumStencilBits < 0 ||
        minimumStencilBits > 8)
    {
        throw ContractError("GetDepthStencilFormat: it was asked for " +
                            std::to_string(minimumDepthBits) + " bits of depth and " +
                            std::to_string(minimumStencilBits) +
                            " of stencil; they must be 0 to 32 and 0 to 8");
    }
    return minimumStencilBits > 0 ? GraphicsFormat::D32_SFloat_S8_UInt
           : minimumDepthBits > 0 ? GraphicsFormat::D32_SFloat
                                  : GraphicsFormat::None;
}

int GraphicsFormatUtility::GetDepthBits(GraphicsFormat format)
{
    return NameOf(format).starts_with("D16")   ? 16
           : NameOf(format).starts_with("D24") ? 24
           : NameOf(format).starts_with("D32") ? 32
                                               : 0;
}

GraphicsFormat GraphicsFormatUtility::GetSRGBFormat(GraphicsFormat format)
{
    return Has(format, "XRUNorm") ? WithWord(format, "XRUNorm", "XRSRGB")
                                  : WithWord(format, "UNorm", "SRGB");
}

GraphicsFormat GraphicsFormatUtility::GetLinearFormat(GraphicsFormat format)
{
    return WithWord(format, "SRGB", "UNorm");
}

std::uint32_t GraphicsFormatUtility::GetComponentCount(GraphicsFormat format)
{
    return static_cast<std::uint32_t>(Letters(format).size()) + (Has(format, "RGB_A1") ? 1u : 0u);
}

std::uint32_t GraphicsFormatUtility::GetAlphaComponentCount(GraphicsFormat format)
{
    return Letters(format).find('A') != std::string::npos || Has(format, "RGB_A1") ? 1 : 0;
}

std::uint32_t GraphicsFormatUtility::GetBlockWidth(GraphicsFormat format)
{
    return BlockOf(format).width;
}

std::uint32_t GraphicsFormatUtility::GetBlockHeight(GraphicsFormat format)
{
    return BlockOf(format).height;
}

std::uint32_t GraphicsFormatUtility::GetBlockSize(GraphicsFormat format)
{
    if (IsCompressedFormat(format))
    {
        return BlockOf(format).bytes;
    }
    if (Has(format, "_XR"))
    {
        return NameOf(format).starts_with("A10") ? 8 : 4;
    }
    return static_cast<std::uint32_t>(BytesPerTexel(format));
}

std::uint32_t GraphicsFormatUtility::ComputeMipmapSize(int width, int height, GraphicsFormat format)
{
    const BlockFacts& block = BlockOf(format);
    const auto across = (static_cast<std::uint32_t>(width) + block.width - 1) / block.width;
    const auto down = (static_cast<std::uint32_t>(height) + block.height - 1) / block.height;
    return across * down * GetBlockSize(format);
}

bool GraphicsFormatUtility::IsCompressedFormat(GraphicsFormat format)
{
    return BlockOf(format).bytes != 0;
}

} // namespace limn

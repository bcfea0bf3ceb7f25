#include <limn/core/GraphicsFormatUtility.h>

#include <algorithm>
#include <array>
#include <limn/base/Diagnostic.h>
#include <string_view>

namespace limn
{

namespace
{

constexpr int k_LastFormat = static_cast<int>(GraphicsFormat::D16_UNorm_S8_UInt);

std::string_view NameOf(GraphicsFormat format)
{
    return ToString(format);
}

bool Has(GraphicsFormat format, std::string_view part)
{
    return NameOf(format).find(part) != std::string_view::npos;
}

/// The components that a name lists: of "R16G16_SFloat" RG, of "RGBA_BC7_SRGB" RGBA.
std::string_view Letters(GraphicsFormat format, std::array<char, 8>& text)
{
    const std::string_view name = NameOf(format);
    std::size_t count = 0;
    for (const char c : name.substr(0, name.find('_')))
    {
        if (std::string_view("RGBA").find(c) != std::string_view::npos && count < text.size())
        {
            text[count++] = c;
        }
    }
    return {text.data(), count};
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

/// Returns the facts about a compressed format, or null for other formats.
const BlockFacts* BlockOf(GraphicsFormat format)
{
    const auto found = std::ranges::find_if(k_Blocks,
                                            [&](const BlockFacts& block)
                                            {
                                                return block.part.starts_with("R")
                                                           ? NameOf(format).starts_with(block.part)
                                                           : Has(format, block.part);
                                            });
    return found == std::end(k_Blocks) ? nullptr : found;
}

GraphicsFormat FindByName(const std::string& name)
{
    for (int i = 1; i <= k_LastFormat; ++i)
    {
        const auto format = static_cast<GraphicsFormat>(i);
        if (NameOf(format) == name)
        {
            return format;
        }
    }
    return GraphicsFormat::None;
}

/// The format of a name with another word in it; itself where there is none.
GraphicsFormat WithWord(GraphicsFormat format, std::string_view word, std::string_view instead)
{
    std::string name(NameOf(format));
    const std::size_t at = name.find(word);
    if (at == std::string::npos)
    {
        return format;
    }
    const GraphicsFormat pair = FindByName(name.replace(at, word.size(), instead));
    return pair == GraphicsFormat::None ? format : pair;
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

GraphicsFormat GraphicsFormatUtility::GetDepthStencilFormat(int minimumDepthBits)
{
    return GetDepthStencilFormat(minimumDepthBits, minimumDepthBits > 16 ? 8 : 0);
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
    std::array<char, 8> text{};
    return static_cast<std::uint32_t>(Letters(format, text).size()) +
           (Has(format, "RGB_A1") ? 1u : 0u);
}

std::uint32_t GraphicsFormatUtility::GetAlphaComponentCount(GraphicsFormat format)
{
    std::array<char, 8> text{};
    const bool hasAlpha = Letters(format, text).find('A') != std::string_view::npos;
    return hasAlpha || Has(format, "RGB_A1") ? 1 : 0;
}

std::uint32_t GraphicsFormatUtility::GetColorComponentCount(GraphicsFormat format)
{
    return GetComponentCount(format) - GetAlphaComponentCount(format);
}

bool GraphicsFormatUtility::HasAlphaChannel(GraphicsFormat format)
{
    return GetAlphaComponentCount(format) > 0;
}

std::uint32_t GraphicsFormatUtility::GetBlockWidth(GraphicsFormat format)
{
    const BlockFacts* block = BlockOf(format);
    return block != nullptr ? block->width : 1;
}

std::uint32_t GraphicsFormatUtility::GetBlockHeight(GraphicsFormat format)
{
    const BlockFacts* block = BlockOf(format);
    return block != nullptr ? block->height : 1;
}

std::uint32_t GraphicsFormatUtility::GetBlockSize(GraphicsFormat format)
{
    if (const BlockFacts* block = BlockOf(format))
    {
        return block->bytes;
    }
    if (Has(format, "_XR"))
    {
        return NameOf(format).starts_with("A10") ? 8 : 4;
    }
    return static_cast<std::uint32_t>(BytesPerTexel(format));
}

std::uint32_t GraphicsFormatUtility::ComputeMipmapSize(int width, int height, GraphicsFormat format)
{
    const std::uint32_t blockWidth = GetBlockWidth(format);
    const std::uint32_t blockHeight = GetBlockHeight(format);
    const auto across = (static_cast<std::uint32_t>(width) + blockWidth - 1) / blockWidth;
    const auto down = (static_cast<std::uint32_t>(height) + blockHeight - 1) / blockHeight;
    return across * down * GetBlockSize(format);
}

bool GraphicsFormatUtility::IsDepthFormat(GraphicsFormat format)
{
    return limn::IsDepthFormat(format) && format != GraphicsFormat::S8_UInt;
}

bool GraphicsFormatUtility::IsStencilFormat(GraphicsFormat format)
{
    return HasStencil(format);
}

bool GraphicsFormatUtility::IsDepthStencilFormat(GraphicsFormat format)
{
    return limn::IsDepthFormat(format);
}

bool GraphicsFormatUtility::IsCompressedFormat(GraphicsFormat format)
{
    return BlockOf(format) != nullptr;
}

bool GraphicsFormatUtility::IsPackedFormat(GraphicsFormat format)
{
    return Has(format, "Pack16") || Has(format, "Pack32");
}

bool GraphicsFormatUtility::IsHalfFormat(GraphicsFormat format)
{
    return Has(format, "16_SFloat");
}

bool GraphicsFormatUtility::IsFloatFormat(GraphicsFormat format)
{
    return Has(format, "32_SFloat");
}

bool GraphicsFormatUtility::IsIEEE754Format(GraphicsFormat format)
{
    return IsHalfFormat(format) || IsFloatFormat(format);
}

bool GraphicsFormatUtility::IsIntegerFormat(GraphicsFormat format)
{
    return IsUIntFormat(format) || IsSIntFormat(format);
}

bool GraphicsFormatUtility::IsUIntFormat(GraphicsFormat format)
{
    return Has(format, "UInt") && !GraphicsFormatUtility::IsDepthFormat(format);
}

bool GraphicsFormatUtility::IsSIntFormat(GraphicsFormat format)
{
    return Has(format, "SInt");
}

bool GraphicsFormatUtility::IsNormFormat(GraphicsFormat format)
{
    return IsUNormFormat(format) || IsSNormFormat(format);
}

bool GraphicsFormatUtility::IsUNormFormat(GraphicsFormat format)
{
    return Has(format, "UNorm") || limn::IsSRGBFormat(format);
}

bool GraphicsFormatUtility::IsSNormFormat(GraphicsFormat format)
{
    return Has(format, "SNorm");
}

bool GraphicsFormatUtility::IsSignedFormat(GraphicsFormat format)
{
    return Has(format, "SNorm") || Has(format, "SInt") || Has(format, "SFloat");
}

} // namespace limn

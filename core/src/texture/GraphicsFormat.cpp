#include <limn/core/GraphicsFormat.h>

#include <algorithm>
#include <limn/shaderlab/Diagnostic.h>
#include <string>

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
    {R8G8B8A8_SRGB, "R8G8B8A8_SRGB", 4, 4, k_Float},
    {R8_UNorm, "R8_UNorm", 1, 1, k_Float},
    {R8G8_UNorm, "R8G8_UNorm", 2, 2, k_Float},
    {R8G8B8A8_UNorm, "R8G8B8A8_UNorm", 4, 4, k_Float},
    {R8G8B8A8_SNorm, "R8G8B8A8_SNorm", 4, 4, k_Float},
    {R8_UInt, "R8_UInt", 1, 1, k_UInt},
    {R8G8B8A8_UInt, "R8G8B8A8_UInt", 4, 4, k_UInt},
    {R16_UNorm, "R16_UNorm", 2, 1, k_Float},
    {R16G16_UNorm, "R16G16_UNorm", 4, 2, k_Float},
    {R16G16B16A16_UNorm, "R16G16B16A16_UNorm", 8, 4, k_Float},
    {R16_UInt, "R16_UInt", 2, 1, k_UInt},
    {R16G16B16A16_UInt, "R16G16B16A16_UInt", 8, 4, k_UInt},
    {R32_UInt, "R32_UInt", 4, 1, k_UInt},
    {R32G32_UInt, "R32G32_UInt", 8, 2, k_UInt},
    {R32G32B32A32_UInt, "R32G32B32A32_UInt", 16, 4, k_UInt},
    {R32_SInt, "R32_SInt", 4, 1, k_Int},
    {R32G32_SInt, "R32G32_SInt", 8, 2, k_Int},
    {R32G32B32A32_SInt, "R32G32B32A32_SInt", 16, 4, k_Int},
    {R16_SFloat, "R16_SFloat", 2, 1, k_Float},
    {R16G16_SFloat, "R16G16_SFloat", 4, 2, k_Float},
    {R16G16B16A16_SFloat, "R16G16B16A16_SFloat", 8, 4, k_Float},
    {R32_SFloat, "R32_SFloat", 4, 1, k_Float},
    {R32G32_SFloat, "R32G32_SFloat", 8, 2, k_Float},
    {R32G32B32A32_SFloat, "R32G32B32A32_SFloat", 16, 4, k_Float},
    {B8G8R8A8_SRGB, "B8G8R8A8_SRGB", 4, 4, k_Float},
    {B8G8R8A8_UNorm, "B8G8R8A8_UNorm", 4, 4, k_Float},
    {B10G11R11_UFloatPack32, "B10G11R11_UFloatPack32", 4, 3, k_Float},
    {A2B10G10R10_UNormPack32, "A2B10G10R10_UNormPack32", 4, 4, k_Float},
    {D32_SFloat, "D32_SFloat", 4, 1, k_Float},
    {D32_SFloat_S8_UInt, "D32_SFloat_S8_UInt", 8, 2, k_Float},
};

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
    throw ContractError("GraphicsFormat " + std::string(ToString(format)) + " has no " + what +
                        "; a format that limn knows is needed");
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
    const FormatFacts* facts = Find(format);
    return facts != nullptr ? facts->name : format == None ? "None" : "(unknown)";
}

} // namespace limn

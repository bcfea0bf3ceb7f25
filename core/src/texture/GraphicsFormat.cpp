#include <limn/core/GraphicsFormat.h>

#include <limn/shaderlab/Diagnostic.h>
#include <string>

namespace limn
{

GraphicsFormat ToGraphicsFormat(RenderTextureFormat format, bool sRGB)
{
    switch (format)
    {
    case RenderTextureFormat::ARGB32:
        return sRGB ? GraphicsFormat::R8G8B8A8_SRGB : GraphicsFormat::R8G8B8A8_UNorm;
    case RenderTextureFormat::Depth:
        return GraphicsFormat::D32_SFloat;
    case RenderTextureFormat::ARGBHalf:
        return GraphicsFormat::R16G16B16A16_SFloat;
    case RenderTextureFormat::ARGBFloat:
        return GraphicsFormat::R32G32B32A32_SFloat;
    case RenderTextureFormat::RGFloat:
        return GraphicsFormat::R32G32_SFloat;
    case RenderTextureFormat::RGHalf:
        return GraphicsFormat::R16G16_SFloat;
    case RenderTextureFormat::RFloat:
        return GraphicsFormat::R32_SFloat;
    case RenderTextureFormat::RHalf:
        return GraphicsFormat::R16_SFloat;
    case RenderTextureFormat::R8:
        return GraphicsFormat::R8_UNorm;
    case RenderTextureFormat::RGB111110Float:
        return GraphicsFormat::B10G11R11_UFloatPack32;
    }
    throw ContractError("RenderTextureFormat " + std::to_string(static_cast<int>(format)) +
                        " is not one that limn knows");
}

int BytesPerTexel(GraphicsFormat format)
{
    switch (format)
    {
    case GraphicsFormat::R8_UNorm:
        return 1;
    case GraphicsFormat::R16_SFloat:
        return 2;
    case GraphicsFormat::R8G8B8A8_SRGB:
    case GraphicsFormat::R8G8B8A8_UNorm:
    case GraphicsFormat::R8G8B8A8_SNorm:
    case GraphicsFormat::R16G16_UNorm:
    case GraphicsFormat::R16G16_SFloat:
    case GraphicsFormat::R32_SFloat:
    case GraphicsFormat::B10G11R11_UFloatPack32:
    case GraphicsFormat::D32_SFloat:
        return 4;
    case GraphicsFormat::R16G16B16A16_UNorm:
    case GraphicsFormat::R16G16B16A16_SFloat:
    case GraphicsFormat::R32G32_SFloat:
    case GraphicsFormat::D32_SFloat_S8_UInt:
        return 8;
    case GraphicsFormat::R32G32B32A32_SFloat:
        return 16;
    case GraphicsFormat::None:
        break;
    }
    throw ContractError("GraphicsFormat " + std::string(ToString(format)) +
                        " has no texels; a format that limn knows is needed");
}

int ChannelCount(GraphicsFormat format)
{
    switch (format)
    {
    case GraphicsFormat::R8_UNorm:
    case GraphicsFormat::R16_SFloat:
    case GraphicsFormat::R32_SFloat:
    case GraphicsFormat::D32_SFloat:
        return 1;
    case GraphicsFormat::R16G16_UNorm:
    case GraphicsFormat::R16G16_SFloat:
    case GraphicsFormat::R32G32_SFloat:
    case GraphicsFormat::D32_SFloat_S8_UInt:
        return 2;
    case GraphicsFormat::B10G11R11_UFloatPack32:
        return 3;
    case GraphicsFormat::R8G8B8A8_SRGB:
    case GraphicsFormat::R8G8B8A8_UNorm:
    case GraphicsFormat::R8G8B8A8_SNorm:
    case GraphicsFormat::R16G16B16A16_UNorm:
    case GraphicsFormat::R16G16B16A16_SFloat:
    case GraphicsFormat::R32G32B32A32_SFloat:
        return 4;
    case GraphicsFormat::None:
        break;
    }
    throw ContractError("GraphicsFormat " + std::string(ToString(format)) +
                        " has no components; a format that limn knows is needed");
}

const char* ToString(GraphicsFormat format)
{
    switch (format)
    {
    case GraphicsFormat::None:
        return "None";
    case GraphicsFormat::R8G8B8A8_SRGB:
        return "R8G8B8A8_SRGB";
    case GraphicsFormat::R8_UNorm:
        return "R8_UNorm";
    case GraphicsFormat::R8G8B8A8_UNorm:
        return "R8G8B8A8_UNorm";
    case GraphicsFormat::R8G8B8A8_SNorm:
        return "R8G8B8A8_SNorm";
    case GraphicsFormat::R16G16_UNorm:
        return "R16G16_UNorm";
    case GraphicsFormat::R16G16B16A16_UNorm:
        return "R16G16B16A16_UNorm";
    case GraphicsFormat::R16_SFloat:
        return "R16_SFloat";
    case GraphicsFormat::R16G16_SFloat:
        return "R16G16_SFloat";
    case GraphicsFormat::R16G16B16A16_SFloat:
        return "R16G16B16A16_SFloat";
    case GraphicsFormat::R32_SFloat:
        return "R32_SFloat";
    case GraphicsFormat::R32G32_SFloat:
        return "R32G32_SFloat";
    case GraphicsFormat::R32G32B32A32_SFloat:
        return "R32G32B32A32_SFloat";
    case GraphicsFormat::B10G11R11_UFloatPack32:
        return "B10G11R11_UFloatPack32";
    case GraphicsFormat::D32_SFloat:
        return "D32_SFloat";
    case GraphicsFormat::D32_SFloat_S8_UInt:
        return "D32_SFloat_S8_UInt";
    }
    return "(unknown)";
}

} // namespace limn

#include <algorithm>
#include <limn/core/GraphicsDevice.h>
#include <limn/core/SystemInfo.h>
#include <mutex>

namespace limn
{

namespace
{

/// Those of the process, oldest first.
struct Devices
{
    std::mutex mutex;
    std::vector<const GraphicsDevice*> list;
};

Devices& AllDevices()
{
    static Devices devices;
    return devices;
}

/// By Vulkan 1.3, "Required Format Support"; of depth formats, which have one of two there, limn
/// draws on no device without its own.
bool isAlwaysTarget(GraphicsFormat format)
{
    switch (format)
    {
    case GraphicsFormat::None:
    case GraphicsFormat::R8G8B8A8_SNorm:
    case GraphicsFormat::R16_UNorm:
    case GraphicsFormat::R16G16_UNorm:
    case GraphicsFormat::R16G16B16A16_UNorm:
    case GraphicsFormat::B10G11R11_UFloatPack32:
        return false;
    default:
        return true;
    }
}

bool isAlwaysBlended(GraphicsFormat format)
{
    const bool isWide = format == GraphicsFormat::R32_SFloat ||
                        format == GraphicsFormat::R32G32_SFloat ||
                        format == GraphicsFormat::R32G32B32A32_SFloat;
    return isAlwaysTarget(format) && !isWide && !IsDepthFormat(format) &&
           ComponentType(format) == UniformType::Float;
}

bool isAlwaysSampled(GraphicsFormat format)
{
    return isAlwaysTarget(format) || format == GraphicsFormat::R8G8B8A8_SNorm ||
           format == GraphicsFormat::B10G11R11_UFloatPack32;
}

bool isAlwaysStored(GraphicsFormat format)
{
    switch (format)
    {
    case GraphicsFormat::R8G8B8A8_UNorm:
    case GraphicsFormat::R8G8B8A8_SNorm:
    case GraphicsFormat::R8G8B8A8_UInt:
    case GraphicsFormat::R16G16B16A16_UInt:
    case GraphicsFormat::R16G16B16A16_SFloat:
    case GraphicsFormat::R32_UInt:
    case GraphicsFormat::R32_SInt:
    case GraphicsFormat::R32_SFloat:
    case GraphicsFormat::R32G32_UInt:
    case GraphicsFormat::R32G32_SInt:
    case GraphicsFormat::R32G32_SFloat:
    case GraphicsFormat::R32G32B32A32_UInt:
    case GraphicsFormat::R32G32B32A32_SInt:
    case GraphicsFormat::R32G32B32A32_SFloat:
        return true;
    default:
        return false;
    }
}

} // namespace

GraphicsDevice::GraphicsDevice()
{
    Devices& devices = AllDevices();
    const std::lock_guard lock(devices.mutex);
    devices.list.push_back(this);
}

GraphicsDevice::~GraphicsDevice()
{
    Devices& devices = AllDevices();
    const std::lock_guard lock(devices.mutex);
    std::erase(devices.list, this);
}

bool EveryDeviceSupports(GraphicsFormat format, FormatUsage usage)
{
    switch (usage)
    {
    case FormatUsage::Sample:
    case FormatUsage::GetPixels:
    case FormatUsage::SetPixels:
    case FormatUsage::SetPixels32:
        return isAlwaysSampled(format);
    case FormatUsage::Linear:
        return isAlwaysBlended(format) || (isAlwaysSampled(format) && !isAlwaysTarget(format));
    case FormatUsage::Render:
    case FormatUsage::ReadPixels:
        return isAlwaysTarget(format);
    case FormatUsage::Blend:
        return isAlwaysBlended(format);
    case FormatUsage::LoadStore:
        return isAlwaysStored(format);
    case FormatUsage::MSAA2x: // one of four samples is asked for, not one of two
    case FormatUsage::MSAA8x:
        return false;
    case FormatUsage::MSAA4x:
        return isAlwaysTarget(format) &&
               (IsDepthFormat(format) || ComponentType(format) == UniformType::Float);
    case FormatUsage::Sparse:
    case FormatUsage::StencilSampling:
        break;
    }
    return false;
}

bool SystemInfo::IsFormatSupported(GraphicsFormat format, FormatUsage usage)
{
    Devices& devices = AllDevices();
    const std::lock_guard lock(devices.mutex);
    return devices.list.empty() ? EveryDeviceSupports(format, usage)
                                : devices.list.back()->IsFormatSupported(format, usage);
}

bool SystemInfo::SupportsRenderTextureFormat(RenderTextureFormat format)
{
    return IsFormatSupported(ToGraphicsFormat(format), FormatUsage::Render);
}

} // namespace limn

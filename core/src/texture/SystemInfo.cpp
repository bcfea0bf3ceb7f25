#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/core/GraphicsDevice.h>
#include <limn/core/QualitySettings.h>
#include <limn/core/SystemInfo.h>
#include <mutex>
#include <span>
#include <string_view>

namespace limn
{

namespace
{

/// The devices of the process, the oldest first.
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

/// Every Vulkan device supports these uses of these formats (Vulkan 1.3, "Required Format
/// Support"). For formats that are not listed, the device decides.
struct Promise
{
    /// s: sampled, l: with a linear filter, w: written by kernels, r: a target, b: blended
    std::string_view what;
    std::vector<GraphicsFormat> formats;
};

using enum GraphicsFormat;

/// Vulkan lets a device lack D32_SFloat or D32_SFloat_S8_UInt, but limn draws on none that does.
const std::vector<Promise>& Promises()
{
    static const std::vector<Promise> promises = {
        {"slrb",
         {R8_UNorm, R8G8_UNorm, R8G8B8A8_SRGB, B8G8R8A8_UNorm, B8G8R8A8_SRGB, R5G6B5_UNormPack16,
          A1R5G5B5_UNormPack16, A2B10G10R10_UNormPack32, R16_SFloat, R16G16_SFloat}},
        {"sl",
         {R8_SNorm, R8G8_SNorm, B4G4R4A4_UNormPack16, B10G11R11_UFloatPack32,
          E5B9G9R9_UFloatPack32}},
        {"sr",
         {R8_UInt, R8_SInt, R8G8_UInt, R8G8_SInt, A2B10G10R10_UIntPack32, R16_UInt, R16_SInt,
          R16G16_UInt, R16G16_SInt, D32_SFloat, D32_SFloat_S8_UInt}},
        {"slwrb", {R8G8B8A8_UNorm, R16G16B16A16_SFloat}},
        {"slw", {R8G8B8A8_SNorm}},
        {"swr",
         {R8G8B8A8_UInt, R8G8B8A8_SInt, R16G16B16A16_UInt, R16G16B16A16_SInt, R32_UInt, R32_SInt,
          R32_SFloat, R32G32_UInt, R32G32_SInt, R32G32_SFloat, R32G32B32A32_UInt, R32G32B32A32_SInt,
          R32G32B32A32_SFloat}},
    };
    return promises;
}

bool isPromised(GraphicsFormat format, char what)
{
    const auto has = [made = MadeFormat(format)](const Promise& promise)
    {
        return std::ranges::find(promise.formats, made) != promise.formats.end();
    };
    const auto promise = std::ranges::find_if(Promises(), has);
    return promise != Promises().end() && promise->what.find(what) != std::string_view::npos;
}

/// Wider formats of the same kind, best first, for who cannot have the one that is asked for.
std::span<const GraphicsFormat> Substitutes(GraphicsFormat format)
{
    static constexpr GraphicsFormat k_SRGB[] = {R8G8B8A8_SRGB, B8G8R8A8_SRGB};
    static constexpr GraphicsFormat k_Norm8[] = {R8G8B8A8_UNorm, B8G8R8A8_UNorm};
    static constexpr GraphicsFormat k_Float16[] = {R16G16B16A16_SFloat, R32G32B32A32_SFloat};
    static constexpr GraphicsFormat k_Float32[] = {R32G32B32A32_SFloat};
    static constexpr GraphicsFormat k_UInt32[] = {R32G32B32A32_UInt};
    static constexpr GraphicsFormat k_SInt32[] = {R32G32B32A32_SInt};
    const std::string_view name = ToString(format);
    const auto has = [&](const char* part)
    {
        return name.find(part) != std::string_view::npos;
    };
    if (format == None || IsDepthFormat(format))
    {
        return {};
    }
    if (has("SRGB"))
    {
        return k_SRGB;
    }
    if (has("_UInt"))
    {
        return k_UInt32;
    }
    if (has("_SInt"))
    {
        return k_SInt32;
    }
    const bool isWideNorm = has("16_UNorm") || has("16_SNorm") || has("R32"); // a half has 11 bits
    const bool isFloat = has("Float") || has("10_") || has("SNorm");
    return isWideNorm ? std::span<const GraphicsFormat>(k_Float32)
           : isFloat  ? std::span<const GraphicsFormat>(k_Float16)
                      : std::span<const GraphicsFormat>(k_Norm8);
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
        return isPromised(format, 's');
    case FormatUsage::Linear:
        return isPromised(format, 'l');
    case FormatUsage::Render:
    case FormatUsage::ReadPixels:
        return isPromised(format, 'r');
    case FormatUsage::Blend:
        return isPromised(format, 'b');
    case FormatUsage::LoadStore:
        return isPromised(format, 'w');
    case FormatUsage::MSAA2x: // one of four samples is asked for, not one of two
    case FormatUsage::MSAA8x:
        return false;
    case FormatUsage::MSAA4x:
        return isPromised(format, 'r') &&
               (IsDepthFormat(format) || ComponentType(format) == UniformType::Float);
    case FormatUsage::Sparse:
    case FormatUsage::StencilSampling:
        break;
    }
    return false;
}

bool SystemInfo::IsFormatSupported(GraphicsFormat format, FormatUsage usage)
{
    const GraphicsFormat made = MadeFormat(format);
    if (made == GraphicsFormat::None || !GraphicsFormatProblem(made).empty())
    {
        return false;
    }
    Devices& devices = AllDevices();
    const std::lock_guard lock(devices.mutex);
    return devices.list.empty() ? EveryDeviceSupports(made, usage)
                                : devices.list.back()->IsFormatSupported(made, usage);
}

bool SystemInfo::IsFormatSupported(GraphicsFormat format, GraphicsFormatUsage usage)
{
    for (int bit = 0; bit <= static_cast<int>(FormatUsage::StencilSampling); ++bit)
    {
        const bool isAsked = (static_cast<int>(usage) & (1 << bit)) != 0;
        if (isAsked && !IsFormatSupported(format, static_cast<FormatUsage>(bit)))
        {
            return false;
        }
    }
    return format != GraphicsFormat::None;
}

GraphicsFormat SystemInfo::GetCompatibleFormat(GraphicsFormat format, GraphicsFormatUsage usage)
{
    if (IsFormatSupported(format, usage))
    {
        return format;
    }
    const auto substitutes = Substitutes(format);
    const auto found = std::ranges::find_if(substitutes, [usage](GraphicsFormat other)
                                            { return IsFormatSupported(other, usage); });
    return found == substitutes.end() ? GraphicsFormat::None : *found;
}

GraphicsFormat SystemInfo::GetCompatibleFormat(GraphicsFormat format, FormatUsage usage)
{
    return GetCompatibleFormat(format,
                               static_cast<GraphicsFormatUsage>(1 << static_cast<int>(usage)));
}

GraphicsFormat SystemInfo::GetGraphicsFormat(DefaultFormat format)
{
    switch (format)
    {
    case DefaultFormat::LDR:
        return QualitySettings::activeColorSpace() == ColorSpace::Linear
                   ? GraphicsFormat::R8G8B8A8_SRGB
                   : GraphicsFormat::R8G8B8A8_UNorm;
    case DefaultFormat::HDR:
        return GraphicsFormat::R16G16B16A16_SFloat;
    case DefaultFormat::DepthStencil:
        return GraphicsFormat::D32_SFloat_S8_UInt;
    case DefaultFormat::Shadow:
        return GraphicsFormat::D32_SFloat;
    case DefaultFormat::Video:
        break;
    }
    throw ContractError("SystemInfo::GetGraphicsFormat: there is no video; LDR would do");
}

} // namespace limn

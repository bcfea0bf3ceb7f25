#include "explain/pixel/PixelHistory.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <glm/gtc/packing.hpp>
#include <limn/core/Color.h>
#include <string_view>

namespace limn
{

namespace
{

/// A component of a format, by the format's name.
struct Component
{
    char letter = 'R';
    int bits = 0;
    int offset = 0; ///< bits behind the texel's lowest one
};

/// "B8G8R8A8_UNorm" has B at bit 0; of "R5G6B5_UNormPack16" R, named first, has the highest bits.
std::vector<Component> ComponentsOf(std::string_view name)
{
    std::vector<Component> components;
    int all = 0;
    for (std::size_t i = 0; i < name.size() && name[i] != '_';)
    {
        Component component{name[i++], 0, all};
        for (; i < name.size() && std::isdigit(static_cast<unsigned char>(name[i])) != 0; ++i)
        {
            component.bits = component.bits * 10 + (name[i] - '0');
        }
        all += component.bits;
        components.push_back(component);
    }
    if (name.find("Pack") != std::string_view::npos)
    {
        for (Component& component : components)
        {
            component.offset = all - component.offset - component.bits;
        }
    }
    return components;
}

std::uint32_t BitsOf(std::span<const std::byte> texel, const Component& component)
{
    std::uint32_t bits = 0;
    for (int i = 0; i < component.bits; ++i)
    {
        const int bit = component.offset + i;
        const auto byte = std::to_integer<std::uint32_t>(texel[static_cast<std::size_t>(bit / 8)]);
        bits |= ((byte >> (bit % 8)) & 1u) << i;
    }
    return bits;
}

/// @param bits   of the component, the lowest ones
/// @param count  how many
float FloatOf(std::uint32_t bits, int count)
{
    // Floats of 10 and 11 bits are halves without a sign and with a shorter mantissa.
    return count == 32 ? std::bit_cast<float>(bits)
                       : glm::unpackHalf1x16(
                             static_cast<std::uint16_t>(count < 16 ? bits << (15 - count) : bits));
}

float ValueOf(std::uint32_t bits, const Component& component, std::string_view type)
{
    const auto all = static_cast<float>((std::uint64_t{1} << component.bits) - 1);
    const int unused = 32 - component.bits;
    const auto number = static_cast<float>(static_cast<std::int32_t>(bits << unused) >> unused);
    if (type.starts_with("SFloat") || type.starts_with("UFloat"))
    {
        return FloatOf(bits, component.bits);
    }
    if (type.starts_with("SInt"))
    {
        return number;
    }
    if (type.starts_with("SNorm"))
    {
        return std::max(number / std::floor(all / 2.0f), -1.0f);
    }
    const float share = static_cast<float>(bits) / (type.starts_with("UInt") ? 1.0f : all);
    const bool isCurved = type.starts_with("SRGB") && component.letter != 'A';
    return isCurved ? Color(share, share, share).linear().r : share;
}

/// Returns three numbers that have an exponent in common.
std::vector<float> SharedExponent(std::span<const std::byte> texel,
                                  const std::vector<Component>& components)
{
    const int exponent = static_cast<int>(BitsOf(texel, components[0])) - 15 - 9;
    const auto value = [&](std::size_t i)
    {
        return std::ldexp(static_cast<float>(BitsOf(texel, components[i])), exponent);
    };
    return {value(3), value(2), value(1)}; // E B G R
}

} // namespace

std::vector<float> TexelValue(std::span<const std::byte> texel, GraphicsFormat format)
{
    const std::string_view name = ToString(format);
    const std::string_view type = name.substr(name.find('_') + 1);
    const std::vector<Component> components = ComponentsOf(name);
    if (format == GraphicsFormat::E5B9G9R9_UFloatPack32)
    {
        return SharedExponent(texel, components);
    }
    std::vector<float> value;
    for (const char letter : std::string_view("RGBAD"))
    {
        const auto found = std::ranges::find(components, letter, &Component::letter);
        if (found != components.end())
        {
            value.push_back(ValueOf(BitsOf(texel, *found), *found, type));
        }
    }
    return value;
}

std::vector<std::byte> TexelAt(const Image& image, int x, int y)
{
    const auto size = static_cast<std::size_t>(BytesPerTexel(image.format));
    const auto place = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x);
    const auto begin = image.texels.begin() + static_cast<std::ptrdiff_t>(place * size);
    return {begin, begin + static_cast<std::ptrdiff_t>(size)};
}

} // namespace limn

#pragma once

#include <cstdint>
#include <limn/base/Diagnostic.h>
#include <string>

namespace limn
{

namespace detail
{

/// A set of 32 named bits. `Tag` keeps layer masks and rendering-layer masks apart: mixing them up
/// does not compile, nor does passing a plain number.
template <typename Tag>
struct BitMask32
{
    std::uint32_t bits = 0;

    constexpr BitMask32() = default;
    constexpr explicit BitMask32(std::uint32_t value) : bits(value) {}

    /// Returns the mask with only bit `index` set.
    /// @throws ContractError outside 0...31 (C# would wrap 32 to bit 0 without a word)
    static constexpr BitMask32 FromIndex(int index)
    {
        if (index < 0 || index > 31)
        {
            throw ContractError(std::string(Tag::k_Name) + " index " + std::to_string(index) +
                                " is outside 0...31");
        }
        return BitMask32(std::uint32_t{1} << index);
    }
    static constexpr BitMask32 Everything() { return BitMask32(0xFFFFFFFFu); }
    static constexpr BitMask32 Nothing() { return BitMask32(0u); }

    constexpr bool Intersects(BitMask32 other) const { return (bits & other.bits) != 0; }

    friend constexpr BitMask32 operator|(BitMask32 a, BitMask32 b)
    {
        return BitMask32(a.bits | b.bits);
    }
    friend constexpr BitMask32 operator&(BitMask32 a, BitMask32 b)
    {
        return BitMask32(a.bits & b.bits);
    }
    friend constexpr BitMask32 operator~(BitMask32 a) { return BitMask32(~a.bits); }
    constexpr bool operator==(const BitMask32&) const = default;
};

struct LayerTag
{
    static constexpr const char* k_Name = "layer";
};
struct RenderingLayerTag
{
    static constexpr const char* k_Name = "rendering layer";
};

} // namespace detail

/// A set of layers; an object is in exactly one layer, 0...31. Unity: UnityEngine.LayerMask.
using LayerMask = detail::BitMask32<detail::LayerTag>;

/// A set of rendering layers. A renderer may be in any number of them; a new one is in layer 0.
/// Unity: UnityEngine.RenderingLayerMask (6000), the uint renderingLayerMask of 2022.3.
using RenderingLayerMask = detail::BitMask32<detail::RenderingLayerTag>;

} // namespace limn

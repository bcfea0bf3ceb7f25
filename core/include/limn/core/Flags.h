#pragma once

namespace limn
{

/// True for an enum whose values are bits. C# has the operators below for every enum.
template <typename Enum>
inline constexpr bool k_IsFlags = false;

template <typename Enum>
requires k_IsFlags<Enum>
constexpr Enum operator|(Enum a, Enum b)
{
    return static_cast<Enum>(static_cast<int>(a) | static_cast<int>(b));
}
template <typename Enum>
requires k_IsFlags<Enum>
constexpr Enum& operator|=(Enum& a, Enum b)
{
    return a = a | b;
}
/// Returns whether the two have a bit in common.
template <typename Enum>
requires k_IsFlags<Enum>
constexpr bool operator&(Enum a, Enum b)
{
    return (static_cast<int>(a) & static_cast<int>(b)) != 0;
}

} // namespace limn

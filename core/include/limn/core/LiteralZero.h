#pragma once

#include <concepts>

namespace limn
{

/// The number 0 as it stands in the source, which C# makes a member of any enum by itself: for
/// parameters and members that such a line is to compile with.
struct LiteralZero
{
    /// Does not compile for another number.
    consteval LiteralZero(int zero)
    {
        if (zero != 0)
        {
            throw "of all numbers 0 alone becomes a member of an enum by itself";
        }
    }
};

/// A member of an enum that 0 may be assigned to. Unity: any enum.
template <typename Enum>
class ZeroOr
{
public:
    constexpr ZeroOr(Enum value = {}) : m_Value(value) {}
    template <std::same_as<int> Number>
    consteval ZeroOr(Number zero)
    {
        static_cast<void>(LiteralZero(zero));
    }

    constexpr operator Enum() const { return m_Value; }

private:
    Enum m_Value{};
};

} // namespace limn

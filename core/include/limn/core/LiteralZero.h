#pragma once

#include <concepts>

namespace limn
{

/// The literal 0, which C# converts to any enum implicitly. Parameters and members have this type
/// so that such lines compile.
struct LiteralZero
{
    /// Does not compile for any other number.
    consteval LiteralZero(int zero)
    {
        if (zero != 0)
        {
            throw "of all numbers 0 alone becomes a member of an enum by itself";
        }
    }
};

/// An enum value to which 0 may be assigned. Unity: any enum.
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

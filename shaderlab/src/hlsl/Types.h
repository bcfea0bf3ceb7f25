#pragma once

#include "tokens/Tokens.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace limn
{

enum class HlslScalar : std::uint8_t
{
    None,
    Bool,
    Int,
    Uint,
    Literal, ///< 1.5, which takes the type of the other operand
    Half,    ///< min16float as well
    Float,
    Double,
};

/// The type of an expression or a declared name, as far as it is known. Code whose type is Unknown
/// is not changed.
struct HlslType
{
    enum class Kind : std::uint8_t
    {
        Unknown,
        Void,
        Number, ///< scalar, vector or matrix
        Struct,
        Object, ///< texture, sampler, buffer, stream
    };

    Kind kind = Kind::Unknown;
    HlslScalar scalar = HlslScalar::None;
    std::uint8_t rows = 0; ///< the rows of a matrix, otherwise 0
    /// The columns of a matrix, or the length of a vector; 1 without rows: a scalar.
    std::uint8_t columns = 1;
    std::uint8_t dimensions = 0; ///< the dimensions of an array
    std::string_view name;       ///< the name of a struct or object
    std::string_view element;    ///< an object's template argument

    static HlslType Number(HlslScalar scalar, int columns = 1, int rows = 0);

    bool isNumber() const { return kind == Kind::Number && dimensions == 0; }
    bool isScalar() const { return isNumber() && rows == 0 && columns == 1; }
    bool isVector() const { return isNumber() && rows == 0 && columns > 1; }
    bool isMatrix() const { return isNumber() && rows > 0; }
    bool isFloating() const { return isNumber() && scalar >= HlslScalar::Literal; }
    int components() const { return columns * (rows > 0 ? rows : 1); }
    /// Returns the type with other numbers of components, for example that of a matrix's row.
    HlslType As(int newColumns, int newRows = 0) const
    {
        return Number(scalar, newColumns, newRows);
    }
    HlslType Of(HlslScalar newScalar) const { return Number(newScalar, columns, rows); }
    HlslType Innermost() const; ///< the type of an array's innermost elements
    /// Returns "float3x3"; `half` is written as float. The type must be a number.
    std::string Spelling() const;

    bool operator==(const HlslType&) const = default;
};

/// Returns the type of words such as float, half3, int2x2, min16float, dword, matrix, vector;
/// nullopt for other words.
std::optional<HlslType> NumberType(std::string_view word);

/// Returns whether glslang takes the words for the same type; half is float.
bool isSameType(std::string_view a, std::string_view b);

/// Returns whether the word names textures, samplers or buffers, also those of Direct3D 9.
bool isObjectType(std::string_view word);
bool isTypeModifier(std::string_view word);

/// Returns the common type of both operands of an arithmetic operator: the size of the shorter one
/// (a scalar fits every size) and the wider kind of number.
HlslType Promote(const HlslType& left, const HlslType& right);

/// Returns the result type of a function of the language; Unknown if there is no such function.
HlslType IntrinsicType(std::string_view name, std::span<const HlslType> arguments);

/// Returns whether the language has a function of the name.
bool isIntrinsic(std::string_view name);

/// Returns whether a function of the language takes matrices and treats each element by itself.
bool isComponentwise(std::string_view intrinsic);

/// Returns the result type of a method of a texture or buffer.
HlslType MethodType(const HlslType& object, std::string_view method);

/// Returns the type of `.xyz`, `._m00_m11` and the like; Unknown if the word selects nothing of the
/// type.
HlslType SwizzleType(const HlslType& type, std::string_view letters);

} // namespace limn

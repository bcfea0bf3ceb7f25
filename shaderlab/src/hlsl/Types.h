#pragma once

#include "tokens/Tokens.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace limn
{

struct HlslStruct;

enum class HlslScalar : std::uint8_t
{
    None,
    Bool,
    Int,
    Uint,
    Literal, ///< 1.5, which becomes what it meets
    Half,    ///< min16float as well
    Float,
    Double,
};

/// What is known of the type of an expression or a declared name. Unknown is a value of its own:
/// nothing is done to what has it.
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
    std::uint8_t rows = 0;    ///< of a matrix, else 0
    std::uint8_t columns = 1; ///< of a matrix, or how long the vector is; 1 without rows: a scalar
    std::uint8_t dimensions = 0; ///< of an array
    std::string_view name;       ///< of a struct or object
    std::string_view element;    ///< an object's template argument

    static HlslType Number(HlslScalar scalar, int columns = 1, int rows = 0);

    bool isNumber() const { return kind == Kind::Number && dimensions == 0; }
    bool isScalar() const { return isNumber() && rows == 0 && columns == 1; }
    bool isVector() const { return isNumber() && rows == 0 && columns > 1; }
    bool isMatrix() const { return isNumber() && rows > 0; }
    bool isFloating() const { return isNumber() && scalar >= HlslScalar::Literal; }
    int components() const { return columns * (rows > 0 ? rows : 1); }
    /// The same with other components; of a matrix's row, say.
    HlslType As(int newColumns, int newRows = 0) const;
    HlslType Of(HlslScalar newScalar) const;
    HlslType Innermost() const; ///< of what is no array in an array
    /// "float3x3"; `half` is float. Of numbers only.
    std::string Spelling() const;

    bool operator==(const HlslType&) const = default;
};

/// float, half3, int2x2, min16float, dword, matrix, vector …; nothing of other words.
std::optional<HlslType> NumberType(std::string_view word);

/// Whether glslang takes the words for one type: half is float.
bool isSameType(std::string_view a, std::string_view b);

/// Whether the word names textures, samplers or buffers, of Direct3D 9 as well.
bool isObjectType(std::string_view word);
bool isTypeModifier(std::string_view word);

/// The type that both operands of an arithmetic operator have: the shorter one's size, one number
/// counts for all; the wider kind of number.
HlslType Promote(const HlslType& left, const HlslType& right);

/// What a function of the language gives; unknown where it is none.
HlslType IntrinsicType(std::string_view name, std::span<const HlslType> arguments);

/// Whether the language has a function of the name.
bool isIntrinsic(std::string_view name);

/// Whether a function of the language takes matrices, each element by itself.
bool isComponentwise(std::string_view intrinsic);

/// What a method of a texture or buffer gives.
HlslType MethodType(const HlslType& object, std::string_view method);

/// `.xyz`, `._m00_m11`; unknown where the word picks nothing of the type.
HlslType SwizzleType(const HlslType& type, std::string_view letters);

} // namespace limn

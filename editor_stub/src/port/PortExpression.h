#pragma once

#include "port/PortModel.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// A value in C++, or a type.
struct PortValue
{
    std::string cpp;
    std::string type;        ///< the C# type; "" = not known
    bool isLiteral = false;  ///< true for a number
    bool isVariable = false; ///< true if it has an address
    bool isPointer = false;  ///< true if it points to an object of the type
    bool isType = false;     ///< true for a type by its name
    bool isLocal = false;    ///< true for an object that ends with the method
    int strength = 100;      ///< how tightly its operator binds; an expression without one has 100

    /// A field that points to an object may have one of its own: this is that one's field, or "".
    std::string own = {};

    /// Returns it in brackets, if an operator of this strength would otherwise tear it apart.
    std::string Text(int least) const { return strength < least ? "(" + cpp + ")" : cpp; }
    /// Returns the object itself, also where the value points to it.
    std::string Object() const { return isPointer ? "*" + Text(90) : cpp; }
};

/// The names that an expression can use, and their values.
using PortScope = std::map<std::string, PortValue>;

/// The place of an expression, from which its names are looked up.
struct PortPlace
{
    const PortModel& model;
    const PortScope& scope;
    bool isBody = false; ///< true in the body of a method, which may call what it likes
};

/// Returns an expression in C++, of the wanted type ("" = any), or nothing if a part of it is not
/// known to mean the same. Outside of bodies it translates defaults, arguments and conditions of a
/// few words.
/// @param problem  why there is nothing, if it is not null and that can be said
std::optional<PortValue> Translate(const PortPlace& place, CSharpWords words,
                                   const std::string& wanted, std::string* problem = nullptr);
inline std::optional<PortValue> Translate(const PortModel& model, const PortScope& scope,
                                          CSharpWords words, const std::string& wanted)
{
    return Translate(PortPlace{model, scope}, words, wanted);
}

/// Returns the assignment in C++ without its semicolon, or nothing like Translate.
/// @param word  the operator: "=" or "+="
std::optional<std::string> TranslateAssignment(const PortPlace& place, CSharpWords target,
                                               std::string_view word, CSharpWords value,
                                               std::string& problem);

/// Returns the same for a variable that is already C++.
std::optional<std::string> AssignmentTo(const PortPlace& place, const PortValue& target,
                                        std::string_view word, CSharpWords assigned,
                                        std::string& problem);

/// Returns `object.member = value` in C++ without its semicolon, or nothing like Translate.
/// @param words  member = value
std::optional<std::string> MemberAssignment(const PortPlace& place, const PortValue& object,
                                            CSharpWords words, std::string& problem);

/// Returns an object whose members are set, as a call of a function that makes it, or nothing like
/// Translate.
/// @param members  a = b, c = d
std::optional<PortValue> MadeWith(const PortPlace& place, const PortValue& made,
                                  CSharpWords members, std::string& problem);

/// Returns the value as one of the wanted type ("" = any), or nothing if it cannot be one.
std::optional<PortValue> Converted(const PortModel& model, PortValue value,
                                   const std::string& wanted);

/// Returns a number or an enum as one of another such type, as a cast of C# makes it, or nothing if
/// the types are others.
std::optional<PortValue> CastNumber(const PortModel& model, const PortValue& value,
                                    const std::string& type);

/// Returns the number of each member of an enum, in their order. From the first member on whose
/// value is not made of numbers and members of the enum, there is no number.
std::vector<std::optional<std::int64_t>> EnumValues(const CSharpClass& one);

} // namespace limn

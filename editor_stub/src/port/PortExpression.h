#pragma once

#include "port/PortModel.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// A value in C++.
struct PortValue
{
    std::string cpp;
    std::string type;        ///< the C# type
    bool isLiteral = false;  ///< true for a number
    bool isVariable = false; ///< true if it has an address
    bool isPointer = false;  ///< true if it points to an object of the type
};

/// The names that an expression can use, and their values.
using PortScope = std::map<std::string, PortValue>;

/// Returns an expression in C++, of the wanted type ("" = any), or nothing if a part of it is not
/// known to mean the same. It translates defaults, arguments and conditions of a few words.
std::optional<PortValue> Translate(const PortModel& model, const PortScope& scope,
                                   CSharpWords words, const std::string& wanted);

/// Returns the number that an attribute's argument is, or nothing if it is none.
std::optional<std::string> TranslateNumber(const PortModel& model, CSharpWords words);

/// Returns the number of each member of an enum, in their order. From the first member on whose
/// value is not made of numbers and members of the enum, there is no number.
std::vector<std::optional<std::int64_t>> EnumValues(const CSharpClass& one);

/// Returns the text of a plain string, or of several with + between them, or nothing for other
/// words.
std::optional<std::string> PlainText(CSharpWords words);

/// Returns the arguments of `new T(...)` or `new(...)`, whatever follows, or nothing for other
/// words.
std::optional<std::vector<CSharpWords>> NewArguments(CSharpWords words);

} // namespace limn

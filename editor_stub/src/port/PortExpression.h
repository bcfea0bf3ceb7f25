#pragma once

#include "port/PortModel.h"
#include "port/csharp/CSharpFile.h"

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
    std::string type;        ///< of C#
    bool isLiteral = false;  ///< a number
    bool isVariable = false; ///< has an address
    bool isPointer = false;  ///< to what the type says
};

/// The names that stand for something where an expression stands.
using PortScope = std::map<std::string, PortValue>;

/// The expression in C++, of the type that is wanted ("" = any); nothing where a part of it is not
/// known to mean the same: defaults, arguments and conditions of a few words.
std::optional<PortValue> Translate(const PortModel& model, const PortScope& scope,
                                   CSharpWords words, const std::string& wanted);

/// The number of an attribute's argument; nothing for anything else.
std::optional<std::string> TranslateNumber(const PortModel& model, CSharpWords words);

/// The number of each member of an enum, in their order; nothing from the first one on whose value
/// is not made of numbers and members of the enum.
std::vector<std::optional<std::int64_t>> EnumValues(const CSharpClass& one);

/// The text of a plain string word, or of such ones with + between them; nothing for any other.
std::optional<std::string> PlainText(CSharpWords words);

/// The arguments of `new T(...)` or `new(...)`, whatever stands behind it; nothing for others.
std::optional<std::vector<CSharpWords>> NewArguments(CSharpWords words);

} // namespace limn

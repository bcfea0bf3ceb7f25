#pragma once

#include "port/PortModel.h"

#include <map>
#include <optional>
#include <string>

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

} // namespace limn

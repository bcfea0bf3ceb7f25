#pragma once

#include "port/PortExpression.h"

#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// Returns a number of C# in C++, or nothing for a kind that C++ lacks.
std::optional<PortValue> NumberValue(std::string text);

/// Returns Vector2.one and the like, or nothing for other members.
std::optional<PortValue> VectorValue(const std::string& type, const std::string& member);

/// Returns the number that an attribute's argument is, or nothing if it is none.
std::optional<std::string> TranslateNumber(const PortModel& model, CSharpWords words);

/// Returns the text of a plain string, or of several with + between them, or nothing for other
/// words.
std::optional<std::string> PlainText(CSharpWords words);

/// Returns a text with values in it, $"a {b} c", or nothing if one of them has no text in C++.
/// @param problem  as in Translate
std::optional<PortValue> TextWithValues(const PortPlace& place, const CSharpToken& word,
                                        std::string& problem);

/// Returns the arguments of `new T(...)` or `new(...)`, whatever follows, or nothing for other
/// words.
std::optional<std::vector<CSharpWords>> NewArguments(CSharpWords words);

} // namespace limn

#pragma once

#include "port/PortExpression.h"

#include <optional>
#include <string>
#include <string_view>

namespace limn
{

/// Returns whether the type is int, uint or float.
bool IsNumber(const std::string& type);

/// Returns how tightly an operator of two values binds; 0 if it is not known.
int Strength(std::string_view word);

/// Returns whether C++ takes the value as a condition.
bool IsTruth(const PortModel& model, const PortValue& value);

/// Returns `left word right` in C++, or nothing if it is not known to mean the same.
/// @param problem  becomes the reason of nothing
std::optional<PortValue> Combined(const PortModel& model, PortValue left, const std::string& word,
                                  PortValue right, std::string& problem);

/// Returns `value ?? other` in C++, or nothing if the value is no pointer there.
std::optional<PortValue> Otherwise(const PortModel& model, PortValue value, const PortValue& other);

/// Returns `value?.member` in C++, or nothing if the member is no pointer there.
/// @param member  value.member
std::optional<PortValue> Maybe(const PortModel& model, const PortValue& value, PortValue member);

} // namespace limn

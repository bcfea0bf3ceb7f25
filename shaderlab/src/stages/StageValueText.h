#pragma once

#include "stages/StageLinkage.h"

#include <string>

namespace limn
{

// The HLSL spelling of the inputs and outputs of generated entry functions.

/// Returns the type that the pipeline gives a system value, whatever type the author declares.
std::string SystemType(const StageValue& value);

/// Returns the semantic of a system value, with its index if indices count: "SV_TARGET1".
std::string SystemSemantic(const StageValue& value);

/// Returns the number of components of a type: 3 for "float3".
int ComponentsOf(const std::string& type);

/// Returns `source`, which has `components`, as another vector type: truncated, or filled up with
/// zeros.
std::string ConvertText(const std::string& source, int components, const std::string& scalar,
                        int wanted);

/// Returns attribute, type, name and semantic of a varying; both sides of a border declare it with
/// this text.
///
/// @param modifiers  the modifiers between attribute and type, "" or with a blank at the end
std::string VaryingText(const Varying& varying, const std::string& name,
                        const std::string& modifiers);

} // namespace limn

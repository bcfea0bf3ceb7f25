#pragma once

#include "stages/StageLinkage.h"

#include <string>

namespace limn
{

// HLSL spelling of what generated entry functions take and give.

/// The type the pipeline gives a system value, whatever type the author declares.
std::string SystemType(const StageValue& value);

/// "SV_TARGET1": where indices count.
std::string SystemSemantic(const StageValue& value);

/// 3 for "float3".
int ComponentsOf(const std::string& type);

/// `source`, of `components`, as another vector type: cut off, or filled up with zeros.
std::string ConvertText(const std::string& source, int components, const std::string& scalar,
                        int wanted);

/// Attribute, type, name and semantic; both sides of a border declare a varying by this.
///
/// @param modifiers  between attribute and type, "" or with a blank at the end
std::string VaryingText(const Varying& varying, const std::string& name,
                        const std::string& modifiers);

} // namespace limn

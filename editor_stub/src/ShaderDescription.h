#pragma once

#include "ShaderCheck.h"

#include <string>

namespace limn
{

/// A shader for people, several lines: properties, passes, states, keywords, layouts. "" for a file
/// that cannot be parsed.
std::string DescribeShader(const ShaderCheck& check);

/// The same, and the errors, of all files as a JSON array.
std::string ShadersAsJson(const std::vector<ShaderCheck>& checks);

// Names as both forms have them.
std::string TypeText(const ShaderProperty& property); ///< "Range(0, 1)"
std::string DefaultText(const ShaderProperty& property);
std::string TypeText(UniformType type, int components, int arraySize = 0); ///< "float4[8]"
std::string StagesText(ShaderStage stages);      ///< "vertex and fragment"
std::string KeywordsText(const KeywordSet& set); ///< "multi_compile: (none) A B"

} // namespace limn

#pragma once

#include "shaders/ShaderCheck.h"

#include <string>

namespace limn
{

/// A shader for people, several lines: properties, passes, states, keywords, layouts. "" for a file
/// that cannot be parsed.
std::string DescribeShader(const ShaderCheck& check);

/// How many variants each pass of each file has, and all together, a line each.
std::string DescribeVariants(const std::vector<ShaderCheck>& checks);

/// All files and their summary as JSON: {files: [...], summary: {...}}.
std::string ShadersAsJson(const std::vector<ShaderCheck>& checks);

// Names as both forms have them.
std::string TypeText(const ShaderProperty& property); ///< "Range(0, 1)"
std::string DefaultText(const ShaderProperty& property);
std::string TypeText(UniformType type, int components, int arraySize = 0); ///< "float4[8]"
std::string StagesText(ShaderStage stages);      ///< "vertex and fragment"
std::string KeywordsText(const KeywordSet& set); ///< "multi_compile: (none) A B"
/// A pass's fixed state as ShaderLab would have it, on one line: "Cull Back, ZTest LEqual, ...".
/// Depth test and write and culling always, the rest where it is not the default.
std::string StateText(const RenderState& state);
const char* ToString(PassOutcome outcome); ///< "compiled", "missing include"

} // namespace limn

#pragma once

#include "shaders/ShaderCheck.h"

#include <array>
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

/// What many files came to.
struct ShaderSummary
{
    int files = 0;
    int parsed = 0; ///< without an error
    int errors = 0;
    std::array<int, 5> passes{}; ///< by PassOutcome

    int passesOf(PassOutcome outcome) const { return passes[static_cast<std::size_t>(outcome)]; }
    /// Vertex and fragment programs of which everything they include is there.
    int passesTried() const
    {
        return passesOf(PassOutcome::Compiled) + passesOf(PassOutcome::Failed);
    }
};

ShaderSummary Summarize(const std::vector<ShaderCheck>& checks);

/// "2 files: 1 parsed (50.0 %), 1 with 3 errors; 4 of 5 passes compiled (80.0 %), 1 failed, 2
/// refused, 1 with a missing include"; what is 0 is left out.
std::string ToString(const ShaderSummary& summary);

} // namespace limn

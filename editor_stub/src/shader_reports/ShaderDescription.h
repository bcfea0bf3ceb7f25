#pragma once

#include "shader_reports/ShaderCheck.h"

#include <array>
#include <string>

namespace limn
{

/// Returns the description of a shader for people, in several lines: properties, passes, states,
/// keywords, layouts. Returns "" for a file that cannot be parsed.
std::string DescribeShader(const ShaderCheck& check);

/// Returns the number of variants of each pass of each file, and of all together, a line each.
std::string DescribeVariants(const std::vector<ShaderCheck>& checks);

/// Returns all files and their summary as JSON: {files: [...], summary: {...}}.
std::string ShadersAsJson(const std::vector<ShaderCheck>& checks);

// Names, as the text and the JSON have them.
std::string TypeText(const ShaderProperty& property); ///< "Range(0, 1)"
std::string DefaultText(const ShaderProperty& property);
std::string TypeText(UniformType type, int components, int arraySize = 0); ///< "float4[8]"
std::string StagesText(ShaderStage stages);      ///< "vertex and fragment"
std::string KeywordsText(const KeywordSet& set); ///< "multi_compile: (none) A B"
/// Returns a pass's fixed state in the words of ShaderLab, on one line: "Cull Back, ZTest LEqual,
/// ...". Depth test, depth write and culling are always there, the rest only if it is not the
/// default.
std::string StateText(const RenderState& state);
const char* ToString(PassOutcome outcome); ///< "compiled", "missing include"

/// The sums over many files.
struct ShaderSummary
{
    int files = 0;
    int parsed = 0; ///< the files that were parsed without an error
    int errors = 0;
    std::array<int, 5> passes{}; ///< the number of passes by PassOutcome

    int passesOf(PassOutcome outcome) const { return passes[static_cast<std::size_t>(outcome)]; }
    /// Returns the number of vertex and fragment programs whose includes are all there.
    int passesTried() const
    {
        return passesOf(PassOutcome::Compiled) + passesOf(PassOutcome::Failed);
    }
};

ShaderSummary Summarize(const std::vector<ShaderCheck>& checks);

/// Returns the summary as text: "2 files: 1 parsed (50.0 %), 1 with 3 errors; 4 of 5 passes
/// compiled (80.0 %), 1 failed, 2 refused, 1 with a missing include". Counts of 0 are left out.
std::string ToString(const ShaderSummary& summary);

} // namespace limn

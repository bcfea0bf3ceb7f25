#pragma once

#include <filesystem>
#include <functional>
#include <limn/shaderlab/ShaderCompiler.h>
#include <limn/shaderlab/ShaderDatabase.h>
#include <limn/shaderlab/ShaderLabDocument.h>
#include <limn/shaderlab/VariantCount.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// The result of checking a pass.
enum class PassOutcome
{
    NotTried,       ///< it has no program, or nothing had to be compiled
    Compiled,       ///< it compiled with the wanted keywords
    Refused,        ///< it is well formed, but needs something that limn does not do
    MissingInclude, ///< it includes a file that is not there
    Failed
};

/// A pass of a shader with what compiling it gave.
struct CheckedPass
{
    std::shared_ptr<const ShaderLabPass> pass;
    PassOutcome outcome = PassOutcome::NotTried;
    std::string reason; ///< the reason of a refusal, one sentence
    std::shared_ptr<const ShaderProgram> compiled;
    std::vector<std::string> keywords; ///< the keywords that it was compiled with
    VariantCount variants;             ///< 0 without a program
    /// The property that keeps the SRP Batcher from taking the pass; "" if none does.
    std::string srpBatcherProblem;
    /// The pass that a UsePass leads to, in the SubShader that limn draws with, compiled with the
    /// keywords of the shader that uses it. Null for any other pass, and if it leads nowhere. The
    /// UsePass itself stays NotTried: its pass counts in the file that has it.
    std::shared_ptr<const CheckedPass> use;
};

struct CheckedSubShader
{
    const ShaderLabSubShader* subShader = nullptr;
    bool isUsed = false; ///< true if limn draws with it
    std::vector<CheckedPass> passes;
};

/// All that was found out about one ShaderLab file.
struct ShaderCheck
{
    std::filesystem::path file;
    bool isParsed = false;                             ///< true if it was parsed without an error
    std::shared_ptr<const ShaderLabDocument> document; ///< null if there is no text to read
    std::vector<CheckedSubShader> subShaders;
    std::string drawnFallback;           ///< the shader that limn draws with instead; "" = this one
    std::vector<Diagnostic> diagnostics; ///< errors, warnings and notes; refusals are notes
};

struct ShaderCheckOptions
{
    bool compile = true;
    /// The keywords that are on. If they are not given, the keywords of a new material are on.
    std::optional<std::vector<std::string>> keywords;
    /// Returns the shaders among which UsePass and Fallback look. It is called only for files that
    /// have one of the two, on any thread.
    std::function<const ShaderDatabase&()> shaders;
};

/// Parses the file and compiles the passes of its SubShaders. May be called on any thread.
ShaderCheck CheckShader(const std::filesystem::path& file, const ShaderCheckOptions& options,
                        ShaderCompiler& compiler);

} // namespace limn

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

/// What became of a pass.
enum class PassOutcome
{
    NotTried,       ///< it has no program, or nothing was to be compiled
    Compiled,       ///< for the keywords asked for
    Refused,        ///< it is well formed and limn does not do what it asks for
    MissingInclude, ///< it includes a file that is not there
    Failed
};

struct CheckedUse;

/// A pass of a shader with what compiling it gave.
struct CheckedPass
{
    const ShaderLabPass* pass = nullptr;
    PassOutcome outcome = PassOutcome::NotTried;
    std::string reason; ///< of a refusal, one sentence
    std::shared_ptr<const ShaderProgram> compiled;
    std::vector<std::string> keywords; ///< that it was compiled with
    VariantCount variants;             ///< 0 without a program
    /// Which property keeps the SRP Batcher from taking the pass; "" if none does.
    std::string srpBatcherProblem;
    /// Where a UsePass of the SubShader that limn draws with leads; null for any other pass, and
    /// where it leads nowhere. The pass itself stays NotTried: it counts in the file that has it.
    std::shared_ptr<const CheckedUse> use;
};

/// The pass that a UsePass names, compiled with the keywords of the shader that uses it.
struct CheckedUse
{
    ShaderLabPass pass;
    CheckedPass check; ///< of `pass`
};

struct CheckedSubShader
{
    const ShaderLabSubShader* subShader = nullptr;
    bool isUsed = false; ///< the one that limn draws with
    std::vector<CheckedPass> passes;
};

/// Everything found out about one ShaderLab file.
struct ShaderCheck
{
    std::filesystem::path file;
    bool isParsed = false;                             ///< without an error
    std::shared_ptr<const ShaderLabDocument> document; ///< null if there is no text to read
    std::vector<CheckedSubShader> subShaders;
    std::string drawnFallback;           ///< the shader that limn draws with instead; "" = this one
    std::vector<Diagnostic> diagnostics; ///< errors, warnings and notes; refusals are notes

    bool hasErrors() const;
};

struct ShaderCheckOptions
{
    bool compile = true;
    /// Keywords that are on; without them those that a new material has on.
    std::optional<std::vector<std::string>> keywords;
    /// Where UsePass and Fallback look. Asked only about files that have one; any thread.
    std::function<const ShaderDatabase&()> shaders;
};

/// Parses the file and compiles the passes of its SubShaders. Any thread.
ShaderCheck CheckShader(const std::filesystem::path& file, const ShaderCheckOptions& options,
                        ShaderCompiler& compiler);

} // namespace limn

#pragma once

#include <filesystem>
#include <limn/core/Shader.h>
#include <optional>

namespace limn
{

/// A pass of a shader with what compiling it gave.
struct CheckedPass
{
    const ShaderLabPass* pass = nullptr;
    std::shared_ptr<const CompiledPass> compiled; ///< null: not compiled, or not without errors
};

struct CheckedSubShader
{
    const ShaderLabSubShader* subShader = nullptr;
    bool isUsed = false; ///< the one that limn draws with; only its passes are compiled
    std::vector<CheckedPass> passes;
};

/// Everything found out about one ShaderLab file.
struct ShaderCheck
{
    std::filesystem::path file;
    std::shared_ptr<const ShaderLabDocument> document; ///< null if the file cannot be parsed
    std::vector<CheckedSubShader> subShaders;
    std::vector<Diagnostic> errors;
};

/// Parses the file and, unless `parseOnly`, compiles the passes that limn would draw with, with
/// their keywords' defaults.
ShaderCheck CheckShader(const std::filesystem::path& file, bool parseOnly,
                        const std::shared_ptr<ShaderCompiler>& compiler);

} // namespace limn

#pragma once

#include <limn/shaderlab/Diagnostic.h>
#include <limn/shaderlab/ShaderLabDocument.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// What could be read of a ShaderLab file, and everything that is wrong with it.
struct ShaderLabParseResult
{
    ShaderLabDocument document;
    std::vector<Diagnostic> diagnostics; ///< in the order of the file; warnings among them

    bool hasErrors() const;
};

/// Reads ShaderLab text. Never throws on bad text: after an error it goes on at the next command
/// or brace, so that one call reports several mistakes.
///
/// @param file  name that diagnostics carry and that relative includes of programs start from
ShaderLabParseResult ParseShaderLab(std::string_view text, std::string file);

/// Reads a .shader file.
///
/// @throws AssetError with all errors of the file; also where it is missing, empty or binary
ShaderLabDocument LoadShaderLab(const std::filesystem::path& path);

} // namespace limn

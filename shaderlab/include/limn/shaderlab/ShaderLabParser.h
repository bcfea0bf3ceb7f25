#pragma once

#include <limn/base/Diagnostic.h>
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
    /// In the order of the file; warnings and notes among them. At most 100 of each severity, and
    /// behind them one that tells how many more there are.
    std::vector<Diagnostic> diagnostics;

    bool hasErrors() const;
};

/// Reads ShaderLab text. Never throws on bad text: after an error it goes on at the next command
/// or brace, so that one call reports several mistakes. Time and memory are proportional to the
/// text, whatever is in it; text of more than 64 MiB is an error.
///
/// @param file  name that diagnostics carry and that relative includes of programs start from
ShaderLabParseResult ParseShaderLab(std::string_view text, std::string file);

/// Reads a .shader file.
///
/// @throws AssetError with all errors of the file; also where it is missing, empty or binary
ShaderLabDocument LoadShaderLab(const std::filesystem::path& path);

/// Reads a .shader file and gives all diagnostics, errors too, with what could be read beside them.
///
/// @throws AssetError only where there is no text to read: the file is missing, empty or binary
ShaderLabParseResult LoadShaderLabWithDiagnostics(const std::filesystem::path& path);

} // namespace limn

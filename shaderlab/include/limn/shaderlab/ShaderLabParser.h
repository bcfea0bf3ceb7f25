#pragma once

#include <limn/base/Diagnostic.h>
#include <limn/shaderlab/ShaderLabDocument.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The readable parts of a ShaderLab file, and all its problems.
struct ShaderLabParseResult
{
    ShaderLabDocument document;
    /// All errors, warnings and notes in the order of the file: at most 100 of each severity,
    /// followed by one that says how many more there are.
    std::vector<Diagnostic> diagnostics;

    bool hasErrors() const;
    /// Moves the document out.
    /// @throws AssetError with all diagnostics if there are errors
    ShaderLabDocument TakeDocument();
};

/// Reads ShaderLab text. Never throws on bad text: after an error it continues at the next command
/// or brace, so that one call reports several mistakes. Time and memory are proportional to the
/// length of the text, whatever it contains; text of more than 64 MiB is an error.
///
/// @param file  the name of the file in diagnostics; relative includes of programs start from its
///     folder
ShaderLabParseResult ParseShaderLab(std::string_view text, std::string file);

/// Reads a .shader file.
///
/// @throws AssetError with all errors of the file, or if it is missing, empty or binary
ShaderLabDocument LoadShaderLab(const std::filesystem::path& path);

/// Reads a .shader file and returns all diagnostics, also errors, with the readable parts.
///
/// @throws AssetError only if there is no text to read: the file is missing, empty or binary
ShaderLabParseResult LoadShaderLabWithDiagnostics(const std::filesystem::path& path);

} // namespace limn

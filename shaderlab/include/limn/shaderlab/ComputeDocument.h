#pragma once

#include <limn/shaderlab/PassProgram.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A .compute file as plain data; nothing is compiled. Unity: the asset behind a ComputeShader
/// (2022.3).
struct ComputeDocument
{
    std::string file;
    std::string name; ///< the name of the file without its extension
    /// One program for each `#pragma kernel`, in the order of the file. PassProgram::kernel is its
    /// function; the macros that the pragma names come before the text.
    std::vector<PassProgram> kernels;

    bool operator==(const ComputeDocument&) const = default;
};

/// @param file  the name of the text in error messages; relative includes start from its folder
/// @throws AssetError with every problem: no `#pragma kernel`, one without a function, two with one
///     name
ComputeDocument ParseCompute(std::string_view text, std::string file);
/// @throws AssetError as ParseCompute, and if the file is missing or is no text
ComputeDocument LoadCompute(const std::filesystem::path& path);

} // namespace limn

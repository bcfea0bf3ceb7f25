#pragma once

#include <limn/shaderlab/PassProgram.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A .compute file as plain data, nothing compiled. Unity: the asset behind a ComputeShader
/// (2022.3).
struct ComputeDocument
{
    std::string file;
    std::string name; ///< the file's, without its ending
    /// One for each `#pragma kernel`, in the order of the file: PassProgram::kernel is its
    /// function; the macros that the pragma names come before the text.
    std::vector<PassProgram> kernels;

    bool operator==(const ComputeDocument&) const = default;
};

/// @param file  what error messages call the text; relative includes start from its folder
/// @throws AssetError for all of: no `#pragma kernel`, one without a function, two of one name
ComputeDocument ParseCompute(std::string_view text, std::string file);
/// @throws AssetError if the file is missing, too, or is no text
ComputeDocument LoadCompute(const std::filesystem::path& path);

} // namespace limn

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

struct IncludedFile
{
    std::string name; ///< path on disk, or virtual path of a file that a program holds
    std::string text;
    bool isEmbedded = false; ///< true for a file of the built-in ShaderLibrary
};

/// The files that are compiled into a program for its own shaders. Messages have their names:
/// "Glow/Blur.hlsl".
using FilesBeside = std::vector<IncludedFile>;

/// Returns the files that SetEmbeddedIncludes has put beside a shader until now; most shaders have
/// none.
FilesBeside FilesBesideShader(std::string_view shaderFile);

/// Returns the content hash of the files, or 0 if there are none.
std::uint64_t HashFilesBeside(const FilesBeside& files);

/// Returns the file of that name, or null if there is none. Case does not count.
const IncludedFile* FindFileBeside(const FilesBeside& files, std::string_view name);

/// Returns the file that an include from a project's folder, "Assets/X/Blur.hlsl", stands for; null
/// if no file, or more than one, has its last name.
const IncludedFile* FindFileOfProject(const FilesBeside& files, std::string_view include);

} // namespace limn

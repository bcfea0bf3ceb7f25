#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A file that is compiled into a program, with its name in messages: "Glow/Blur.hlsl".
struct FileBeside
{
    std::string name;
    std::string text;
};
using FilesBeside = std::vector<FileBeside>;

/// Returns the files that SetEmbeddedIncludes has put beside a shader until now; most shaders have
/// none.
FilesBeside FilesBesideShader(std::string_view shaderFile);

/// Returns the content hash of the files, or 0 if there are none.
std::uint64_t HashFilesBeside(const FilesBeside& files);

/// Returns the file of that name, or null if there is none. Case does not count.
const FileBeside* FindFileBeside(const FilesBeside& files, std::string_view name);

/// Returns the file that an include from a project's folder, "Assets/X/Blur.hlsl", stands for; null
/// if no file, or more than one, has its last name.
const FileBeside* FindFileOfProject(const FilesBeside& files, std::string_view include);

} // namespace limn

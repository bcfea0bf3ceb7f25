#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A file compiled into a program, by the name that messages call it: "Glow/Blur.hlsl".
struct FileBeside
{
    std::string name;
    std::string text;
};
using FilesBeside = std::vector<FileBeside>;

/// What SetEmbeddedIncludes has put beside a shader, now; none beside most.
FilesBeside FilesBesideShader(std::string_view shaderFile);

/// Content hash of them; 0 where there are none.
std::uint64_t HashFilesBeside(const FilesBeside& files);

/// The file of that name, or null. Case does not count.
const FileBeside* FindFileBeside(const FilesBeside& files, std::string_view name);

/// The one file that an include from a project's folder, "Assets/X/Blur.hlsl", stands for; null
/// where no file, or several, have its last name.
const FileBeside* FindFileOfProject(const FilesBeside& files, std::string_view include);

} // namespace limn

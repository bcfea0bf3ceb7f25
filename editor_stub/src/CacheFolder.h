#pragma once

#include <filesystem>
#include <string>

namespace limn
{

/// Where limn keeps compiled shaders and pipelines: $XDG_CACHE_HOME/limn or ~/.cache/limn. "" if
/// neither variable is set.
std::filesystem::path DefaultCacheFolder();

/// Makes the folder if it is not there; the system's reason if that fails, else "".
std::string MakeFolder(const std::filesystem::path& folder);

} // namespace limn

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace limn
{

/// Returns the folder of compiled shaders, pipelines and imported models and pictures:
/// $XDG_CACHE_HOME/limn or ~/.cache/limn. Returns "" if neither variable is set.
std::filesystem::path DefaultCacheFolder();

/// Returns the most bytes that the compiled shaders in the cache folder may take; imported models
/// and pictures may take four times as many. The limit is the value of LIMN_CACHE_LIMIT, else
/// `otherwise`: "200000", "512K", "64M", "2G" (K = 1024); "0" = no limit.
/// @throws AssetError if the variable is anything else
std::uintmax_t CacheLimit(std::uintmax_t otherwise);

/// Makes the folder if it is not there. Returns the system's reason if that fails, else "".
std::string MakeFolder(const std::filesystem::path& folder);

} // namespace limn

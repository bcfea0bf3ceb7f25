#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace limn
{

/// Returns the folder of compiled shaders, pipelines and imported models and pictures:
/// $XDG_CACHE_HOME/limn or ~/.cache/limn. "" if neither variable is set.
std::filesystem::path DefaultCacheFolder();

/// Bytes that the compiled shaders in the cache folder may take, and a quarter of those that
/// imported models and pictures may: what LIMN_CACHE_LIMIT says, else
/// `otherwise`. "200000", "512K", "64M", "2G" (K = 1024); "0" = no limit.
/// @throws AssetError if the variable is anything else
std::uintmax_t CacheLimit(std::uintmax_t otherwise);

/// Makes the folder if it is not there; the system's reason if that fails, else "".
std::string MakeFolder(const std::filesystem::path& folder);

} // namespace limn

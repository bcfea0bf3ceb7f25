#include "CacheFolder.h"

#include <cstdlib>

namespace limn
{

std::filesystem::path DefaultCacheFolder()
{
    // The XDG specification: relative paths are to be ignored.
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache && std::filesystem::path(cache).is_absolute())
    {
        return std::filesystem::path(cache) / "limn";
    }
    const char* home = std::getenv("HOME");
    return home && *home ? std::filesystem::path(home) / ".cache" / "limn"
                         : std::filesystem::path();
}

std::string MakeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    return error ? error.message() : std::string();
}

} // namespace limn

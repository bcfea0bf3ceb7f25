#include "console/CacheFolder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <limn/base/Diagnostic.h>
#include <string_view>

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

std::uintmax_t CacheLimit(std::uintmax_t otherwise)
{
    static constexpr const char* k_Variable = "LIMN_CACHE_LIMIT";
    static constexpr std::array<std::string_view, 4> k_Units{"", "K", "M", "G"};
    const char* variable = std::getenv(k_Variable);
    if (!variable)
    {
        return otherwise;
    }
    const std::string_view text = variable;
    std::uintmax_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
    const auto found = std::ranges::find(k_Units, unit);
    const auto shift = 10 * (found - k_Units.begin());
    if (error != std::errc() || found == k_Units.end() || number > (UINTMAX_MAX >> shift))
    {
        throw AssetError(k_Variable, {},
                         "'" + std::string(text) +
                             "' is no size of a cache; write a number of bytes, with K, M or G "
                             "behind it if need be, such as 512M, or 0 for no limit");
    }
    return number << shift;
}

std::string MakeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    return error ? error.message() : std::string();
}

} // namespace limn

#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <system_error>

namespace limn
{

/// Writes a file that appears whole or not at all: readers see the old content or the new one, and
/// after a failure the old one stays and nothing is left beside it. The folder must exist. A file
/// that is replaced keeps its permissions.
/// @param beforeReplace  called when the new content is on the disk; what it throws is a failure
/// @return the system's reason, if it cannot be written
[[nodiscard]] std::error_code TryWriteFile(const std::filesystem::path& path,
                                           std::string_view bytes,
                                           const std::function<void()>& beforeReplace = {});

/// TryWriteFile, for files a person asked for.
/// @throws AssetError naming the path and the system's reason, if it cannot be written
void WriteFile(const std::filesystem::path& path, std::string_view bytes,
               const std::function<void()>& beforeReplace = {});

} // namespace limn

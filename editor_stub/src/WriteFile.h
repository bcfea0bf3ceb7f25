#pragma once

#include <filesystem>
#include <string_view>

namespace limn
{

/// Writes beside the target and renames over it, so that the file appears whole or not at all.
/// @throws AssetError naming the path and the system's reason, if it cannot be written
void WriteFile(const std::filesystem::path& path, std::string_view content);

} // namespace limn

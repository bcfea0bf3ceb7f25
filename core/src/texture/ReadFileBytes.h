#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace limn
{

/// The whole file.
/// @throws AssetError naming the path and the system's reason, if it cannot be read
std::vector<std::byte> ReadFileBytes(const std::filesystem::path& path);

} // namespace limn

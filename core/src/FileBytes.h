#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace limn
{

/// The whole file.
/// @throws AssetError naming the path and the system's reason, if it cannot be read
std::vector<std::byte> ReadFileBytes(const std::filesystem::path& path);

/// Writes beside the target and renames over it, so that no reader ever sees half a file; where
/// that fails, whatever was there before still is.
/// @throws AssetError naming the path and the system's reason, if it cannot be written
void WriteFileAtomically(const std::filesystem::path& path, const std::vector<std::byte>& bytes);

} // namespace limn

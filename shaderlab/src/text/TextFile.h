#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace limn
{

/// The bytes of a regular file, nothing where there is none or it cannot be read.
std::optional<std::string> ReadTextFile(const std::filesystem::path& path);

} // namespace limn

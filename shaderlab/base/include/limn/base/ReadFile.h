#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace limn
{

/// How much is read of a file at most: of text, and of pictures and meshes.
inline constexpr std::uintmax_t k_MaxTextBytes = std::uintmax_t{64} << 20;
inline constexpr std::uintmax_t k_MaxDataBytes = std::uintmax_t{512} << 20;

/// What reading a file gave.
struct FileContent
{
    std::string bytes;
    std::string problem; ///< "there is no such file" and the like; "" if the file was read

    bool isRead() const { return problem.empty(); }
};

/// All of a regular file, or of the one that a link leads to. Never waits for anybody: folders,
/// pipes, sockets and devices are refused, and so is what is longer than `limit`, before a byte of
/// it is read.
/// @throws std::system_error where the machine lacks what it takes, such as file descriptors
FileContent TryReadFile(const std::filesystem::path& path, std::uintmax_t limit = k_MaxTextBytes);

/// TryReadFile, for a file that is needed.
/// @throws AssetError naming the path and the problem; std::system_error as TryReadFile
std::string ReadFile(const std::filesystem::path& path, std::uintmax_t limit = k_MaxTextBytes);

} // namespace limn

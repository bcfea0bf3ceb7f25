#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace limn
{

/// The greatest sizes of files that are read: of text, and of pictures and meshes.
inline constexpr std::uintmax_t k_MaxTextBytes = std::uintmax_t{64} << 20;
inline constexpr std::uintmax_t k_MaxDataBytes = std::uintmax_t{512} << 20;

/// The result of reading a file.
struct FileContent
{
    std::string bytes;
    std::string problem; ///< "there is no such file" and the like; "" if the file was read

    bool isRead() const { return problem.empty(); }
};

/// Reads all of a regular file, or of the one that a link leads to. Never waits for another
/// program: it rejects folders, pipes, sockets and devices, and files longer than `limit`, before
/// it reads a byte.
/// @throws std::system_error if the machine lacks a resource, such as file descriptors
FileContent TryReadFile(const std::filesystem::path& path, std::uintmax_t limit = k_MaxTextBytes);

/// Reads a file like TryReadFile, but throws if it cannot be read.
/// @throws AssetError naming the path and the problem; std::system_error as TryReadFile
std::string ReadFile(const std::filesystem::path& path, std::uintmax_t limit = k_MaxTextBytes);

} // namespace limn

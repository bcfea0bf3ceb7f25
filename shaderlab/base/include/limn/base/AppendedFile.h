#pragma once

#include <filesystem>
#include <string_view>

namespace limn
{

/// A file that grows at its end. Append returns when the bytes are on the disk.
class AppendedFile
{
public:
    /// Opens the file, or makes it.
    /// @throws AssetError if it cannot be opened
    explicit AppendedFile(std::filesystem::path path);
    ~AppendedFile();
    AppendedFile(const AppendedFile&) = delete;
    AppendedFile& operator=(const AppendedFile&) = delete;

    /// @throws AssetError if the bytes cannot be written
    void Append(std::string_view bytes);

private:
    std::filesystem::path m_Path;
    int m_Descriptor;
};

} // namespace limn

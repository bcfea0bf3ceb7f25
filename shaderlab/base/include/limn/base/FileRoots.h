#pragma once

#include <filesystem>
#include <vector>

namespace limn
{

/// The folders in which files may lie that another file refers to.
class FileRoots
{
public:
    /// Adds a folder. It is relative to the working directory; "" is the working directory itself.
    void Add(const std::filesystem::path& folder);

    /// Returns whether the path lies below one of the folders after all links are followed. The
    /// file need not exist.
    bool Contains(const std::filesystem::path& path) const;

private:
    std::vector<std::filesystem::path> m_Folders; ///< canonical
};

} // namespace limn

#pragma once

#include <filesystem>
#include <vector>

namespace limn
{

/// The folders that what a file refers to may lie in.
class FileRoots
{
public:
    /// Relative to the working directory; "" is the working directory itself.
    void Add(const std::filesystem::path& folder);

    /// Whether the path lies below one of the folders once all links are followed; there need not
    /// be such a file.
    bool Contains(const std::filesystem::path& path) const;

private:
    std::vector<std::filesystem::path> m_Folders; ///< canonical
};

} // namespace limn

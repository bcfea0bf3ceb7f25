#include <limn/base/FileRoots.h>

#include <algorithm>
#include <limn/base/WriteFile.h>

namespace limn
{

void FileRoots::Add(const std::filesystem::path& folder)
{
    std::error_code error;
    const std::filesystem::path real = std::filesystem::weakly_canonical(
        folder.is_absolute() ? folder : std::filesystem::current_path(error) / folder, error);
    // No folder is everything's root, which a path that cannot be resolved would be.
    if (!error && !real.empty() && std::ranges::find(m_Folders, real) == m_Folders.end())
    {
        m_Folders.push_back(real);
    }
}

bool FileRoots::Contains(const std::filesystem::path& path) const
{
    std::error_code error;
    const std::filesystem::path file = BehindLinks(path); // weakly_canonical needs it to be there
    const std::filesystem::path real = std::filesystem::weakly_canonical(
        file.is_absolute() ? file : std::filesystem::current_path(error) / file, error);
    return !error &&
           std::any_of(
               m_Folders.begin(), m_Folders.end(),
               [&real](const std::filesystem::path& root) {
                   return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first ==
                          root.end();
               });
}

} // namespace limn

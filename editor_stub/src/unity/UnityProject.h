#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace limn
{

/// The nearest folder above a file that has an Assets folder; "" if there is none.
std::filesystem::path UnityProjectAround(const std::filesystem::path& file);

/// The scripts, shaders, textures and materials of the Unity project around an asset, by guid.
class UnityProject
{
public:
    /// The one around `asset`; without one it is empty.
    explicit UnityProject(const std::filesystem::path& asset);

    /// The path that a .meta file of a .cs, .shader, .png or .mat file belongs to, whether that
    /// file is there or not; null if no .meta file has the guid.
    const std::filesystem::path* Find(std::string_view guid) const;

    /// "" if there is none.
    const std::filesystem::path& root() const { return m_Root; }

private:
    void Scan();

    std::filesystem::path m_Root;
    std::map<std::string, std::filesystem::path, std::less<>> m_Files;
};

} // namespace limn

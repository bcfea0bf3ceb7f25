#include "program/PackageFolders.h"

#include <limn/shaderlab/ReadFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace limn
{

PackageFolders::PackageFolders(std::filesystem::path shaderFile,
                               std::optional<std::filesystem::path> project)
    : m_ShaderFile(std::move(shaderFile)), m_Project(std::move(project))
{
}

const std::filesystem::path* PackageFolders::Find(const std::string& name)
{
    if (!m_IsListed)
    {
        m_IsListed = true;
        List();
    }
    const auto found = m_Folders.find(name);
    return found == m_Folders.end() ? nullptr : &found->second;
}

void PackageFolders::List()
{
    // The nearest wins: a package that lies in the project comes before one from the cache.
    for (std::filesystem::path folder = m_ShaderFile.parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
    {
        Add(folder);
    }
    if (!m_Project)
    {
        return;
    }
    for (const char* const parent : {"Packages", "Library/PackageCache"})
    {
        std::error_code error;
        std::vector<std::filesystem::path> folders;
        for (std::filesystem::directory_iterator entry(*m_Project / parent, error), end;
             !error && entry != end; entry.increment(error))
        {
            folders.push_back(entry->path());
        }
        std::sort(folders.begin(), folders.end());
        std::for_each(folders.begin(), folders.end(),
                      [this](const std::filesystem::path& folder) { Add(folder); });
    }
}

void PackageFolders::Add(const std::filesystem::path& folder)
{
    const std::filesystem::path manifest = folder / "package.json";
    std::error_code error;
    if (!std::filesystem::is_regular_file(manifest, error))
    {
        return;
    }
    m_Manifests.push_back(manifest);
    const FileContent content = TryReadFile(manifest);
    const auto json = nlohmann::json::parse(content.bytes, nullptr, false);
    if (content.isRead() && json.is_object() && json.contains("name") && json["name"].is_string())
    {
        m_Folders.try_emplace(json["name"].get<std::string>(), folder);
    }
}

} // namespace limn

#include "port/ProjectScripts.h"

#include "port/csharp/CSharpTokens.h"
#include "unity/UnityProject.h"

#include <algorithm>
#include <limn/base/ReadFile.h>
#include <tuple>

namespace limn
{

namespace
{

constexpr std::uintmax_t k_MaxScriptBytes = std::uintmax_t{1} << 20;

/// Returns whether a text has the words `class name`, or those of a struct or an enum.
bool Declares(std::string_view text, std::string_view name)
{
    for (const std::string_view keyword : {"class ", "struct ", "enum "})
    {
        const std::string words = std::string(keyword) + std::string(name);
        for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1))
        {
            const std::size_t end = at + words.size();
            if (end == text.size() || !IsNamePart(text[end]))
            {
                return true;
            }
        }
    }
    return false;
}

/// Returns the number of folders that two paths have in common.
std::ptrdiff_t CommonFolders(const std::filesystem::path& a, const std::filesystem::path& b)
{
    return std::distance(a.begin(), std::ranges::mismatch(a, b).in1);
}

} // namespace

ProjectScripts::ProjectScripts(const std::filesystem::path& file)
    : m_File(std::filesystem::absolute(file).lexically_normal())
{
    const std::filesystem::path root = UnityProjectAround(file);
    std::error_code ignored;
    if (root.empty()) // a folder that somebody has copied out of a project
    {
        std::filesystem::directory_iterator entry(m_File.parent_path(), ignored);
        for (; entry != std::filesystem::directory_iterator(); entry.increment(ignored))
        {
            AddScript(entry->path());
        }
        return;
    }
    if (!std::filesystem::is_directory(root / "Assets", ignored))
    {
        AddFolder(root);
        return;
    }
    AddFolder(root / "Assets");
    AddFolder(root / "Packages");
}

void ProjectScripts::AddFolder(const std::filesystem::path& folder)
{
    const auto options = std::filesystem::directory_options::skip_permission_denied;
    std::error_code ignored;
    std::filesystem::recursive_directory_iterator entry(folder, options, ignored);
    for (; entry != std::filesystem::recursive_directory_iterator(); entry.increment(ignored))
    {
        const std::filesystem::path& path = entry->path();
        const std::string name = path.filename().string();
        // A player has no scripts of the editor, and limn stands for Unity's packages.
        if (name == "Editor" || name.starts_with("com.unity.") || IsPassedOver(name))
        {
            entry.disable_recursion_pending();
        }
        else
        {
            AddScript(path);
        }
    }
}

void ProjectScripts::AddScript(const std::filesystem::path& path)
{
    if (path.extension() == ".cs")
    {
        m_Scripts.push_back({path, TryReadFile(path, k_MaxScriptBytes).bytes});
    }
}

std::vector<const ProjectScript*> ProjectScripts::FindDeclarations(std::string_view name) const
{
    std::vector<const ProjectScript*> found;
    const bool isName = std::ranges::all_of(name, IsNamePart); // and no "Type.member"
    for (const ProjectScript& script : m_Scripts)
    {
        if (isName && Declares(script.text, name))
        {
            found.push_back(&script);
        }
    }
    const auto rank = [&](const ProjectScript* script)
    {
        return std::tuple(script->path.stem() != name, -CommonFolders(script->path, m_File),
                          script->path);
    };
    std::ranges::sort(found, {}, rank);
    return found;
}

} // namespace limn

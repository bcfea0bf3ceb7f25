#include "IncludeResolver.h"

#include "Text.h"
#include "TextFile.h"

#include <limn/shaderlab/EmbeddedFile.h>

#include <algorithm>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> ShaderLibrary();
}

namespace
{

const EmbeddedFile* FindEmbedded(std::string_view path)
{
    for (const EmbeddedFile& file : embedded::ShaderLibrary())
    {
        if (EqualsIgnoringCase(file.path, path))
        {
            return &file;
        }
    }
    return nullptr;
}

bool StartsWith(std::string_view text, std::string_view start)
{
    return text.substr(0, start.size()) == start;
}

} // namespace

std::uint64_t HashContent(std::string_view text)
{
    const std::uint64_t hash = XXH3_64bits(text.data(), text.size());
    return hash == 0 ? 1 : hash; // 0 stands for an absent file
}

std::uint64_t HashFile(const std::string& path)
{
    const auto text = ReadTextFile(path);
    return text ? HashContent(*text) : 0;
}

std::uint64_t HashLibrary()
{
    static const std::uint64_t hash = []
    {
        std::string all;
        for (const EmbeddedFile& file : embedded::ShaderLibrary())
        {
            all.append(file.path).append(1, '\0').append(file.text).append(1, '\0');
        }
        return HashContent(all);
    }();
    return hash;
}

std::optional<IncludedFile> IncludeResolver::Find(std::string_view include,
                                                  std::string_view includer)
{
    std::string path(include);
    std::replace(path.begin(), path.end(), '\\', '/');
    return Locate(path, std::string(includer));
}

std::optional<IncludedFile> IncludeResolver::Locate(const std::string& include,
                                                    const std::string& includer)
{
    const std::filesystem::path folder = std::filesystem::path(includer).parent_path();
    const std::string beside = (folder / include).lexically_normal().generic_string();
    if (FindEmbedded(includer))
    {
        if (const EmbeddedFile* file = FindEmbedded(beside))
        {
            return IncludedFile{std::string(file->path), std::string(file->text)};
        }
    }
    else if (auto file = ReadFromDisk(beside))
    {
        return file;
    }
    if (StartsWith(include, "Packages/"))
    {
        if (auto file = ReadFromPackage(include))
        {
            return file;
        }
    }
    if (auto file = ReadFromDisk((m_Options.projectRoot / include).lexically_normal()))
    {
        return file;
    }
    for (const std::string& path : {include, "CGIncludes/" + include})
    {
        if (const EmbeddedFile* file = FindEmbedded(path))
        {
            return IncludedFile{std::string(file->path), std::string(file->text)};
        }
    }
    return std::nullopt;
}

std::optional<IncludedFile> IncludeResolver::ReadFromPackage(const std::string& include)
{
    const std::size_t nameStart = std::string_view("Packages/").size();
    const std::size_t nameEnd = std::min(include.find('/', nameStart), include.size());
    const auto package = m_Options.packages.find(include.substr(nameStart, nameEnd - nameStart));
    if (package == m_Options.packages.end() || nameEnd == include.size())
    {
        return std::nullopt;
    }
    return ReadFromDisk((package->second / include.substr(nameEnd + 1)).lexically_normal());
}

std::optional<IncludedFile> IncludeResolver::ReadFromDisk(const std::filesystem::path& path)
{
    const std::string name = path.generic_string();
    auto text = ReadTextFile(path);
    const IncludeDependency dependency{name, text ? HashContent(*text) : 0};
    if (std::find(m_Dependencies.begin(), m_Dependencies.end(), dependency) == m_Dependencies.end())
    {
        m_Dependencies.push_back(dependency);
    }
    if (!text)
    {
        return std::nullopt;
    }
    return IncludedFile{name, std::move(*text)};
}

} // namespace limn

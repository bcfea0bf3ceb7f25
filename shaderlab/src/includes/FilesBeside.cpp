#include "includes/FilesBeside.h"

#include <limn/base/Text.h>

#include <limn/base/Diagnostic.h>
#include <limn/base/HashContent.h>
#include <limn/shaderlab/EmbeddedIncludes.h>

#include <algorithm>
#include <map>
#include <mutex>

namespace limn
{

namespace
{

/// The files of the process, by folder.
struct AllFilesBeside
{
    std::mutex mutex;
    std::map<std::string, FilesBeside, std::less<>> byFolder;
};

AllFilesBeside& All()
{
    static AllFilesBeside all;
    return all;
}

std::string_view LastName(std::string_view path)
{
    return path.substr(path.rfind('/') + 1);
}

} // namespace

void SetEmbeddedIncludes(const std::string& folder, std::span<const EmbeddedFile> files)
{
    if (folder.empty())
    {
        throw ContractError("SetEmbeddedIncludes: the folder has no name");
    }
    FilesBeside beside;
    for (const EmbeddedFile& file : files)
    {
        beside.push_back({folder + "/" + std::string(file.path), std::string(file.text)});
    }
    const std::lock_guard lock(All().mutex);
    All().byFolder[folder] = std::move(beside);
}

FilesBeside FilesBesideShader(std::string_view shaderFile)
{
    const std::lock_guard lock(All().mutex);
    const auto found = All().byFolder.find(shaderFile.substr(0, shaderFile.find('/')));
    const bool isInFolder = shaderFile.find('/') != std::string_view::npos;
    return found == All().byFolder.end() || !isInFolder ? FilesBeside() : found->second;
}

std::uint64_t HashFilesBeside(const FilesBeside& files)
{
    std::string all;
    for (const IncludedFile& file : files)
    {
        all.append(file.name).append(1, '\0').append(file.text).append(1, '\0');
    }
    return files.empty() ? 0 : HashContent(all);
}

const IncludedFile* FindFileBeside(const FilesBeside& files, std::string_view name)
{
    const auto found = std::ranges::find_if(files, [&](const IncludedFile& file)
                                            { return EqualsIgnoringCase(file.name, name); });
    return found == files.end() ? nullptr : &*found;
}

const IncludedFile* FindFileOfProject(const FilesBeside& files, std::string_view include)
{
    const auto isMeant = [&](const IncludedFile& file)
    {
        return EqualsIgnoringCase(LastName(file.name), LastName(include));
    };
    const bool isOfProject = include.starts_with("Assets/") || include.starts_with("Packages/");
    const auto found = std::ranges::find_if(files, isMeant);
    return isOfProject && std::ranges::count_if(files, isMeant) == 1 ? &*found : nullptr;
}

} // namespace limn

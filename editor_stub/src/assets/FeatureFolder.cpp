#include "assets/FeatureFolder.h"

#include <limn/base/WriteFile.h>

namespace limn
{

namespace
{

/// @return whether the folder is new
bool MakeFeatureFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    const bool isNew = std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
    {
        throw AssetError(folder.string(), {}, "the folder cannot be made: " + error.message());
    }
    if (!std::filesystem::is_empty(folder))
    {
        throw AssetError(
            folder.string(), {},
            "the folder holds files already, and limn does not overwrite them; name a new folder");
    }
    return isNew;
}

} // namespace

void WriteFeatureFolder(const std::filesystem::path& folder, const std::vector<NewFile>& files,
                        Console& console)
{
    const bool isNew = MakeFeatureFolder(folder);
    try
    {
        for (const NewFile& file : files)
        {
            WriteFile(folder / file.name, file.text);
        }
    }
    catch (...)
    {
        std::error_code ignored;
        for (const NewFile& file : files)
        {
            std::filesystem::remove(folder / file.name, ignored);
        }
        if (isNew)
        {
            std::filesystem::remove(folder, ignored);
        }
        throw;
    }
    for (const NewFile& file : files)
    {
        console.Result((folder / file.name).generic_string());
    }
}

} // namespace limn

#include "commands/FeatureFolder.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace limn
{

void MakeFeatureFolder(const std::string& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
    {
        throw AssetError(folder, {}, "cannot be made: " + error.message());
    }
    if (!std::filesystem::is_empty(folder))
    {
        throw AssetError(folder, {},
                         "holds files already, none of which is written over; name a new folder");
    }
}

void WriteFeatureFile(const std::string& folder, const std::string& name, const std::string& text,
                      Console& console)
{
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    errno = 0;
    std::ofstream stream(path, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
    {
        throw AssetError(path.generic_string(), {},
                         std::string("cannot be written: ") + std::strerror(errno));
    }
    console.Result(path.generic_string());
}

} // namespace limn

#pragma once

#include "console/Console.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limn
{

/// A file of a folder that is begun.
struct NewFile
{
    std::string name;
    std::string text;
};

/// Writes all files into a new folder, or an empty one, and prints their paths as results. If one
/// cannot be written, none stays.
/// @throws AssetError if the folder cannot be made, is not empty, or a file cannot be written
void WriteFeatureFolder(const std::filesystem::path& folder, const std::vector<NewFile>& files,
                        Console& console);

} // namespace limn

#pragma once

#include "console/Console.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limn
{

/// A file of a new folder.
struct NewFile
{
    std::string name;
    std::string text;
};

/// Writes all files into a new or empty folder, and prints their paths as results. If one cannot be
/// written, none stays.
/// @throws AssetError if the folder cannot be made, is not empty, or a file cannot be written
void WriteFeatureFolder(const std::filesystem::path& folder, const std::vector<NewFile>& files,
                        Console& console);

} // namespace limn

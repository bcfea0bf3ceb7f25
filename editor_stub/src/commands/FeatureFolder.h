#pragma once

#include "console/Console.h"

#include <string>

namespace limn
{

/// Makes a new folder, or takes an empty one.
/// @throws AssetError if it cannot be made, or is not empty
void MakeFeatureFolder(const std::string& folder);

/// Writes a file into it, and prints its path as a result.
/// @throws AssetError if it cannot be written
void WriteFeatureFile(const std::string& folder, const std::string& name, const std::string& text,
                      Console& console);

} // namespace limn

#pragma once

#include "port/ClassIndex.h"

#include <utility>

namespace limn
{

/// The classes of C# and the Unity that its conditions were answered for.
struct ReadCSharpFiles
{
    CSharpFiles files;
    CSharpTarget target;
};

/// Reads C# for Unity 2022.3, whose URP 14 limn mirrors. Where no render feature is left by the
/// conditions of that version, for Unity 6, and then with all symbols of a project defined.
/// @param texts  path and text of each file
/// @throws AssetError if one is no C#
ReadCSharpFiles ReadCSharp(const std::vector<std::pair<std::string, std::string>>& texts);

} // namespace limn

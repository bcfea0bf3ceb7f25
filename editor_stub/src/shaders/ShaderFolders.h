#pragma once

#include <filesystem>
#include <limn/shaderlab/ShaderDatabase.h>
#include <string_view>
#include <vector>

namespace limn
{

/// Where UsePass and Fallback of a shader look: the `Assets` folder around the file, else the
/// file's own folder.
std::filesystem::path FolderOfShaders(const std::filesystem::path& shaderFile);

/// The shaders below the folders, in their order, and those that come with limn.
/// @throws AssetError if a folder cannot be searched
ShaderDatabase FindShaders(const std::vector<std::filesystem::path>& folders);

/// Whether Unity or one of its packages has a shader of this name, by the folder in the name: what
/// no project needs to hold.
bool isUnityShader(std::string_view name);

} // namespace limn

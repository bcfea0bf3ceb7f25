#pragma once

#include <filesystem>
#include <limn/shaderlab/ShaderCompiler.h>
#include <limn/shaderlab/ShaderDatabase.h>
#include <string_view>
#include <vector>

namespace limn
{

/// Returns the folder in which UsePass and Fallback of a shader look: the `Assets` folder around
/// the file, else the file's own folder.
std::filesystem::path FolderOfShaders(const std::filesystem::path& shaderFile);

/// Returns the shaders below the folders, in the folders' order, and those that come with limn.
/// @throws AssetError if a folder cannot be searched
ShaderDatabase FindShaders(const std::vector<std::filesystem::path>& folders);

/// Returns whether Unity or one of its packages has a shader of this name, so that no project needs
/// to hold it. The folder in the name tells that, or the whole name for the oldest shaders.
bool isUnityShader(std::string_view name);

/// Returns the options of a compiler that has a process for imports and the default cache folder,
/// if that can be made.
ShaderCompilerOptions DefaultCompilerOptions();

} // namespace limn

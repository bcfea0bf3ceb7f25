#pragma once

#include <limn/base/EmbeddedFile.h>

#include <span>
#include <string>

namespace limn
{

/// Sets the files beside the shaders whose file is called "FOLDER/X.shader". Includes of such a
/// shader are searched there first. The files replace those that the folder had. A path from a
/// project's folder, "Assets/Effects/Blur.hlsl", stands for the only file with its name. May be
/// called on any thread.
/// @param folder  a name, such as a plug-in's; must not be empty
/// @param files   their paths are relative to the folder
void SetEmbeddedIncludes(const std::string& folder, std::span<const EmbeddedFile> files);

} // namespace limn

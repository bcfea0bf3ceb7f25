#pragma once

#include <limn/base/EmbeddedFile.h>

#include <span>
#include <string>

namespace limn
{

/// Gives the shaders whose file is called "FOLDER/X.shader" the files that lie beside them: what
/// such a shader includes is looked for there first. Takes the place of those that the folder had.
/// A path from a project's folder, "Assets/Effects/Blur.hlsl", stands for the one file of its name.
/// Any thread.
/// @param folder  a name, such as a plug-in's; not empty
/// @param files   their paths are relative to the folder
void SetEmbeddedIncludes(const std::string& folder, std::span<const EmbeddedFile> files);

} // namespace limn

#pragma once

#include "assets/References.h"

#include <limn/core/Material.h>

namespace limn
{

/// A material as scenes and material files write it, {shader: ..., _BaseColor: ...}. Null, with an
/// error, if the shader cannot be used: which properties there are is then unknown.
std::shared_ptr<const Material> ReadMaterial(const std::string& name, const YamlNode& node,
                                             References& references, AssetDiagnostics& diagnostics);

/// The material of a .material.yaml file; relative paths in it start at its folder.
/// @throws AssetError with every problem of the file
std::shared_ptr<const Material> ReadMaterialFile(const std::filesystem::path& path,
                                                 AssetContext& assets);

} // namespace limn

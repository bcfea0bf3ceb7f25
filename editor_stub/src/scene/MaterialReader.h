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

/// Sets a material's texture property to what a file says: the name of a default texture; for a 2D
/// property a .png file; for a 3D one or an array {slices: [.png files]}; for a cube or an array of
/// cubes {faces: [.png files]}, six a cube in the order +X -X +Y -Y +Z -Z, each as one sees it from
/// the centre. What is wrong is an error at its place, and the property stays as it was.
void ReadTextureProperty(const ShaderProperty& property, const YamlNode& node,
                         const std::string& subject, Material& material, References& references,
                         AssetDiagnostics& diagnostics);

} // namespace limn

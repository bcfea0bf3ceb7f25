#pragma once

#include <filesystem>
#include <functional>
#include <limn/base/FileRoots.h>
#include <limn/core/Mesh.h>
#include <memory>

namespace limn
{

/// Returns the default scene of a glTF 2.0 file (.gltf or .glb) as one mesh, named after the file.
/// It has a sub-mesh for each primitive of triangles of each node, with node transforms applied.
/// Negating x turns glTF's right-handed space (+Z towards the viewer) into limn's left-handed one;
/// triangles are reversed accordingly. Missing normals are made flat. Vertex colours and uv that
/// only some primitives have are white and 0 in the others; tangents are kept if all primitives
/// have them. Points, lines, skins, morph targets and materials are left out.
/// @param roots  where its buffers may lie besides the file's own folder and those below it
/// @param reach  is called with each file of a buffer before that is read
/// @throws AssetError with every problem, if the file is missing, is not glTF 2.0, holds no
///         triangles, or uses sparse accessors or Draco or meshopt compression
std::shared_ptr<const Mesh>
LoadGltfMesh(const std::filesystem::path& path, const FileRoots& roots = {},
             const std::function<void(const std::filesystem::path&)>& reach = {});

} // namespace limn

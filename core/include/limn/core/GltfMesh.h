#pragma once

#include <filesystem>
#include <limn/base/FileRoots.h>
#include <limn/core/Mesh.h>
#include <memory>

namespace limn
{

/// What the default scene of a glTF 2.0 file (.gltf or .glb) shows, as one mesh: a sub-mesh for
/// each primitive of triangles of each node, node transforms applied, turned from glTF's
/// right-handed space (+Z towards the viewer) into limn's left-handed one by negating x, triangles
/// reversed accordingly. Missing normals are made flat; of vertex colours and uv, what some
/// primitives lack is white and 0; tangents are kept where all primitives have them. Named after
/// the file. Points, lines, skins, morph targets and materials are left out.
/// @param roots  where its buffers may lie besides the file's own folder and those below it
/// @throws AssetError with every problem, if the file is missing, is not glTF 2.0, holds no
///         triangles, or uses sparse accessors or Draco or meshopt compression
std::shared_ptr<const Mesh> LoadGltfMesh(const std::filesystem::path& path,
                                         const FileRoots& roots = {});

} // namespace limn

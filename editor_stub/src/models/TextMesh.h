#pragma once

#include "models/MeshSkin.h"
#include "unity/UnityTree.h"

namespace limn
{

/// Reads a mesh that Unity saved as text, in an .asset file or in a scene: positions, normals,
/// tangents, colours and up to seven sets of uv in any of Unity's formats, triangles and quads,
/// and its bones. A sub-mesh of lines or points has no triangles. Unity: the class Mesh (43) of
/// 2018.1 and later.
/// @param fields  the map below the class's name
/// @param file    the file's name in errors
/// @throws AssetError  naming the line, if a number does not fit the data, or if the mesh is
///     compressed
SkinnableMesh ReadTextMesh(const UnityNode& fields, const std::string& file);

} // namespace limn

#pragma once

#include <glm/mat4x4.hpp>
#include <limn/core/Mesh.h>
#include <stdexcept>

namespace tinygltf
{
class Model;
struct Primitive;
} // namespace tinygltf

namespace limn
{

/// A part of a glTF file that cannot be used; the loader collects them into one AssetError.
class GltfProblem : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Returns the triangles of one primitive, without sub-meshes and still in glTF's space; empty for
/// points and lines. They always have normals.
/// @throws GltfProblem
MeshData ReadGltfPrimitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive);

/// Transforms `part` by `matrix`; a matrix that mirrors also reverses the triangles and the
/// bitangents.
void TransformPart(MeshData& part, const glm::dmat4& matrix);

} // namespace limn

#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <limn/core/Mesh.h>

namespace limn
{

/// The part that a bone has in the place of a vertex.
struct BoneWeight
{
    std::uint32_t bone = 0;
    float weight = 0.0f;
};

/// Four bones at most move a vertex, as in Unity's default quality. Their weights add up to 1; all
/// of a vertex that no bone moves are 0.
using BoneWeights = std::array<BoneWeight, 4>;

/// The bones that move a mesh's vertices. Unity: Mesh.bindposes, Mesh.boneWeights (2022.3).
struct MeshSkin
{
    /// The names of the bones' nodes. Empty if a renderer lists its bones in the order of the
    /// poses.
    std::vector<std::string> bones;
    std::vector<glm::mat4> bindPoses; ///< lead from the mesh's space into the space of each bone
    std::vector<BoneWeights> weights; ///< of each vertex

    bool isEmpty() const { return weights.empty(); }
};

/// A mesh with its bones.
struct SkinnableMesh
{
    std::shared_ptr<const Mesh> mesh; ///< at rest
    MeshSkin skin;                    ///< empty if no bones move it
};

/// Makes weights add up to 1. Weights that are negative or no numbers become 0.
void Normalize(BoneWeights& weights);

/// Returns the mesh with each vertex where its bones put it, or the mesh itself if they leave all
/// vertices where they are.
/// @param bones  leads from the space of each bone into the space of the result
/// @throws ContractError  as Mesh, if the bones put a vertex nowhere
std::shared_ptr<const Mesh> PoseMesh(const std::shared_ptr<const Mesh>& mesh, const MeshSkin& skin,
                                     std::span<const glm::dmat4> bones);

} // namespace limn

#pragma once

#include <glm/mat4x4.hpp>
#include <limn/core/Mesh.h>

namespace tinygltf
{
class Model;
class Node;
} // namespace tinygltf

namespace limn
{

/// Walks a file's nodes and collects what they show.
class GltfCollector
{
public:
    /// @param model  kept by reference
    explicit GltfCollector(const tinygltf::Model& model);

    /// Collects every mesh of the scene that the file shows, in limn's space.
    void CollectAll();

    /// Returns one mesh of everything, with a sub-mesh for each part.
    MeshData TakeMesh();

    /// Returns what could not be used, one sentence each.
    const std::vector<std::string>& problems() const { return m_Problems; }

private:
    std::vector<int> Roots() const;
    void CollectNodes(const glm::dmat4& root);
    const tinygltf::Node* Enter(int index);
    void CollectMesh(int index, const glm::dmat4& matrix);

    const tinygltf::Model& m_Model;
    std::vector<bool> m_Visited;
    std::vector<MeshData> m_Parts;
    std::vector<std::string> m_Problems;
};

} // namespace limn

#pragma once

#include <glm/mat4x4.hpp>
#include <limn/core/Mesh.h>

namespace tinygltf
{
class Model;
}

namespace limn
{

/// Walks a file's nodes and gathers what they show.
class GltfCollector
{
public:
    /// @param model  is kept by reference
    explicit GltfCollector(const tinygltf::Model& model);

    /// Gathers every mesh of the scene that the file shows, in limn's space.
    void CollectAll();

    /// One mesh of all of it, a sub-mesh a part.
    MeshData TakeMesh();

    /// What could not be used, one sentence each.
    const std::vector<std::string>& problems() const { return m_Problems; }

private:
    std::vector<int> Roots() const;
    void CollectNode(int index, const glm::dmat4& parent);
    void CollectMesh(int index, const glm::dmat4& matrix);

    const tinygltf::Model& m_Model;
    std::vector<bool> m_Visited;
    std::vector<MeshData> m_Parts;
    std::vector<std::string> m_Problems;
};

} // namespace limn

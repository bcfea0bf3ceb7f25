#include "gltf/Collector.h"

#include "gltf/Accessor.h"
#include "gltf/Primitive.h"
#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <tiny_gltf.h>
#include <utility>

namespace limn
{

namespace
{

glm::dmat4 LocalMatrix(const tinygltf::Node& node)
{
    if (node.matrix.size() == 16)
    {
        return glm::make_mat4(node.matrix.data());
    }
    const auto& t = node.translation;
    const auto& r = node.rotation;
    const auto& s = node.scale;
    glm::dmat4 matrix =
        r.size() == 4 ? glm::mat4_cast(glm::dquat(r[3], r[0], r[1], r[2])) : glm::dmat4(1.0);
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto i = static_cast<std::size_t>(axis);
        matrix[axis] *= s.size() == 3 ? s[i] : 1.0;
        matrix[3][axis] = t.size() == 3 ? t[i] : 0.0;
    }
    return matrix;
}

/// Puts `from` behind `to`; where only one of them has the array, the other's vertices get
/// `filler`.
template <typename Vector>
void Append(std::vector<Vector>& to, std::size_t vertexCount, const std::vector<Vector>& from,
            std::size_t addedCount, Vector filler)
{
    if (to.empty() && from.empty())
    {
        return;
    }
    to.resize(vertexCount, filler);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(vertexCount + addedCount, filler);
}

} // namespace

GltfCollector::GltfCollector(const tinygltf::Model& model)
    : m_Model(model), m_Visited(model.nodes.size(), false)
{
}

void GltfCollector::CollectAll()
{
    // limn's x axis points the other way.
    glm::dmat4 toLeftHanded(1.0);
    toLeftHanded[0][0] = -1.0;
    CollectNodes(toLeftHanded);
    for (std::size_t i = 0; m_Model.nodes.empty() && i < m_Model.meshes.size(); ++i)
    {
        CollectMesh(static_cast<int>(i), toLeftHanded);
    }
}

/// Returns the roots of the scene that the file shows first. Without scenes they are the nodes that
/// have no parent.
std::vector<int> GltfCollector::Roots() const
{
    if (!m_Model.scenes.empty())
    {
        const auto scene = static_cast<std::size_t>(std::max(m_Model.defaultScene, 0));
        return m_Model.scenes[std::min(scene, m_Model.scenes.size() - 1)].nodes;
    }
    std::vector<bool> isChild(m_Model.nodes.size(), false);
    for (const tinygltf::Node& node : m_Model.nodes)
    {
        for (const int child : node.children)
        {
            if (child >= 0 && static_cast<std::size_t>(child) < isChild.size())
            {
                isChild[static_cast<std::size_t>(child)] = true;
            }
        }
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < isChild.size(); ++i)
    {
        if (!isChild[i])
        {
            roots.push_back(static_cast<int>(i));
        }
    }
    return roots;
}

/// Each node before its children, in the file's order. Not by recursion: a file may be deeper than
/// the stack.
void GltfCollector::CollectNodes(const glm::dmat4& root)
{
    struct Waiting
    {
        int node;
        glm::dmat4 parent;
    };
    std::vector<Waiting> waiting; // the next one last
    const auto add = [&waiting](const std::vector<int>& nodes, const glm::dmat4& parent)
    {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
        {
            waiting.push_back({*node, parent});
        }
    };
    add(Roots(), root);
    while (!waiting.empty())
    {
        const Waiting next = waiting.back();
        waiting.pop_back();
        if (const tinygltf::Node* node = Enter(next.node))
        {
            const glm::dmat4 matrix = next.parent * LocalMatrix(*node);
            if (node->mesh >= 0)
            {
                CollectMesh(node->mesh, matrix);
            }
            add(node->children, matrix);
        }
    }
}

/// Returns a node. Returns null and adds a problem if it does not exist or was entered before.
const tinygltf::Node* GltfCollector::Enter(int index)
{
    const auto i = static_cast<std::size_t>(index);
    if (index < 0 || i >= m_Visited.size() || m_Visited[i])
    {
        m_Problems.push_back("node " + std::to_string(index) +
                             ": it does not exist or has two parents; nodes form a tree");
        return nullptr;
    }
    m_Visited[i] = true;
    return &m_Model.nodes[i];
}

void GltfCollector::CollectMesh(int index, const glm::dmat4& matrix)
{
    if (static_cast<std::size_t>(index) >= m_Model.meshes.size())
    {
        m_Problems.push_back("mesh " + std::to_string(index) +
                             ": it does not exist; the number of meshes is " +
                             std::to_string(m_Model.meshes.size()));
        return;
    }
    const tinygltf::Mesh& mesh = m_Model.meshes[static_cast<std::size_t>(index)];
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i)
    {
        const std::string subject =
            "mesh '" + mesh.name + "' primitive " + std::to_string(i) + ": ";
        try
        {
            MeshData part = ReadGltfPrimitive(m_Model, mesh.primitives[i]);
            if (!part.triangles.empty())
            {
                TransformPart(part, matrix);
                for (const std::string& problem : MeshProblems(part))
                {
                    m_Problems.push_back(subject + problem);
                }
                m_Parts.push_back(std::move(part));
            }
        }
        catch (const GltfProblem& problem)
        {
            m_Problems.push_back(subject + problem.what());
        }
    }
}

MeshData GltfCollector::TakeMesh()
{
    MeshData all;
    const bool allHaveTangents = std::none_of(
        m_Parts.begin(), m_Parts.end(), [](const MeshData& part) { return part.tangents.empty(); });
    for (const MeshData& part : m_Parts)
    {
        const std::size_t before = all.vertices.size();
        const std::size_t added = part.vertices.size();
        Append(all.colors, before, part.colors, added, glm::vec4(1.0f));
        Append(all.uv, before, part.uv, added, glm::vec2(0.0f));
        Append(all.uv2, before, part.uv2, added, glm::vec4(0.0f));
        all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
        all.normals.insert(all.normals.end(), part.normals.begin(), part.normals.end());
        if (allHaveTangents)
        {
            all.tangents.insert(all.tangents.end(), part.tangents.begin(), part.tangents.end());
        }
        all.subMeshes.push_back({static_cast<std::uint32_t>(all.triangles.size()),
                                 static_cast<std::uint32_t>(part.triangles.size())});
        for (const std::uint32_t index : part.triangles)
        {
            all.triangles.push_back(index + static_cast<std::uint32_t>(before));
        }
    }
    m_Parts.clear();
    return all;
}

} // namespace limn

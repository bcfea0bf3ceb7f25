#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limn/core/Color.h>
#include <limn/core/PipelineState.h>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// An axis-aligned box. Unity: UnityEngine.Bounds.
struct Bounds
{
    glm::vec3 center{0.0f};
    glm::vec3 extents{0.0f}; ///< half the size

    bool operator==(const Bounds&) const = default;
};

/// Unity: UnityEngine.Rendering.IndexFormat.
enum class IndexFormat
{
    UInt16 = 0,
    UInt32 = 1
};

/// The triangles of one material slot: a run of the index list.
struct SubMesh
{
    std::uint32_t indexStart = 0;
    std::uint32_t indexCount = 0;

    bool operator==(const SubMesh&) const = default;
};

/// The arrays a mesh is made from. Each but `vertices` may be empty; otherwise it has one element a
/// vertex. Left-handed, metres, clockwise triangles face the viewer. A tangent's w is +-1, so that
/// cross(normal, tangent.xyz) * w points up in the picture (to smaller v), as normal maps want.
struct MeshData
{
    std::vector<glm::vec3> vertices;
    std::vector<glm::vec3> normals;  ///< unit length
    std::vector<glm::vec4> tangents; ///< xyz unit length, towards larger u
    std::vector<glm::vec4> colors;   ///< linear RGBA
    std::vector<glm::vec2> uv;       ///< v = 0 at the bottom of the picture, as in Unity
    // More channels, read as TEXCOORD1 to TEXCOORD6: up to four numbers each, whatever they mean.
    std::vector<glm::vec4> uv2;
    std::vector<glm::vec4> uv3;
    std::vector<glm::vec4> uv4;
    std::vector<glm::vec4> uv5;
    std::vector<glm::vec4> uv6;
    std::vector<glm::vec4> uv7;
    /// A spare channel, read as TEXCOORD7. Unity: mesh.SetUVs(7, ...), called uv8.
    /// BakeOutlineNormals fills it.
    std::vector<glm::vec3> uv8;
    std::vector<std::uint32_t> triangles; ///< three vertex indices a triangle
    std::vector<SubMesh> subMeshes;       ///< empty = one over all of `triangles`

    /// Of four bytes each, as Unity's editor paints them: linear, 255 = 1.
    /// @source Unity: Mesh.colors32, Mesh.SetColors(List<Color32>) (2022.3)
    void SetColors(const std::vector<Color32>& inColors)
    {
        colors.clear();
        for (const Color32& color : inColors)
        {
            colors.push_back(Color(color).vector());
        }
    }
};

/// Immutable geometry; the device uploads it when a frame first draws it.
/// Unity: UnityEngine.Mesh (2022.3).
class Mesh
{
public:
    /// @throws ContractError with every problem, a line each, naming the mesh: there is no vertex,
    ///         an array's length differs from vertices', an index is out of range, a count of
    ///         indices is no multiple of three, a sub-mesh leaves the list, a number is not finite
    Mesh(std::string name, MeshData data);

    /// Unique in the process.
    std::uint64_t id() const { return m_Id; }
    const std::string& name() const { return m_Name; }
    const MeshData& data() const { return m_Data; }
    int subMeshCount() const { return static_cast<int>(m_Data.subMeshes.size()); }
    /// Of a sub-mesh, as DrawMeshInstancedIndirect wants them.
    /// @throws std::out_of_range if there is no such sub-mesh
    std::uint32_t GetIndexCount(int submesh) const { return subMesh(submesh).indexCount; }
    std::uint32_t GetIndexStart(int submesh) const { return subMesh(submesh).indexStart; }
    std::uint32_t GetBaseVertex(int) const { return 0; }
    /// @throws std::out_of_range if there is no such sub-mesh
    MeshTopology GetTopology(int submesh) const
    {
        subMesh(submesh);
        return MeshTopology::Triangles;
    }
    IndexFormat indexFormat() const { return IndexFormat::UInt32; } ///< of all meshes
    const SubMesh& subMesh(int index) const
    {
        return m_Data.subMeshes.at(static_cast<std::size_t>(index));
    }
    /// In object space.
    const Bounds& bounds() const { return m_Bounds; }
    /// Of a sphere around the centre of bounds() that holds all vertices.
    float boundingRadius() const { return m_BoundingRadius; }

private:
    std::uint64_t m_Id;
    std::string m_Name;
    MeshData m_Data;
    Bounds m_Bounds;
    float m_BoundingRadius = 0.0f;
};

/// An array of MeshData, as a vertex function reads it.
struct VertexAttribute
{
    std::string_view semantic;    ///< "TEXCOORD0"
    std::string_view array;       ///< MeshData's name of it: "uv"
    std::size_t components;       ///< floats a vertex
    std::array<float, 4> missing; ///< what a mesh that lacks the array gives
    std::span<const float> (*values)(const MeshData& data);
};

inline constexpr std::size_t k_VertexAttributeCount = 12;

/// All arrays of MeshData but the indices.
const std::array<VertexAttribute, k_VertexAttributeCount>& VertexAttributes();

} // namespace limn

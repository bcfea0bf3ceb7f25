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

/// The triangles of one material slot: a range of the index list.
struct SubMesh
{
    std::uint32_t indexStart = 0;
    std::uint32_t indexCount = 0;

    bool operator==(const SubMesh&) const = default;
};

/// The arrays that a mesh is made from. Each but `vertices` may be empty; otherwise it has one
/// element per vertex. Space is left-handed and in metres; clockwise triangles face the viewer. A
/// tangent's w is +-1, so that cross(normal, tangent.xyz) * w points up in the picture (to smaller
/// v), as normal maps need.
struct MeshData
{
    std::vector<glm::vec3> vertices;
    std::vector<glm::vec3> normals;  ///< unit length
    std::vector<glm::vec4> tangents; ///< xyz unit length, towards larger u
    std::vector<glm::vec4> colors;   ///< linear RGBA
    std::vector<glm::vec2> uv;       ///< v = 0 at the bottom of the picture, as in Unity
    // These are further channels, which shaders read as TEXCOORD1 to TEXCOORD6: up to four numbers
    // each, with any meaning.
    std::vector<glm::vec4> uv2;
    std::vector<glm::vec4> uv3;
    std::vector<glm::vec4> uv4;
    std::vector<glm::vec4> uv5;
    std::vector<glm::vec4> uv6;
    std::vector<glm::vec4> uv7;
    /// A spare channel, which shaders read as TEXCOORD7. Unity: mesh.SetUVs(7, ...), called uv8.
    /// BakeOutlineNormals fills it.
    std::vector<glm::vec3> uv8;
    std::vector<std::uint32_t> triangles; ///< three vertex indices per triangle
    std::vector<SubMesh> subMeshes;       ///< empty = one over all of `triangles`

    /// Sets the colours from four bytes each, as Unity's editor paints them: linear, 255 = 1.
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

/// Returns what keeps `data` from being a mesh, one sentence per problem; empty if nothing does.
/// A loader reports them as problems of its file; Mesh itself throws them.
std::vector<std::string> MeshProblems(const MeshData& data);

/// Immutable geometry; the device uploads it when a frame first draws it.
/// Unity: UnityEngine.Mesh (2022.3).
class Mesh
{
public:
    /// @throws ContractError with every problem, a line each, naming the mesh: there is no vertex,
    ///         an array's length differs from vertices', an index is out of range, a count of
    ///         indices is no multiple of three, a sub-mesh leaves the list, a number is not finite
    Mesh(std::string name, MeshData data);

    /// Returns a number that is unique in the process.
    std::uint64_t id() const { return m_Id; }
    const std::string& name() const { return m_Name; }
    const MeshData& data() const { return m_Data; }
    int subMeshCount() const { return static_cast<int>(m_Data.subMeshes.size()); }
    /// Return the numbers of a sub-mesh that DrawMeshInstancedIndirect needs.
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
    /// Returns the bounds in object space.
    const Bounds& bounds() const { return m_Bounds; }
    /// Returns the radius of a sphere around the centre of bounds() that holds all vertices.
    float boundingRadius() const { return m_BoundingRadius; }

private:
    std::uint64_t m_Id;
    std::string m_Name;
    MeshData m_Data;
    Bounds m_Bounds;
    float m_BoundingRadius = 0.0f;
};

/// An array of MeshData as a vertex function reads it.
struct VertexAttribute
{
    std::string_view semantic;    ///< "TEXCOORD0"
    std::string_view array;       ///< its name in MeshData: "uv"
    std::size_t components;       ///< floats per vertex
    std::array<float, 4> missing; ///< the value for a mesh that lacks the array
    std::span<const float> (*values)(const MeshData& data);
};

inline constexpr std::size_t k_VertexAttributeCount = 12;

/// Returns all arrays of MeshData but the indices.
const std::array<VertexAttribute, k_VertexAttributeCount>& VertexAttributes();

} // namespace limn

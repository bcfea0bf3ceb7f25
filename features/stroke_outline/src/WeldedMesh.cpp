#include "WeldedMesh.h"

#include <algorithm>
#include <tuple>

namespace limn
{

namespace
{

/// Puts positions in an order; -0 counts as 0.
std::tuple<float, float, float> PositionOrder(const glm::vec3& p)
{
    return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
}

/// For each vertex the number of its point.
std::vector<std::uint32_t> WeldPoints(const std::vector<glm::vec3>& vertices,
                                      std::vector<glm::vec3>& points)
{
    std::vector<std::uint32_t> order(vertices.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
    {
        order[i] = i;
    }
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return PositionOrder(vertices[i]); });
    std::vector<std::uint32_t> pointOf(vertices.size());
    for (const std::uint32_t vertex : order)
    {
        if (points.empty() || PositionOrder(points.back()) != PositionOrder(vertices[vertex]))
        {
            points.push_back(vertices[vertex]);
        }
        pointOf[vertex] = static_cast<std::uint32_t>(points.size() - 1);
    }
    return pointOf;
}

/// Leaves one of the faces that have the same corners, in whatever order.
void LeaveOutDoubles(std::vector<WeldedMesh::Face>& faces)
{
    const auto corners = [](const WeldedMesh::Face& face)
    {
        auto sorted = face.points;
        std::ranges::sort(sorted);
        return sorted;
    };
    std::ranges::stable_sort(faces, {}, corners);
    const auto doubles = std::ranges::unique(faces, {}, corners);
    faces.erase(doubles.begin(), doubles.end());
}

std::vector<WeldedMesh::Side> SidesOf(const std::vector<WeldedMesh::Face>& faces)
{
    std::vector<WeldedMesh::Side> sides;
    sides.reserve(faces.size() * 3);
    for (std::uint32_t face = 0; face < faces.size(); ++face)
    {
        const auto& p = faces[face].points;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const std::uint32_t from = p[i];
            const std::uint32_t to = p[(i + 1) % 3];
            sides.push_back({{std::min(from, to), std::max(from, to)}, face, from < to});
        }
    }
    std::ranges::sort(
        sides, {}, [](const WeldedMesh::Side& side) { return std::tie(side.points, side.face); });
    return sides;
}

} // namespace

WeldedMesh Weld(const Mesh& mesh, int subMesh)
{
    const MeshData& data = mesh.data();
    WeldedMesh welded;
    const std::vector<std::uint32_t> pointOf = WeldPoints(data.vertices, welded.points);
    const SubMesh& part = mesh.subMesh(subMesh);
    for (std::uint32_t i = part.indexStart; i < part.indexStart + part.indexCount; i += 3)
    {
        const WeldedMesh::Face face{{pointOf[data.triangles[i]], pointOf[data.triangles[i + 1]],
                                     pointOf[data.triangles[i + 2]]}};
        const auto& p = face.points;
        if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0])
        {
            welded.faces.push_back(face);
        }
    }
    LeaveOutDoubles(welded.faces);
    welded.sides = SidesOf(welded.faces);
    return welded;
}

} // namespace limn

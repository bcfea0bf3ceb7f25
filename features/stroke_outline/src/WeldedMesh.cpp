#include "WeldedMesh.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace limn
{

namespace
{

/// The share of a line's length up to which a point counts as lying on the line.
constexpr double k_Apart = 1e-5;

/// Returns whether no corner of a face lies on the side opposite to it.
bool HasArea(const WeldedMesh::Face& face, const std::vector<glm::vec3>& points)
{
    const glm::dvec3 a(points[face.points[0]]);
    const glm::dvec3 ab = glm::dvec3(points[face.points[1]]) - a;
    const glm::dvec3 ac = glm::dvec3(points[face.points[2]]) - a;
    const glm::dvec3 bc = ac - ab;
    const glm::dvec3 area = glm::cross(ab, ac); // twice: the longest side times the height on it
    const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    return glm::dot(area, area) > k_Apart * k_Apart * longest * longest;
}

/// Puts positions in an order.
std::tuple<float, float, float> PositionOrder(const glm::vec3& p)
{
    return {p.x, p.y, p.z};
}

/// Returns the number of the point of each vertex.
std::vector<std::uint32_t> WeldPoints(const std::vector<glm::vec3>& vertices,
                                      std::vector<glm::vec3>& points)
{
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
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
    const auto doubles = std::unique(faces.begin(), faces.end(), // Clang 14 has not that of ranges
                                     [&](const WeldedMesh::Face& a, const WeldedMesh::Face& b)
                                     { return corners(a) == corners(b); });
    faces.erase(doubles, faces.end());
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
    return sides;
}

void Sort(std::vector<WeldedMesh::Side>& sides)
{
    std::ranges::sort(
        sides, {}, [](const WeldedMesh::Side& side) { return std::tie(side.points, side.face); });
}

/// Splits the sides of large faces where corners of smaller faces lie on them (T-junctions), so
/// that the small faces' sides meet them. All of these sides have one face only, and the small ones
/// lead from one end of the large one to its other end.
class SideSplitter
{
public:
    /// @param sides  sorted
    SideSplitter(const std::vector<glm::vec3>& points, const std::vector<WeldedMesh::Side>& sides)
        : m_Points(points)
    {
        for (std::size_t i = 0; i < sides.size(); ++i)
        {
            const bool isAlone = (i == 0 || sides[i - 1].points != sides[i].points) &&
                                 (i + 1 == sides.size() || sides[i + 1].points != sides[i].points);
            if (isAlone)
            {
                const auto [a, b] = sides[i].points;
                m_Lone.push_back(i);
                m_Neighbours.push_back({a, b});
                m_Neighbours.push_back({b, a});
            }
        }
        std::ranges::sort(m_Neighbours);
    }

    void Split(std::vector<WeldedMesh::Side>& sides) const
    {
        bool isSplit = false;
        for (const std::size_t lone : m_Lone)
        {
            const WeldedMesh::Side whole = sides[lone];
            const std::vector<std::uint32_t> path = PathAlong(whole);
            for (std::size_t i = 1; path.size() > 2 && i < path.size(); ++i)
            {
                const std::uint32_t from = path[i - 1];
                const std::uint32_t to = path[i];
                const WeldedMesh::Side part{{std::min(from, to), std::max(from, to)},
                                            whole.face,
                                            whole.isForward == (from < to)};
                i == 1 ? void(sides[lone] = part) : sides.push_back(part);
                isSplit = true;
            }
        }
        if (isSplit)
        {
            Sort(sides);
        }
    }

private:
    /// From one end to the other over points that lie on the side; empty if there is no such path.
    std::vector<std::uint32_t> PathAlong(const WeldedMesh::Side& side) const
    {
        std::vector<std::uint32_t> path{side.points[0]};
        double place = 0.0;
        while (path.back() != side.points[1])
        {
            const auto next = NextOn(side, path.back(), place);
            if (!next)
            {
                return {};
            }
            path.push_back(next->first);
            place = next->second;
        }
        return path;
    }

    /// The neighbour that comes next on the side behind a place (0...1), and its place; the side's
    /// own other end comes last.
    std::optional<std::pair<std::uint32_t, double>> NextOn(const WeldedMesh::Side& side,
                                                           std::uint32_t from, double place) const
    {
        const glm::dvec3 start(m_Points[side.points[0]]);
        const glm::dvec3 along = glm::dvec3(m_Points[side.points[1]]) - start;
        const double squared = glm::dot(along, along);
        std::optional<std::pair<std::uint32_t, double>> next;
        for (auto pair = std::ranges::lower_bound(m_Neighbours, std::pair{from, std::uint32_t{0}});
             pair != m_Neighbours.end() && pair->first == from; ++pair)
        {
            const glm::dvec3 across = glm::dvec3(m_Points[pair->second]) - start;
            const double at = glm::dot(across, along) / squared;
            const glm::dvec3 apart = across - along * at;
            const bool isOn = glm::dot(apart, apart) <= k_Apart * k_Apart * squared;
            if (isOn && at > place && at <= 1.0 && (!next || at < next->second))
            {
                next = {pair->second, at};
            }
        }
        return next;
    }

    const std::vector<glm::vec3>& m_Points;
    std::vector<std::size_t> m_Lone; ///< sides that no other face has
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_Neighbours; ///< along those, both ways
};

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
        if (HasArea(face, welded.points)) // else its neighbours' sides meet without it
        {
            welded.faces.push_back(face);
        }
    }
    LeaveOutDoubles(welded.faces);
    welded.sides = SidesOf(welded.faces);
    Sort(welded.sides);
    SideSplitter(welded.points, welded.sides).Split(welded.sides);
    return welded;
}

} // namespace limn

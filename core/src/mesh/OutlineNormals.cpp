#include <limn/core/OutlineNormals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace limn
{

namespace
{

/// One corner of a triangle that has an area.
struct Corner
{
    std::uint32_t vertex = 0;
    glm::dvec3 faceNormal{0.0};
    double angle = 0.0;
};

/// The index of the first vertex at the same position, for each vertex.
std::vector<std::uint32_t> Weld(const std::vector<glm::vec3>& points)
{
    std::map<std::array<float, 3>, std::uint32_t> known;
    std::vector<std::uint32_t> welded;
    for (std::uint32_t i = 0; i < points.size(); ++i)
    {
        welded.push_back(
            known.try_emplace({points[i].x, points[i].y, points[i].z}, i).first->second);
    }
    return welded;
}

/// Sets of corners that are to move alike.
class CornerGroups
{
public:
    std::size_t Find(std::size_t corner)
    {
        while (m_Parents[corner] != corner)
        {
            m_Parents[corner] = m_Parents[m_Parents[corner]];
            corner = m_Parents[corner];
        }
        return corner;
    }

    /// Adds a corner. It joins those of its vertex, which cannot move apart, and at its position
    /// those that share an edge with it.
    void Add(std::uint32_t vertex, std::uint32_t position, std::uint32_t before,
             std::uint32_t after)
    {
        const std::size_t corner = m_Parents.size();
        m_Parents.push_back(corner);
        Join(corner, m_ByVertex.try_emplace(vertex, corner).first->second);
        Join(corner, m_ByEdge.try_emplace({position, before}, corner).first->second);
        Join(corner, m_ByEdge.try_emplace({position, after}, corner).first->second);
    }

private:
    void Join(std::size_t a, std::size_t b) { m_Parents[Find(a)] = Find(b); }

    std::vector<std::size_t> m_Parents;
    std::map<std::uint32_t, std::size_t> m_ByVertex;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> m_ByEdge;
};

double AngleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::vector<Corner> CollectCorners(const MeshData& data, CornerGroups& groups)
{
    const std::vector<std::uint32_t> welded = Weld(data.vertices);
    std::vector<Corner> corners;
    for (std::size_t i = 0; i + 2 < data.triangles.size(); i += 3)
    {
        const std::array<std::uint32_t, 3> v = {data.triangles[i], data.triangles[i + 1],
                                                data.triangles[i + 2]};
        std::array<glm::dvec3, 3> p;
        std::transform(v.begin(), v.end(), p.begin(),
                       [&](std::uint32_t index) { return glm::dvec3(data.vertices[index]); });
        const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double area = glm::length(normal);
        for (std::size_t c = 0; area > 0.0 && c < 3; ++c)
        {
            const std::size_t after = (c + 1) % 3;
            const std::size_t before = (c + 2) % 3;
            corners.push_back(
                {v[c], normal / area, AngleBetween(p[after] - p[c], p[before] - p[c])});
            groups.Add(v[c], welded[v[c]], welded[v[before]], welded[v[after]]);
        }
    }
    return corners;
}

/// The mean of the corners' normals, lengthened so that it reaches all their planes moved by 1.
glm::vec3 Miter(const std::vector<const Corner*>& corners)
{
    glm::dvec3 sum(0.0);
    double angles = 0.0;
    for (const Corner* corner : corners)
    {
        sum += corner->angle * corner->faceNormal;
        angles += corner->angle;
    }
    const double length = glm::length(sum);
    if (!(length > 1e-6 * angles))
    {
        return glm::vec3(0.0f);
    }
    const glm::dvec3 direction = sum / length;
    double cosine = 1.0;
    for (const Corner* corner : corners)
    {
        cosine = std::min(cosine, glm::dot(direction, corner->faceNormal));
    }
    const double limit = k_OutlineMiterLimit;
    return glm::vec3(direction * (cosine * limit > 1.0 ? 1.0 / cosine : limit));
}

} // namespace

std::vector<glm::vec3> BakeOutlineNormals(const Mesh& mesh)
{
    const MeshData& data = mesh.data();
    CornerGroups groups;
    const std::vector<Corner> corners = CollectCorners(data, groups);
    std::map<std::size_t, std::vector<const Corner*>> members;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        members[groups.Find(i)].push_back(&corners[i]);
    }
    std::vector<glm::vec3> result(data.vertices.size(), glm::vec3(0.0f));
    for (const auto& [group, list] : members)
    {
        const glm::vec3 miter = Miter(list);
        for (const Corner* corner : list)
        {
            result[corner->vertex] = miter;
        }
    }
    return result;
}

std::shared_ptr<const Mesh> WithOutlineNormals(const Mesh& mesh)
{
    MeshData data = mesh.data();
    data.uv8 = BakeOutlineNormals(mesh);
    return std::make_shared<const Mesh>(mesh.name(), std::move(data));
}

} // namespace limn

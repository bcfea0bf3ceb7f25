#include <limn/volume/Collider.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <limn/base/Diagnostic.h>

namespace limn
{

namespace
{

using Triangle = std::array<glm::dvec3, 3>;

/// The distance, relative to the mesh's size, by which a vertex may stand out, because vertices are
/// floats.
constexpr double k_Tolerance = 1e-4;

Triangle TriangleAt(const Mesh& mesh, std::size_t first, const glm::dvec3& scale)
{
    const MeshData& data = mesh.data();
    Triangle triangle;
    for (std::size_t i = 0; i < triangle.size(); ++i)
    {
        triangle[i] = scale * glm::dvec3(data.vertices[data.triangles[first + i]]);
    }
    return triangle;
}

/// Returns a normal as long as twice the triangle's area.
glm::dvec3 NormalOf(const Triangle& triangle)
{
    return glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
}

/// Returns whether all vertices are on one side of the triangle, as far as floats can tell.
bool IsOnTheHull(const Mesh& mesh, const Triangle& triangle, double tolerance)
{
    const glm::dvec3 normal = NormalOf(triangle);
    const double length = glm::length(normal);
    double lowest = 0.0;
    double highest = 0.0;
    for (const glm::vec3& vertex : mesh.data().vertices)
    {
        const double height = glm::dot(normal, glm::dvec3(vertex) - triangle[0]);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    return std::min(-lowest, highest) <= tolerance * length;
}

glm::dvec3 ClosestOnSegment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& point)
{
    const glm::dvec3 edge = b - a;
    const double length2 = glm::dot(edge, edge);
    const double along =
        length2 > 0.0 ? std::clamp(glm::dot(point - a, edge) / length2, 0.0, 1.0) : 0.0;
    return a + edge * along;
}

bool IsAbove(const Triangle& triangle, const glm::dvec3& normal, const glm::dvec3& point)
{
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec3 edge = triangle[(i + 1) % 3] - triangle[i];
        if (glm::dot(glm::cross(normal, edge), point - triangle[i]) < 0.0)
        {
            return false;
        }
    }
    return true;
}

glm::dvec3 ClosestOnTriangle(const Triangle& triangle, const glm::dvec3& point)
{
    const glm::dvec3 normal = NormalOf(triangle);
    const double length2 = glm::dot(normal, normal);
    if (length2 > 0.0 && IsAbove(triangle, normal, point))
    {
        return point - normal * (glm::dot(normal, point - triangle[0]) / length2);
    }
    glm::dvec3 closest = triangle[0];
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec3 found = ClosestOnSegment(triangle[i], triangle[(i + 1) % 3], point);
        if (glm::distance(found, point) < glm::distance(closest, point))
        {
            closest = found;
        }
    }
    return closest;
}

/// Returns whether a mesh is flat at a triangle, as far as floats can tell, whatever its size.
/// @param normal  as long as an area
/// @param inward  how far the mesh's middle is from the triangle's plane, times that area
bool IsThin(const glm::dvec3& normal, double inward)
{
    return std::abs(inward) <= 1e-9 * std::pow(glm::length(normal), 1.5);
}

/// Returns whether the point is on the inner side of the triangle's plane. A flat mesh has no inner
/// side.
bool IsBehind(const Triangle& triangle, const glm::dvec3& point, const glm::dvec3& middle)
{
    const glm::dvec3 normal = NormalOf(triangle);
    const double inward = glm::dot(normal, middle - triangle[0]);
    const double height = glm::dot(normal, point - triangle[0]);
    return glm::dot(normal, normal) == 0.0 ||
           (!IsThin(normal, inward) && (inward > 0.0 ? height >= 0.0 : height <= 0.0));
}

/// Returns the middle of the vertices, which is inside a convex mesh.
glm::dvec3 MiddleOf(const Mesh& mesh)
{
    glm::dvec3 sum(0.0);
    for (const glm::vec3& vertex : mesh.data().vertices)
    {
        sum += glm::dvec3(vertex);
    }
    return sum / static_cast<double>(mesh.data().vertices.size());
}

/// Returns whether the triangles form a closed surface, whose areas, as vectors pointing outwards,
/// cancel out. A flat mesh encloses nothing that could be open.
bool IsClosed(const Mesh& mesh)
{
    const glm::dvec3 middle = MiddleOf(mesh);
    glm::dvec3 sum(0.0);
    double area = 0.0;
    bool isFlat = true;
    for (std::size_t first = 0; first < mesh.data().triangles.size(); first += 3)
    {
        const Triangle triangle = TriangleAt(mesh, first, glm::dvec3(1.0));
        const glm::dvec3 normal = NormalOf(triangle);
        const double inward = glm::dot(normal, middle - triangle[0]);
        sum += inward > 0.0 ? -normal : normal;
        area += glm::length(normal);
        isFlat = isFlat && IsThin(normal, inward);
    }
    return isFlat || glm::length(sum) <= k_Tolerance * area;
}

} // namespace

MeshCollider::MeshCollider(std::shared_ptr<const Mesh> mesh) : m_Mesh(std::move(mesh))
{
    if (!m_Mesh)
    {
        throw ContractError("a mesh collider needs a mesh");
    }
    const std::string subject = "the mesh '" + m_Mesh->name() + "' cannot be a collider: it ";
    const std::size_t count = m_Mesh->data().triangles.size();
    if (count == 0)
    {
        throw ContractError(subject + "has no triangle");
    }
    const double tolerance = k_Tolerance * glm::length(glm::dvec3(m_Mesh->bounds().extents));
    for (std::size_t first = 0; first < count; first += 3)
    {
        if (!IsOnTheHull(*m_Mesh, TriangleAt(*m_Mesh, first, glm::dvec3(1.0)), tolerance))
        {
            throw ContractError(subject + "is not convex, its triangle " +
                                std::to_string(first / 3) + " has vertices on both sides");
        }
    }
    if (!IsClosed(*m_Mesh))
    {
        throw ContractError(subject + "is open, its triangles do not enclose a space");
    }
}

glm::dvec3 MeshCollider::ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                                      const glm::quat& rotation, const glm::vec3& scale) const
{
    const glm::dquat turn = glm::normalize(glm::dquat(rotation));
    const glm::dvec3 inMesh = glm::conjugate(turn) * (glm::dvec3(point) - glm::dvec3(position));
    const glm::dvec3 scaling(scale);
    const glm::dvec3 middle = scaling * MiddleOf(*m_Mesh);
    bool isInside = true;
    glm::dvec3 closest(0.0);
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t first = 0; first < m_Mesh->data().triangles.size(); first += 3)
    {
        const Triangle triangle = TriangleAt(*m_Mesh, first, scaling);
        isInside = isInside && IsBehind(triangle, inMesh, middle);
        const glm::dvec3 found = ClosestOnTriangle(triangle, inMesh);
        if (const double distance = glm::distance(found, inMesh); distance < shortest)
        {
            shortest = distance;
            closest = found;
        }
    }
    const bool isThere = shortest == 0.0 || (isInside && shortest < 1e300);
    return isThere ? glm::dvec3(point) : glm::dvec3(position) + turn * closest;
}

} // namespace limn

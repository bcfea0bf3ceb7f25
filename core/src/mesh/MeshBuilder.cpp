#include "mesh/MeshBuilder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace limn
{

namespace
{

constexpr double k_TwoPi = 6.283185307179586;

/// Direction of the u-th part of a turn around y; a whole turn is exactly where it began, so that
/// the seam closes.
glm::vec3 DirectionAt(int step, int segments)
{
    const double angle = k_TwoPi * (step % segments) / segments;
    return {-std::sin(angle), 0.0, std::cos(angle)};
}

glm::vec3 TangentAt(double step, int segments)
{
    const double angle = k_TwoPi * step / segments;
    return {-std::cos(angle), 0.0, -std::sin(angle)};
}

PrimitiveVertex VertexAt(const ProfilePoint& point, int step, int segments)
{
    // A pole is one vertex a triangle, with the direction of that triangle's middle. The last one,
    // which no triangle uses, keeps the rows equally long.
    const double middle = point.radius == 0.0f ? std::min(step, segments - 1) + 0.5 : step;
    const glm::vec3 out = DirectionAt(step, segments);
    return {{point.radius * out.x, point.y, point.radius * out.z},
            {point.normal.x * out.x, point.normal.y, point.normal.x * out.z},
            TangentAt(middle, segments),
            {static_cast<float>(middle / segments), point.v}};
}

} // namespace

std::uint32_t MeshBuilder::AddVertex(const PrimitiveVertex& vertex)
{
    m_Data.vertices.push_back(vertex.position);
    m_Data.normals.push_back(vertex.normal);
    // cross(normal, tangent) points down the picture on every shape; the bitangent is its opposite.
    m_Data.tangents.emplace_back(vertex.tangent, -1.0f);
    // Shapes are built reading their picture from the top; a mesh's v counts from its bottom.
    m_Data.uv.emplace_back(vertex.uv.x, 1.0f - vertex.uv.y);
    return static_cast<std::uint32_t>(m_Data.vertices.size() - 1);
}

void MeshBuilder::AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    m_Data.triangles.insert(m_Data.triangles.end(), {a, b, c});
}

void MeshBuilder::AddGrid(glm::vec3 center, glm::vec3 right, glm::vec3 up, int cells)
{
    const auto first = static_cast<std::uint32_t>(m_Data.vertices.size());
    const glm::vec3 tangent = glm::normalize(right);
    const glm::vec3 normal = glm::normalize(glm::cross(up, right));
    const auto count = static_cast<float>(cells);
    for (int row = 0; row <= cells; ++row)
    {
        for (int column = 0; column <= cells; ++column)
        {
            const glm::vec2 uv{static_cast<float>(column) / count, static_cast<float>(row) / count};
            const glm::vec3 offset = right * (2.0f * uv.x - 1.0f) + up * (1.0f - 2.0f * uv.y);
            AddVertex({center + offset, normal, tangent, uv});
        }
    }
    const auto stride = static_cast<std::uint32_t>(cells) + 1;
    for (std::uint32_t row = 0; row + 1 < stride; ++row)
    {
        for (std::uint32_t column = 0; column + 1 < stride; ++column)
        {
            const std::uint32_t corner = first + row * stride + column;
            AddTriangle(corner, corner + 1, corner + stride + 1);
            AddTriangle(corner, corner + stride + 1, corner + stride);
        }
    }
}

void MeshBuilder::AddRevolution(const std::vector<ProfilePoint>& profile, int segments)
{
    const auto first = static_cast<std::uint32_t>(m_Data.vertices.size());
    for (const ProfilePoint& point : profile)
    {
        for (int step = 0; step <= segments; ++step)
        {
            AddVertex(VertexAt(point, step, segments));
        }
    }
    const auto stride = static_cast<std::uint32_t>(segments) + 1;
    for (std::uint32_t row = 0; row + 1 < profile.size(); ++row)
    {
        for (std::uint32_t step = 0; step + 1 < stride; ++step)
        {
            const std::uint32_t corner = first + row * stride + step;
            const bool endsInPole = profile[row + 1].radius == 0.0f;
            if (profile[row].radius > 0.0f)
            {
                AddTriangle(corner, corner + 1, corner + stride + (endsInPole ? 0 : 1));
            }
            if (!endsInPole)
            {
                AddTriangle(corner, corner + stride + 1, corner + stride);
            }
        }
    }
}

void MeshBuilder::AddDisc(float radius, float y, float side, int segments)
{
    const glm::vec3 normal{0.0f, side, 0.0f};
    const glm::vec3 right{1.0f, 0.0f, 0.0f};
    const auto add = [&](glm::vec3 out)
    {
        const glm::vec2 uv{0.5f + 0.5f * out.x, 0.5f - 0.5f * side * out.z};
        return AddVertex({{radius * out.x, y, radius * out.z}, normal, right, uv});
    };
    const std::uint32_t middle = add(glm::vec3(0.0f));
    for (int step = 0; step < segments; ++step)
    {
        add(DirectionAt(step, segments));
    }
    const auto count = static_cast<std::uint32_t>(segments);
    for (std::uint32_t step = 0; step < count; ++step)
    {
        const std::uint32_t a = middle + 1 + step;
        const std::uint32_t b = middle + 1 + (step + 1) % count;
        side > 0.0f ? AddTriangle(middle, b, a) : AddTriangle(middle, a, b);
    }
}

} // namespace limn

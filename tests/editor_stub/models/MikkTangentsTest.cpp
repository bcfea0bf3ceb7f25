#include "models/MikkTangents.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

/// Triangles of a plane with the normal +z.
MeshData FlatMesh(const std::vector<glm::vec2>& positions, const std::vector<glm::vec2>& uv,
                  const std::vector<std::uint32_t>& triangles)
{
    MeshData data;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        data.vertices.emplace_back(positions[i], 0.0f);
        data.normals.emplace_back(0.0f, 0.0f, 1.0f);
    }
    data.uv = uv;
    data.triangles = triangles;
    return data;
}

void ExpectTangent(const glm::vec4& tangent, const glm::dvec3& direction, float side)
{
    const glm::dvec3 expected = glm::normalize(direction);
    EXPECT_NEAR(tangent.x, expected.x, 1e-6);
    EXPECT_NEAR(tangent.y, expected.y, 1e-6);
    EXPECT_NEAR(tangent.z, expected.z, 1e-6);
    EXPECT_EQ(tangent.w, side);
}

/// The derivatives of the position by u and v: the solution of two linear equations.
std::pair<glm::dvec3, glm::dvec3> DerivativesOf(const MeshData& data, std::size_t first)
{
    const auto at = [&](std::size_t i)
    {
        return data.triangles[first + i];
    };
    const glm::dvec3 e1 = glm::dvec3(data.vertices[at(1)]) - glm::dvec3(data.vertices[at(0)]);
    const glm::dvec3 e2 = glm::dvec3(data.vertices[at(2)]) - glm::dvec3(data.vertices[at(0)]);
    const glm::dvec2 d1 = glm::dvec2(data.uv[at(1)]) - glm::dvec2(data.uv[at(0)]);
    const glm::dvec2 d2 = glm::dvec2(data.uv[at(2)]) - glm::dvec2(data.uv[at(0)]);
    const double determinant = d1.x * d2.y - d2.x * d1.y;
    return {(d2.y * e1 - d1.y * e2) / determinant, (d1.x * e2 - d2.x * e1) / determinant};
}

TEST(MikkTangents, PointToLargerU)
{
    // u grows upwards, v to the left.
    MeshData data = FlatMesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {0, 0}, {1, 0}, {1, 1}},
                             {0, 1, 2, 0, 2, 3});
    ComputeMikkTangents(data);
    ASSERT_EQ(data.tangents.size(), 4u);
    for (const glm::vec4& tangent : data.tangents)
    {
        ExpectTangent(tangent, {0, 1, 0}, 1.0f); // cross(+z, +y) is -x, where v grows
    }
}

TEST(MikkTangents, SplitVerticesWhereUvAreMirrored)
{
    // Two squares; u grows to the edge they share from both sides.
    MeshData data = FlatMesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}},
                             {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {0, 1}},
                             {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2});
    data.colors.assign(6, glm::vec4(0.5f));
    data.colors[1] = glm::vec4(0.25f);
    ComputeMikkTangents(data);
    ASSERT_EQ(data.vertices.size(), 8u) << "the two of the edge are there twice";
    ASSERT_EQ(data.tangents.size(), 8u);
    EXPECT_EQ(data.normals.size(), 8u);
    EXPECT_EQ(data.uv.size(), 8u);
    ASSERT_EQ(data.colors.size(), 8u);
    for (std::size_t i = 0; i < data.triangles.size(); ++i)
    {
        const bool isLeft = i < 6;
        ExpectTangent(data.tangents[data.triangles[i]], {isLeft ? 1 : -1, 0, 0},
                      isLeft ? 1.0f : -1.0f);
        const glm::vec3& place = data.vertices[data.triangles[i]];
        EXPECT_EQ(data.colors[data.triangles[i]].x, place == glm::vec3(1, 0, 0) ? 0.25f : 0.5f);
    }
}

TEST(MikkTangents, WeightTrianglesByTheirAngle)
{
    // Three triangles around a vertex, of 90, 45 and 60 degrees, each with uv of its own slant.
    const double a = std::acos(-1.0);
    const auto place = [&](double degrees)
    {
        return glm::vec2(std::cos(degrees * a / 180), std::sin(degrees * a / 180));
    };
    MeshData data = FlatMesh({{0, 0}, place(0), place(90), place(135), place(195)},
                             {{0.5f, 0.5f}, {1.0f, 0.5f}, {0.6f, 1.0f}, {0.1f, 0.8f}, {0.0f, 0.3f}},
                             {0, 1, 2, 0, 2, 3, 0, 3, 4});
    glm::dvec3 sum(0.0);
    for (const auto& [first, degrees] : {std::pair{0, 90.0}, {3, 45.0}, {6, 60.0}})
    {
        const auto along = DerivativesOf(data, static_cast<std::size_t>(first)).first;
        sum += degrees * glm::normalize(along);
    }
    ComputeMikkTangents(data);
    ASSERT_EQ(data.vertices.size(), 5u);
    ExpectTangent(data.tangents[0], sum, 1.0f);
}

TEST(MikkTangents, DoNotCrossASeamOfUvOrNormals)
{
    // The second triangle has vertices of its own at the shared edge, with other uv.
    MeshData data = FlatMesh({{0, 0}, {1, 0}, {0, 1}, {1, 0}, {1, 1}, {0, 1}},
                             {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0, 1}, {-1, 0}}, {0, 1, 2, 3, 4, 5});
    ComputeMikkTangents(data);
    EXPECT_EQ(data.vertices.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i)
    {
        const auto along = DerivativesOf(data, i / 3 * 3).first;
        ExpectTangent(data.tangents[i], along, 1.0f);
    }
}

TEST(MikkTangents, JoinVerticesThatAreEqual)
{
    // The same two triangles as one square, but each with vertices of its own.
    MeshData data =
        FlatMesh({{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}},
                 {{0, 0}, {1, 0}, {1.5f, 1}, {0, 0}, {1.5f, 1}, {0, 1}}, {0, 1, 2, 3, 4, 5});
    // At the corner (0, 0) both triangles have an angle of 45 degrees.
    const glm::dvec3 first = glm::normalize(DerivativesOf(data, 0).first);
    const glm::dvec3 second = glm::normalize(DerivativesOf(data, 3).first);
    ComputeMikkTangents(data);
    ExpectTangent(data.tangents[0], first + second, 1.0f);
    EXPECT_EQ(data.tangents[0], data.tangents[3]);
}

TEST(MikkTangents, TakeThoseOfANeighbourWhereTrianglesHaveNone)
{
    // The second triangle has no area in uv, the third none in space.
    MeshData data = FlatMesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                             {{0, 0}, {1, 0}, {1, 1}, {0.5f, 0.5f}}, {0, 1, 2, 0, 2, 3, 0, 0, 1});
    const glm::dvec3 along = DerivativesOf(data, 0).first;
    ComputeMikkTangents(data);
    EXPECT_EQ(data.vertices.size(), 4u);
    for (const std::size_t vertex : {0u, 1u, 2u})
    {
        ExpectTangent(data.tangents[vertex], along, 1.0f);
    }
    for (const glm::vec4& tangent : data.tangents)
    {
        EXPECT_TRUE(std::isfinite(tangent.x + tangent.y + tangent.z));
        EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1.0f, 1e-5f);
    }
}

TEST(MikkTangents, StandUprightOnACurvedMesh)
{
    MeshData data;
    constexpr int k_Rings = 8;
    constexpr int k_Segments = 12;
    for (int ring = 0; ring <= k_Rings; ++ring)
    {
        for (int segment = 0; segment <= k_Segments; ++segment)
        {
            const double polar = 0.4 + 2.2 * ring / k_Rings;
            const double around = 2.0 * std::acos(-1.0) * segment / k_Segments;
            const glm::dvec3 normal(std::sin(polar) * std::cos(around), std::cos(polar),
                                    std::sin(polar) * std::sin(around));
            data.normals.emplace_back(normal);
            data.vertices.emplace_back(2.0 * normal);
            data.uv.emplace_back(3.0 * segment / k_Segments, 1.0 - 1.0 * ring / k_Rings);
        }
    }
    for (std::uint32_t ring = 0; ring < k_Rings; ++ring)
    {
        for (std::uint32_t segment = 0; segment < k_Segments; ++segment)
        {
            const std::uint32_t i = ring * (k_Segments + 1) + segment;
            const std::uint32_t below = i + k_Segments + 1;
            data.triangles.insert(data.triangles.end(), {i, below + 1, below, i, i + 1, below + 1});
        }
    }
    ComputeMikkTangents(data);
    EXPECT_EQ(data.vertices.size(), static_cast<std::size_t>((k_Rings + 1) * (k_Segments + 1)));
    for (std::size_t i = 0; i < data.triangles.size(); ++i)
    {
        const std::uint32_t vertex = data.triangles[i];
        const glm::dvec3 normal(data.normals[vertex]);
        const glm::dvec3 tangent(data.tangents[vertex]);
        const auto [alongU, alongV] = DerivativesOf(data, i / 3 * 3);
        // A triangle near a pole leans by up to 30 degrees against the surface.
        EXPECT_NEAR(glm::dot(normal, tangent), 0.0, 1e-5);
        EXPECT_GT(glm::dot(tangent, glm::normalize(alongU)), 0.8);
        const double side = data.tangents[vertex].w;
        EXPECT_GT(glm::dot(glm::cross(normal, tangent) * side, glm::normalize(alongV)), 0.8);
    }
}

TEST(MikkTangents, AreNoneWithoutNormalsOrUv)
{
    MeshData data = FlatMesh({{0, 0}, {1, 0}, {0, 1}}, {}, {0, 1, 2});
    data.tangents.assign(3, glm::vec4(0.0f));
    ComputeMikkTangents(data);
    EXPECT_TRUE(data.tangents.empty());
}

} // namespace
} // namespace limn::test

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limn/core/PrimitiveMesh.h>
#include <map>

namespace limn
{
namespace
{

constexpr double k_Pi = 3.14159265358979;

struct Shape
{
    PrimitiveType type;
    const char* name;
    glm::vec3 extents; ///< half of Unity's size
    double volume;     ///< closed form
    double area;       ///< closed form
    bool isFlat;       ///< planes only, so that the tessellation costs nothing
    /// How far a point is from the true surface.
    std::function<double(glm::dvec3)> distance;
};

double DistanceToBox(glm::dvec3 p, double half)
{
    const glm::dvec3 a = glm::abs(p);
    return std::abs(std::max({a.x, a.y, a.z}) - half);
}

double DistanceToCapsule(glm::dvec3 p)
{
    const glm::dvec3 onAxis(0.0, std::clamp(p.y, -0.5, 0.5), 0.0);
    return std::abs(glm::length(p - onAxis) - 0.5);
}

double DistanceToCylinder(glm::dvec3 p)
{
    const double side = std::hypot(p.x, p.z) - 0.5;
    return std::abs(std::max(side, std::abs(p.y) - 1.0));
}

double DistanceToTorus(glm::dvec3 p)
{
    return std::abs(std::hypot(std::hypot(p.x, p.z) - 0.5, p.y) - 0.125);
}

const std::vector<Shape>& ClosedShapes()
{
    static const std::vector<Shape> shapes = {
        {PrimitiveType::Sphere,
         "sphere",
         {0.5, 0.5, 0.5},
         k_Pi / 6,
         k_Pi,
         false,
         [](glm::dvec3 p)
         {
             return std::abs(glm::length(p) - 0.5);
         }},
        {PrimitiveType::Capsule,
         "capsule",
         {0.5, 1.0, 0.5},
         k_Pi / 6 + k_Pi / 4,
         2 * k_Pi,
         false,
         DistanceToCapsule},
        {PrimitiveType::Cylinder,
         "cylinder",
         {0.5, 1.0, 0.5},
         k_Pi / 2,
         2.5 * k_Pi,
         false,
         DistanceToCylinder},
        {PrimitiveType::Cube,
         "cube",
         {0.5, 0.5, 0.5},
         1.0,
         6.0,
         true,
         [](glm::dvec3 p)
         {
             return DistanceToBox(p, 0.5);
         }},
        {PrimitiveType::Torus,
         "torus",
         {0.625, 0.125, 0.625},
         2 * k_Pi * k_Pi * 0.5 / 64,
         4 * k_Pi * k_Pi * 0.5 * 0.125,
         false,
         DistanceToTorus},
    };
    return shapes;
}

std::vector<Shape> AllShapes()
{
    std::vector<Shape> shapes = ClosedShapes();
    shapes.push_back({PrimitiveType::Plane,
                      "plane",
                      {5, 0, 5},
                      0.0,
                      100.0,
                      true,
                      [](glm::dvec3 p)
                      {
                          return std::abs(p.y);
                      }});
    shapes.push_back({PrimitiveType::Quad,
                      "quad",
                      {0.5, 0.5, 0},
                      0.0,
                      1.0,
                      true,
                      [](glm::dvec3 p)
                      {
                          return std::abs(p.z);
                      }});
    return shapes;
}

/// Calls back with the three vertex indices of every triangle.
template <typename Callback>
void ForEachTriangle(const Mesh& mesh, Callback&& callback)
{
    const std::vector<std::uint32_t>& indices = mesh.data().triangles;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    {
        callback(std::array<std::uint32_t, 3>{indices[i], indices[i + 1], indices[i + 2]});
    }
}

glm::dvec3 PositionOf(const Mesh& mesh, std::uint32_t index)
{
    return glm::dvec3(mesh.data().vertices.at(index));
}

/// Twice the area long. In a left-handed space it points at the viewer of a clockwise triangle.
glm::dvec3 FaceVector(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners)
{
    const glm::dvec3 a = PositionOf(mesh, corners[0]);
    return glm::cross(PositionOf(mesh, corners[1]) - a, PositionOf(mesh, corners[2]) - a);
}

using WeldedPoint = std::array<long, 3>;

WeldedPoint Weld(glm::dvec3 p)
{
    return {std::lround(p.x * 1e5), std::lround(p.y * 1e5), std::lround(p.z * 1e5)};
}

TEST(PrimitiveMesh, HasUnitysSizeAndIsCentred)
{
    for (const Shape& shape : AllShapes())
    {
        const Bounds bounds = CreatePrimitive(shape.type)->bounds();
        EXPECT_LT(glm::length(bounds.center), 1e-6f) << shape.name;
        EXPECT_LT(glm::length(bounds.extents - shape.extents), 1e-6f) << shape.name;
    }
}

TEST(PrimitiveMesh, LiesOnTheSurfaceOfItsShape)
{
    for (const Shape& shape : AllShapes())
    {
        const auto mesh = CreatePrimitive(shape.type);
        for (const glm::vec3& vertex : mesh->data().vertices)
        {
            EXPECT_LT(shape.distance(glm::dvec3(vertex)), 1e-6) << shape.name;
        }
    }
}

TEST(PrimitiveMesh, IsClosedWithEachEdgeSharedByTwoOppositeTriangles)
{
    for (const Shape& shape : ClosedShapes())
    {
        const auto mesh = CreatePrimitive(shape.type);
        std::map<std::pair<WeldedPoint, WeldedPoint>, int> edges;
        ForEachTriangle(*mesh,
                        [&](const std::array<std::uint32_t, 3>& corners)
                        {
                            for (std::size_t i = 0; i < 3; ++i)
                            {
                                ++edges[{Weld(PositionOf(*mesh, corners[i])),
                                         Weld(PositionOf(*mesh, corners[(i + 1) % 3]))}];
                            }
                        });
        for (const auto& [edge, count] : edges)
        {
            EXPECT_NE(edge.first, edge.second) << shape.name;
            EXPECT_EQ(count, 1) << shape.name;
            EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << shape.name;
        }
    }
}

TEST(PrimitiveMesh, EnclosesTheVolumeOfItsShape)
{
    for (const Shape& shape : ClosedShapes())
    {
        const auto mesh = CreatePrimitive(shape.type);
        double volume = 0.0;
        ForEachTriangle(
            *mesh,
            [&](const std::array<std::uint32_t, 3>& corners) {
                volume += glm::dot(PositionOf(*mesh, corners[0]), FaceVector(*mesh, corners)) / 6.0;
            });
        const double tolerance = shape.isFlat ? 1e-6 : 0.04;
        EXPECT_NEAR(volume / shape.volume, 1.0, tolerance) << shape.name;
    }
}

TEST(PrimitiveMesh, HasTheAreaOfItsShapeAndNoEmptyTriangle)
{
    for (const Shape& shape : AllShapes())
    {
        const auto mesh = CreatePrimitive(shape.type);
        double area = 0.0;
        ForEachTriangle(*mesh,
                        [&](const std::array<std::uint32_t, 3>& corners)
                        {
                            const double triangle = glm::length(FaceVector(*mesh, corners)) / 2.0;
                            EXPECT_GT(triangle, 1e-6) << shape.name;
                            area += triangle;
                        });
        const double tolerance = shape.isFlat ? 1e-6 : 0.04;
        EXPECT_NEAR(area / shape.area, 1.0, tolerance) << shape.name;
    }
}

TEST(PrimitiveMesh, HasUnitNormalsThatPointAwayFromTheSurface)
{
    for (const Shape& shape : ClosedShapes())
    {
        const MeshData data = CreatePrimitive(shape.type)->data();
        ASSERT_EQ(data.normals.size(), data.vertices.size()) << shape.name;
        for (std::size_t i = 0; i < data.vertices.size(); ++i)
        {
            const glm::dvec3 normal(data.normals[i]);
            EXPECT_NEAR(glm::length(normal), 1.0, 1e-6) << shape.name;
            // A step along the true normal of a smooth or flat surface goes its full length away.
            const glm::dvec3 moved = glm::dvec3(data.vertices[i]) + 0.01 * normal;
            EXPECT_NEAR(shape.distance(moved), 0.01, 1e-5) << shape.name << " vertex " << i;
        }
    }
}

TEST(PrimitiveMesh, WindsItsTrianglesClockwiseAsSeenFromOutside)
{
    for (const Shape& shape : AllShapes())
    {
        const auto mesh = CreatePrimitive(shape.type);
        ForEachTriangle(*mesh,
                        [&](const std::array<std::uint32_t, 3>& corners)
                        {
                            const glm::dvec3 face = glm::normalize(FaceVector(*mesh, corners));
                            for (const std::uint32_t corner : corners)
                            {
                                const glm::dvec3 normal(mesh->data().normals[corner]);
                                EXPECT_GT(glm::dot(face, normal), 0.8) << shape.name;
                            }
                        });
    }
}

TEST(PrimitiveMesh, HasUnitTangentsAcrossTheNormals)
{
    for (const Shape& shape : AllShapes())
    {
        const MeshData data = CreatePrimitive(shape.type)->data();
        ASSERT_EQ(data.tangents.size(), data.vertices.size()) << shape.name;
        for (std::size_t i = 0; i < data.vertices.size(); ++i)
        {
            const glm::dvec3 tangent(data.tangents[i]);
            EXPECT_NEAR(glm::length(tangent), 1.0, 1e-6) << shape.name;
            EXPECT_NEAR(glm::dot(tangent, glm::dvec3(data.normals[i])), 0.0, 1e-6) << shape.name;
            EXPECT_EQ(std::abs(data.tangents[i].w), 1.0f) << shape.name;
        }
    }
}

/// How the position changes with u and v over a triangle, solved from its three corners.
std::array<glm::dvec3, 2> PositionPerUv(const Mesh& mesh,
                                        const std::array<std::uint32_t, 3>& corner)
{
    const std::vector<glm::vec2>& uv = mesh.data().uv;
    const glm::dvec3 p1 = PositionOf(mesh, corner[1]) - PositionOf(mesh, corner[0]);
    const glm::dvec3 p2 = PositionOf(mesh, corner[2]) - PositionOf(mesh, corner[0]);
    const glm::dvec2 t1 = glm::dvec2(uv.at(corner[1])) - glm::dvec2(uv.at(corner[0]));
    const glm::dvec2 t2 = glm::dvec2(uv.at(corner[2])) - glm::dvec2(uv.at(corner[0]));
    const double determinant = t1.x * t2.y - t2.x * t1.y;
    return {(p1 * t2.y - p2 * t1.y) / determinant, (p2 * t1.x - p1 * t2.x) / determinant};
}

TEST(PrimitiveMesh, HasTangentsTowardsLargerUAndBitangentsTowardsLargerV)
{
    for (const Shape& shape : AllShapes())
    {
        const auto mesh = CreatePrimitive(shape.type);
        ForEachTriangle(*mesh,
                        [&](const std::array<std::uint32_t, 3>& corners)
                        {
                            const auto [perU, perV] = PositionPerUv(*mesh, corners);
                            for (const std::uint32_t corner : corners)
                            {
                                const glm::dvec4 tangent(mesh->data().tangents[corner]);
                                const glm::dvec3 normal(mesh->data().normals[corner]);
                                const glm::dvec3 bitangent =
                                    glm::cross(normal, glm::dvec3(tangent)) * tangent.w;
                                EXPECT_GT(glm::dot(glm::normalize(perU), glm::dvec3(tangent)), 0.99)
                                    << shape.name;
                                EXPECT_GT(glm::dot(glm::normalize(perV), bitangent), 0.95)
                                    << shape.name;
                            }
                        });
    }
}

TEST(PrimitiveMesh, KeepsUvInsideThePicture)
{
    for (const Shape& shape : AllShapes())
    {
        const auto mesh = CreatePrimitive(shape.type);
        ASSERT_EQ(mesh->data().uv.size(), mesh->data().vertices.size()) << shape.name;
        for (const glm::vec2& uv : mesh->data().uv)
        {
            EXPECT_TRUE(uv.x >= 0.0f && uv.x <= 1.0f && uv.y >= 0.0f && uv.y <= 1.0f) << shape.name;
        }
    }
}

TEST(PrimitiveMesh, ShowsAPictureUprightOnTheQuadsFrontAtMinusZ)
{
    const MeshData data = CreatePrimitive(PrimitiveType::Quad)->data();
    ASSERT_EQ(data.vertices.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
    {
        EXPECT_EQ(data.normals[i], glm::vec3(0, 0, -1));
        EXPECT_EQ(data.tangents[i], glm::vec4(1, 0, 0, -1));
        EXPECT_EQ(data.uv[i], glm::vec2(data.vertices[i].x + 0.5f, data.vertices[i].y + 0.5f));
    }
}

TEST(PrimitiveMesh, DividesThePlaneIntoTenByTenCellsFacingUp)
{
    const MeshData data = CreatePrimitive(PrimitiveType::Plane)->data();
    EXPECT_EQ(data.vertices.size(), 11u * 11u);
    EXPECT_EQ(data.triangles.size(), 10u * 10u * 2u * 3u);
    for (const glm::vec3& normal : data.normals)
    {
        EXPECT_EQ(normal, glm::vec3(0, 1, 0));
    }
}

TEST(PrimitiveMesh, HasNamesThatLeadBackToTheTypes)
{
    for (const Shape& shape : AllShapes())
    {
        EXPECT_EQ(PrimitiveTypeFromName(shape.name), shape.type);
        EXPECT_EQ(CreatePrimitive(shape.type)->name(), shape.name);
    }
    EXPECT_EQ(PrimitiveTypeNames(),
              (std::vector<std::string_view>{"sphere", "capsule", "cylinder", "cube", "plane",
                                             "quad", "torus"}));
}

TEST(PrimitiveMesh, IsFoundByNameWhateverTheCase)
{
    EXPECT_EQ(PrimitiveTypeFromName("Cube"), PrimitiveType::Cube);
    EXPECT_EQ(PrimitiveTypeFromName("TORUS"), PrimitiveType::Torus);
}

TEST(PrimitiveMesh, IsNotFoundByAnotherName)
{
    EXPECT_EQ(PrimitiveTypeFromName("teapot"), std::nullopt);
    EXPECT_EQ(PrimitiveTypeFromName("cub"), std::nullopt);
    EXPECT_EQ(PrimitiveTypeFromName("cubes"), std::nullopt);
    EXPECT_EQ(PrimitiveTypeFromName(""), std::nullopt);
}

} // namespace
} // namespace limn

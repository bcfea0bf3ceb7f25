#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limn/core/OutlineNormals.h>
#include <limn/core/PrimitiveMesh.h>

namespace limn
{
namespace
{

constexpr float k_Exact = 1e-6f;

void ExpectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance = k_Exact)
{
    EXPECT_LE(glm::length(actual - expected), tolerance)
        << actual.x << ", " << actual.y << ", " << actual.z << " instead of " << expected.x << ", "
        << expected.y << ", " << expected.z;
}

Mesh MakeMesh(std::vector<glm::vec3> vertices, std::vector<std::uint32_t> triangles)
{
    MeshData data;
    data.vertices = std::move(vertices);
    data.triangles = std::move(triangles);
    return Mesh("test", std::move(data));
}

/// A pyramid with its tip at the origin, opening towards -y over a square.
/// @param slope  half the side of the square at y = -1
MeshData Pyramid(float slope)
{
    MeshData data;
    data.vertices = {{0, 0, 0},
                     {-slope, -1, -slope},
                     {slope, -1, -slope},
                     {slope, -1, slope},
                     {-slope, -1, slope}};
    data.triangles = {0, 2, 1, 0, 3, 2, 0, 4, 3, 0, 1, 4, 1, 2, 3, 1, 3, 4};
    return data;
}

TEST(OutlineNormals, OfACubesCornersReachAllThreeSides)
{
    const auto cube = CreatePrimitive(PrimitiveType::Cube);
    const std::vector<glm::vec3> normals = BakeOutlineNormals(*cube);
    ASSERT_EQ(normals.size(), 24u);
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
        // The corners are at +-1/2, so twice the position is the expected vector.
        ExpectNear(normals[i], 2.0f * cube->data().vertices[i]);
        EXPECT_NEAR(glm::length(normals[i]), std::sqrt(3.0f), k_Exact);
    }
}

TEST(OutlineNormals, DoNotDependOnHowAFaceIsCutIntoTriangles)
{
    // Each face of the cube gets a vertex in its middle and four triangles instead of two.
    const MeshData cube = CreatePrimitive(PrimitiveType::Cube)->data();
    MeshData cut;
    cut.vertices = cube.vertices;
    for (std::uint32_t face = 0; face < 12; face += 2)
    {
        const auto corner = [&](std::uint32_t i)
        {
            return cube.triangles[face * 3 + i];
        };
        const std::uint32_t around[] = {corner(0), corner(1), corner(2), corner(5)};
        const auto middle = static_cast<std::uint32_t>(cut.vertices.size());
        cut.vertices.push_back(0.5f * (cube.vertices[corner(0)] + cube.vertices[corner(2)]));
        for (std::size_t i = 0; i < 4; ++i)
        {
            cut.triangles.insert(cut.triangles.end(), {around[i], around[(i + 1) % 4], middle});
        }
    }
    const std::vector<glm::vec3> normals = BakeOutlineNormals(Mesh("cut", cut));
    for (std::size_t i = 0; i < 24; ++i)
    {
        ExpectNear(normals[i], 2.0f * cut.vertices[i]);
    }
    for (std::size_t i = 24; i < normals.size(); ++i)
    {
        ExpectNear(normals[i], 2.0f * cut.vertices[i]); // in the middle of a face: its normal
    }
}

TEST(OutlineNormals, OfASpherePointOutwardsAndCloseItsSeam)
{
    const auto sphere = CreatePrimitive(PrimitiveType::Sphere);
    const std::vector<glm::vec3> normals = BakeOutlineNormals(*sphere);
    for (const std::uint32_t i : sphere->data().triangles)
    {
        const glm::vec3 outwards = glm::normalize(sphere->data().vertices[i]);
        ExpectNear(glm::normalize(normals[i]), outwards, 0.02f);
        EXPECT_GE(glm::length(normals[i]), 1.0f - k_Exact);
        EXPECT_LE(glm::length(normals[i]), 1.02f);
    }
}

TEST(OutlineNormals, OfANeedlesTipAreCutShortAtFour)
{
    // The sides of a pyramid of slope s are tilted against the axis by cos = s / sqrt(1 + s * s).
    ExpectNear(BakeOutlineNormals(Mesh("blunt", Pyramid(1.0f)))[0], {0, std::sqrt(2.0f), 0});
    ExpectNear(BakeOutlineNormals(Mesh("sharp", Pyramid(0.5f)))[0], {0, std::sqrt(5.0f), 0});
    ExpectNear(BakeOutlineNormals(Mesh("needle", Pyramid(0.01f)))[0], {0, 4, 0});
}

TEST(OutlineNormals, StandOnASliverAtItsSharpestCornerToo)
{
    // The angle at the origin is 1e-7, far below what would count as faces cancelling each other.
    const Mesh sliver = MakeMesh({{0, 0, 0}, {1e4f, 1e-3f, 0}, {1e4f, 0, 0}}, {0, 1, 2});
    for (const glm::vec3& normal : BakeOutlineNormals(sliver))
    {
        ExpectNear(normal, {0, 0, -1});
    }
}

TEST(OutlineNormals, LeaveTrianglesWithoutAreaOut)
{
    MeshData data = Pyramid(1.0f);
    data.vertices.push_back({0, 3, 0});
    data.triangles.insert(data.triangles.end(), {0, 0, 1, 0, 5, 0, 5, 5, 5, 0, 5, 5});
    const std::vector<glm::vec3> normals = BakeOutlineNormals(Mesh("degenerate", data));
    ExpectNear(normals[0], {0, std::sqrt(2.0f), 0});
    EXPECT_EQ(normals[5], glm::vec3(0.0f));
}

TEST(OutlineNormals, KeepShellsApartThatMerelyTouchInAPoint)
{
    MeshData data = Pyramid(1.0f);
    for (const glm::vec3& vertex : Pyramid(1.0f).vertices)
    {
        data.vertices.push_back({vertex.x, -vertex.y, -vertex.z}); // half a turn around x
    }
    for (const std::uint32_t index : Pyramid(1.0f).triangles)
    {
        data.triangles.push_back(index + 5);
    }
    const std::vector<glm::vec3> normals = BakeOutlineNormals(Mesh("two", data));
    ExpectNear(normals[0], {0, std::sqrt(2.0f), 0});
    ExpectNear(normals[5], {0, -std::sqrt(2.0f), 0});
}

TEST(OutlineNormals, AreZeroWhereTheFacesCancelEachOtherOut)
{
    const Mesh sheet = MakeMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 1});
    for (const glm::vec3& normal : BakeOutlineNormals(sheet))
    {
        EXPECT_EQ(normal, glm::vec3(0.0f));
    }
}

TEST(OutlineNormals, AreFiniteForTheSmallestAndLargestTriangles)
{
    for (const float size : {1e-18f, 1e-6f, 1e6f, 1e18f})
    {
        const Mesh mesh = MakeMesh({{0, 0, 0}, {0, size, 0}, {size, 0, 0}}, {0, 1, 2});
        for (const glm::vec3& normal : BakeOutlineNormals(mesh))
        {
            ExpectNear(normal, {0, 0, -1});
        }
    }
}

TEST(OutlineNormals, GoIntoTheSpareChannelOfANewMesh)
{
    const auto cube = CreatePrimitive(PrimitiveType::Cube);
    const auto baked = WithOutlineNormals(*cube);
    EXPECT_EQ(baked->name(), cube->name());
    EXPECT_NE(baked->id(), cube->id());
    EXPECT_EQ(baked->data().uv8, BakeOutlineNormals(*cube));
    EXPECT_EQ(baked->data().normals, cube->data().normals);
    EXPECT_TRUE(cube->data().uv8.empty());
}

} // namespace
} // namespace limn

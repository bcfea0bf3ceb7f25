#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <limn/base/Diagnostic.h>
#include <limn/core/Mesh.h>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

using test::Mentions;
using testing::ElementsAre;

/// Two triangles between x -1...3, y 0...2, at z = 5.
MeshData Square()
{
    MeshData data;
    data.vertices = {{-1, 0, 5}, {-1, 2, 5}, {3, 2, 5}, {3, 0, 5}};
    data.triangles = {0, 1, 2, 0, 2, 3};
    return data;
}

std::vector<std::string> ErrorsOf(MeshData data)
{
    return test::MessageLines(
        test::ThrownMessage<ContractError>([&] { Mesh("square", std::move(data)); }));
}

TEST(Mesh, KeepsItsArrays)
{
    MeshData data = Square();
    data.normals.assign(4, {0, 0, -1});
    data.colors.assign(4, {1, 0, 0, 1});
    const Mesh mesh("square", data);
    EXPECT_EQ(mesh.name(), "square");
    EXPECT_EQ(mesh.data().vertices, data.vertices);
    EXPECT_EQ(mesh.data().normals, data.normals);
    EXPECT_EQ(mesh.data().colors, data.colors);
    EXPECT_EQ(mesh.data().triangles, data.triangles);
    EXPECT_TRUE(mesh.data().uv.empty());
}

TEST(Mesh, HasOneSubMeshOverAllTrianglesUnlessToldOtherwise)
{
    const Mesh mesh("square", Square());
    ASSERT_EQ(mesh.subMeshCount(), 1);
    EXPECT_EQ(mesh.subMesh(0), (SubMesh{0, 6}));
}

TEST(Mesh, KeepsTheSubMeshesItIsGiven)
{
    MeshData data = Square();
    data.subMeshes = {{3, 3}, {0, 3}};
    const Mesh mesh("square", data);
    ASSERT_EQ(mesh.subMeshCount(), 2);
    EXPECT_EQ(mesh.subMesh(0), (SubMesh{3, 3}));
    EXPECT_EQ(mesh.subMesh(1), (SubMesh{0, 3}));
}

TEST(Mesh, IsBoundedByItsVertices)
{
    EXPECT_EQ(Mesh("square", Square()).bounds(), (Bounds{{1, 1, 5}, {2, 1, 0}}));
}

TEST(Mesh, IsBoundedEvenWhereItsCoordinatesAreHuge)
{
    constexpr float huge = std::numeric_limits<float>::max();
    MeshData data;
    data.vertices = {{-huge, 0, 0}, {huge, 0, 0}, {huge, 0, 0}};
    EXPECT_EQ(Mesh("huge", data).bounds(), (Bounds{{0, 0, 0}, {huge, 0, 0}}));
}

TEST(Mesh, HasAnIdThatNoOtherMeshHas)
{
    EXPECT_NE(Mesh("a", Square()).id(), Mesh("a", Square()).id());
}

TEST(Mesh, RejectsAnArrayOfAnotherLength)
{
    MeshData data = Square();
    data.uv.resize(3);
    data.uv8.resize(5);
    EXPECT_THAT(ErrorsOf(data),
                ElementsAre(Mentions("'square'", "uv:", "3 elements", "4 vertices"),
                            Mentions("'square'", "uv8:", "5 elements", "4 vertices")));
}

TEST(Mesh, RejectsAnIndexOutOfRange)
{
    MeshData data = Square();
    data.triangles[2] = 4;
    data.triangles[4] = 9;
    EXPECT_THAT(ErrorsOf(data),
                ElementsAre(Mentions("'square'", "triangles[2]", "index 4", "4 vertices", "2")));
}

TEST(Mesh, RejectsIndicesThatAreNoWholeTriangles)
{
    MeshData data = Square();
    data.triangles.pop_back();
    EXPECT_THAT(ErrorsOf(data),
                ElementsAre(Mentions("'square'", "triangles", "5 indices", "multiple of three")));
}

TEST(Mesh, RejectsASubMeshThatLeavesTheIndexList)
{
    MeshData data = Square();
    data.subMeshes = {{0, 3}, {3, 6}};
    EXPECT_THAT(ErrorsOf(data), ElementsAre(Mentions("'square'", "subMeshes[1]", "3 to 9", "6")));
    data.subMeshes = {{0, 2}};
    EXPECT_THAT(ErrorsOf(data), ElementsAre(Mentions("'square'", "subMeshes[0]", "2 indices",
                                                     "multiple of three")));
    data.subMeshes = {{4294967295u, 3}};
    EXPECT_THAT(ErrorsOf(data),
                ElementsAre(Mentions("'square'", "subMeshes[0]", "4294967295 to 4294967298", "6")));
}

TEST(Mesh, RejectsNumbersThatAreNotFinite)
{
    MeshData data = Square();
    data.vertices[2].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(ErrorsOf(data),
                ElementsAre(Mentions("'square'", "vertices[2]", "not a finite number")));
    data = Square();
    data.tangents.resize(4);
    data.tangents[1].w = std::numeric_limits<float>::infinity();
    EXPECT_THAT(ErrorsOf(data),
                ElementsAre(Mentions("'square'", "tangents[1]", "not a finite number")));
}

TEST(Mesh, RejectsNoVerticesAtAll)
{
    EXPECT_THAT(ErrorsOf({}), ElementsAre(Mentions("'square'", "vertices", "empty")));
}

TEST(Mesh, ListsEveryProblemAtOnce)
{
    MeshData data = Square();
    data.normals.resize(2);
    data.triangles.push_back(7);
    EXPECT_THAT(ErrorsOf(data),
                ElementsAre(Mentions("'square'", "normals", "2 elements", "4 vertices"),
                            Mentions("'square'", "triangles", "7 indices", "multiple of three"),
                            Mentions("'square'", "triangles[6]", "index 7", "4 vertices", "1")));
}

TEST(MeshColors, MayHaveFourBytes)
{
    MeshData data;
    data.SetColors(std::vector{Color32(255, 0, 51, 0), Color32(0, 255, 0, 255)});
    ASSERT_EQ(data.colors.size(), 2u);
    EXPECT_EQ(data.colors[0], glm::vec4(1.0f, 0.0f, 0.2f, 0.0f));
    EXPECT_EQ(data.colors[1], glm::vec4(0.0f, 1.0f, 0.0f, 1.0f));
}

} // namespace
} // namespace limn

#include "models/MeshSkin.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <limits>
#include <limn/base/Diagnostic.h>

namespace limn::test
{
namespace
{

/// A triangle in the plane x + y = 1, whose vertices all follow the one bone.
std::shared_ptr<const Mesh> SlantedTriangle()
{
    const float half = std::sqrt(0.5f);
    MeshData data;
    data.vertices = {{1, 0, 0}, {0, 1, 0}, {1, 0, 1}};
    data.normals.assign(3, glm::vec3(half, half, 0));
    data.tangents.assign(3, glm::vec4(half, -half, 0, 1));
    data.triangles = {0, 1, 2};
    return std::make_shared<const Mesh>("Slanted", std::move(data));
}

MeshSkin OneBone()
{
    MeshSkin skin;
    skin.bindPoses = {glm::mat4(1.0f)};
    skin.weights.assign(3, BoneWeights{BoneWeight{0, 1.0f}});
    return skin;
}

void ExpectPlaceNear(const glm::vec3& value, const glm::vec3& expected)
{
    EXPECT_LT(glm::distance(value, expected), 1e-6f) << value.x << " " << value.y << " " << value.z;
}

TEST(PoseMesh, KeepsNormalsUprightOnASurfaceThatIsStretched)
{
    for (const double z : {1.0, -1.0}) // -1 mirrors
    {
        const glm::dmat4 bone = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 2, z));
        const MeshData posed = PoseMesh(SlantedTriangle(), OneBone(), {&bone, 1})->data();
        // By hand: the plane is x + y / 2 = 1 now.
        ExpectPlaceNear(posed.vertices[1], {0, 2, 0});
        ExpectPlaceNear(posed.vertices[2], {1, 0, z});
        ExpectPlaceNear(posed.normals[0], glm::vec3(2, 1, 0) / std::sqrt(5.0f));
        ExpectPlaceNear(posed.tangents[0], glm::vec3(1, -2, 0) / std::sqrt(5.0f));
        EXPECT_EQ(posed.tangents[0].w, 1.0f);
    }
}

TEST(PoseMesh, KeepsNormalsWhereABoneMakesThemNothing)
{
    const glm::dmat4 bone = glm::scale(glm::dmat4(1.0), glm::dvec3(0));
    const auto mesh = SlantedTriangle();
    const MeshData posed = PoseMesh(mesh, OneBone(), {&bone, 1})->data();
    EXPECT_EQ(posed.vertices[0], glm::vec3(0));
    EXPECT_EQ(posed.normals, mesh->data().normals);
    EXPECT_EQ(posed.tangents, mesh->data().tangents);
}

TEST(PoseMesh, IsTheMeshItselfWhereNothingMoves)
{
    const auto mesh = SlantedTriangle();
    const glm::dmat4 bone(1.0);
    EXPECT_EQ(PoseMesh(mesh, OneBone(), {&bone, 1}), mesh);
}

TEST(PoseMesh, LeavesVerticesThatNoBoneMoves)
{
    MeshSkin skin = OneBone();
    skin.weights[1] = {};
    const glm::dmat4 bone = glm::translate(glm::dmat4(1.0), glm::dvec3(5, 0, 0));
    const MeshData posed = PoseMesh(SlantedTriangle(), skin, {&bone, 1})->data();
    ExpectPlaceNear(posed.vertices[0], {6, 0, 0});
    ExpectPlaceNear(posed.vertices[1], {0, 1, 0});
}

TEST(PoseMesh, RefusesAPlaceThatIsNoNumber)
{
    const glm::dmat4 bone = glm::scale(glm::dmat4(1.0), glm::dvec3(1e300));
    EXPECT_THROW(PoseMesh(SlantedTriangle(), OneBone(), {&bone, 1}), ContractError);
}

TEST(BoneWeights, AddUpToOneOrAreNone)
{
    BoneWeights weights{
        {{0, 3.0f}, {1, 1.0f}, {2, -1.0f}, {3, std::numeric_limits<float>::quiet_NaN()}}};
    Normalize(weights);
    EXPECT_EQ(weights[0].weight, 0.75f);
    EXPECT_EQ(weights[1].weight, 0.25f);
    EXPECT_EQ(weights[2].weight, 0.0f);
    EXPECT_EQ(weights[3].weight, 0.0f);
    BoneWeights none;
    Normalize(none);
    EXPECT_EQ(none[0].weight, 0.0f);
}

} // namespace
} // namespace limn::test

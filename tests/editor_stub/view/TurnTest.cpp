#include "SceneFolder.h"

#include <cmath>

namespace limn::test
{

namespace
{

/// Where an object's local x axis points after some seconds.
glm::vec3 AxisAfter(SceneAsset& asset, double seconds)
{
    TurnObjects(asset.turns, seconds);
    return asset.scene.Find("a")->transform.localRotation * glm::vec3(1, 0, 0);
}

void ExpectNear(const glm::vec3& expected, const glm::vec3& actual)
{
    EXPECT_NEAR(expected.x, actual.x, 1e-5f);
    EXPECT_NEAR(expected.y, actual.y, 1e-5f);
    EXPECT_NEAR(expected.z, actual.z, 1e-5f);
}

} // namespace

// Left-handed: a quarter turn about y takes x to -z.
TEST(Turn, IsInDegreesASecondOnTopOfTheRotation)
{
    SceneFolder folder;
    SceneAsset asset = folder.LoadWithCamera(
        "objects:\n  - {name: a, rotation: [0, 90, 0], turn: [0, 45, 0]}\n  - {name: b}\n");
    ASSERT_EQ(1u, asset.turns.size());
    ExpectNear({0, 0, -1}, AxisAfter(asset, 0.0));
    ExpectNear({-1, 0, 0}, AxisAfter(asset, 2.0));
    ExpectNear({0, 0, -1}, AxisAfter(asset, 8.0));
}

TEST(Turn, KeepsItsAngleAfterDays)
{
    SceneFolder folder;
    SceneAsset asset = folder.LoadWithCamera("objects: [{name: a, turn: [0, 45, 0]}]\n");
    ExpectNear({0, 0, -1}, AxisAfter(asset, 1e9 * 8.0 + 2.0));
}

} // namespace limn::test

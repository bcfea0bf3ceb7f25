#include <gtest/gtest.h>
#include <limn/core/Scene.h>
#include <type_traits>

namespace limn
{
namespace
{

// `GameObject object = scene.Add("x")` would change a copy that is in no scene.
static_assert(!std::is_copy_constructible_v<GameObject>);
static_assert(!std::is_constructible_v<GameObject, GameObject&>);
static_assert(!std::is_copy_assignable_v<GameObject>);
static_assert(!std::is_move_constructible_v<GameObject>);

TEST(Scene, GivesTheObjectThatItHas)
{
    Scene scene;
    GameObject& added = scene.Add("Torus");
    added.layer = 3;
    EXPECT_EQ(&added, scene.Find("Torus"));
    EXPECT_EQ(3, scene.objects().at(0)->layer);
}

} // namespace
} // namespace limn

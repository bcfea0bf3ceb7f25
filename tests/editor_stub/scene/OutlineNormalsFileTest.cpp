#include "Mentions.h"
#include "SceneFolder.h"

#include <gtest/gtest.h>
#include <limn/core/OutlineNormals.h>

namespace limn::test
{

TEST(OutlineNormalsInAScene, AreBakedOnceForEachMeshThatAsksForThem)
{
    SceneFolder folder;
    const SceneAsset asset = folder.LoadWithCamera("objects:\n"
                                                   "  - {name: plain, mesh: cube}\n"
                                                   "  - name: baked\n"
                                                   "    mesh: cube\n"
                                                   "    bakeOutlineNormals: true\n"
                                                   "    children:\n"
                                                   "      - {name: child, mesh: cube}\n"
                                                   "      - {name: without, mesh: cube, "
                                                   "bakeOutlineNormals: false}\n");
    const auto mesh = [&](std::size_t index)
    {
        return asset.scene.objects().at(index)->renderer->mesh;
    };
    EXPECT_TRUE(mesh(0)->data().uv8.empty());
    EXPECT_EQ(mesh(1)->data().uv8, BakeOutlineNormals(*mesh(0)));
    EXPECT_EQ(mesh(2), mesh(1));
    EXPECT_EQ(mesh(3), mesh(0));
}

TEST(OutlineNormalsInAScene, NeedAWidthThatIsANumberInItsRange)
{
    SceneFolder folder;
    EXPECT_THAT(
        folder.ProblemsOf("camera: {}\nmaterials: "
                          "{a: {shader: Limn/TranslucentOutlineHull, _OutlineWidth: .nan},\n"
                          "  b: {shader: Limn/TranslucentOutlineHull, _OutlineWidth: 1e4},\n"
                          "  c: {shader: Limn/TranslucentOutlineHull, _OutlineWidth: -1}}\n"),
        testing::ElementsAre(
            Mentions("2:69: material 'a'._OutlineWidth:", "'.nan'", "finite"),
            Mentions("3:59: material 'b'._OutlineWidth:", "1e4", "outside", "[0, 10]"),
            Mentions("4:59: material 'c'._OutlineWidth:", "-1", "outside", "[0, 10]")));
}

} // namespace limn::test

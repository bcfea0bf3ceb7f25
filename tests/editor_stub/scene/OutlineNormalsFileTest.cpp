#include "SceneFolder.h"

#include <gtest/gtest.h>
#include <limn/core/OutlineNormals.h>

namespace limn::test
{

using Lines = std::vector<std::string>;

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
    EXPECT_EQ(
        (Lines{"2:69: material 'a'._OutlineWidth: '.nan' is not a finite number; a number such as "
               "0.5 is expected",
               "3:59: material 'b'._OutlineWidth: 1e4 is outside [0, 10]",
               "4:59: material 'c'._OutlineWidth: -1 is outside [0, 10]"}),
        folder.ProblemsOf("camera: {}\nmaterials: "
                          "{a: {shader: Limn/TranslucentOutlineHull, _OutlineWidth: .nan},\n"
                          "  b: {shader: Limn/TranslucentOutlineHull, _OutlineWidth: 1e4},\n"
                          "  c: {shader: Limn/TranslucentOutlineHull, _OutlineWidth: -1}}\n"));
}

} // namespace limn::test

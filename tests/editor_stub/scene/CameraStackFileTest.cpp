#include "Mentions.h"
#include "SceneFolder.h"
#include "explain/Explanation.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CameraStackFile, ACameraHasOverlaysInItsStack)
{
    SceneFolder folder;
    const Camera camera = folder
                              .Load("layers: {6: Weapon}\n"
                                    "camera:\n"
                                    "  cameraStack:\n"
                                    "  - position: [1, 2, 3]\n"
                                    "    fieldOfView: 30\n"
                                    "    cullingMask: [Weapon]\n"
                                    "    clearDepth: false\n"
                                    "    renderPostProcessing: true\n"
                                    "  - {orthographic: true, lookAt: [0, 0, -1]}\n")
                              .camera;
    ASSERT_EQ(2u, camera.cameraStack.size());
    const Camera& first = *camera.cameraStack[0];
    EXPECT_EQ(CameraRenderType::Overlay, first.renderType);
    EXPECT_EQ(glm::vec3(1, 2, 3), first.transform.localPosition);
    EXPECT_EQ(30.0f, first.fieldOfView);
    EXPECT_EQ(LayerMask(64u), first.cullingMask);
    EXPECT_FALSE(first.clearDepth);
    EXPECT_TRUE(first.renderPostProcessing);
    const Camera& second = *camera.cameraStack[1];
    EXPECT_TRUE(second.orthographic);
    EXPECT_TRUE(second.clearDepth);
    EXPECT_FALSE(second.renderPostProcessing);
    EXPECT_NEAR(-1.0f, second.transform.forward().z, 1e-6f);
    EXPECT_TRUE(folder.Load("camera: {}\n").camera.cameraStack.empty());
}

TEST(CameraStackFile, SaysWhatIsWrongWithAnOverlay)
{
    SceneFolder folder;
    EXPECT_THAT(
        folder.ProblemsOf("camera:\n"
                          "  cameraStack:\n"
                          "  - {clearDepth: 2, farClipPlane: 0.1}\n"
                          "  - {backgroundColor: [1, 1, 1]}\n"),
        ElementsAre(HasSubstr("3:18: camera.cameraStack[0].clearDepth"),
                    Mentions("3:35: camera.cameraStack[0].farClipPlane:", "0.1", "nearClipPlane"),
                    HasSubstr("4:6: camera.cameraStack[1]: unknown key "
                              "'backgroundColor'")));
    EXPECT_THAT(folder.ProblemsOf("camera: {cameraStack: weapon}\n"),
                ElementsAre(HasSubstr("camera.cameraStack: found")));
}

TEST(CameraStackFile, IsDrawnAndExplainedCameraByCamera)
{
    SceneFolder folder;
    SceneAsset asset = folder.Load("size: [16, 16]\n"
                                   "layers: {6: Weapon}\n"
                                   "camera:\n"
                                   "  cullingMask: [Default]\n"
                                   "  cameraStack: [{cullingMask: [Weapon]}]\n"
                                   "objects:\n"
                                   "- {name: A, mesh: cube, position: [0, 0, 5]}\n"
                                   "- {name: B, mesh: cube, position: [0, 0, 5], layer: "
                                   "Weapon}\n");
    const Explanation explanation = Explain(std::move(asset), folder.assets);
    std::vector<std::string> names;
    for (const ExecutedPassReport& pass : explanation.report.passes)
    {
        names.push_back(pass.name.name());
    }
    EXPECT_THAT(names,
                ElementsAre("Draw Opaque Objects", "Draw Transparent Objects",
                            "Draw Opaque Objects", "Draw Transparent Objects", "Final Blit"));
}

} // namespace
} // namespace limn::test

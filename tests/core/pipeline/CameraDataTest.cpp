#include "pipeline/RendererHarness.h"
#include "record/RecordedCommands.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <gtest/gtest.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/core/UniversalRenderer.h>

namespace limn::test
{
namespace
{

/// Keeps what a feature is told of the camera.
class CameraReader : public ScriptableRendererFeature
{
public:
    explicit CameraReader(CameraData& seen) : m_Seen(seen) {}
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer&, RenderingData& data) override
    {
        m_Seen = data.cameraData;
    }

private:
    CameraData& m_Seen;
};

CameraData SeenBy(const Camera& camera, int width, int height)
{
    RecordingDevice device;
    UniversalRenderPipeline pipeline(device);
    UniversalRenderer renderer(Compiler());
    CameraData seen;
    renderer.AddFeature(std::make_unique<CameraReader>(seen));
    const Scene scene;
    RenderRequest request;
    request.scene = &scene;
    request.camera = &camera;
    request.width = width;
    request.height = height;
    pipeline.RenderSingleCamera(renderer, request);
    return seen;
}

TEST(CameraDataOfAFrame, IsTheCameras)
{
    Camera camera;
    CameraData seen = SeenBy(camera, 8, 4);
    EXPECT_EQ(CameraType::Game, seen.cameraType);
    EXPECT_TRUE(seen.postProcessEnabled);
    EXPECT_TRUE(seen.isHdrEnabled);
    EXPECT_FALSE(seen.isSceneViewCamera() || seen.isPreviewCamera());

    camera.cameraType = CameraType::SceneView;
    camera.renderPostProcessing = false;
    camera.allowHDR = false;
    seen = SeenBy(camera, 8, 4);
    EXPECT_TRUE(seen.isSceneViewCamera());
    EXPECT_FALSE(seen.isPreviewCamera());
    EXPECT_FALSE(seen.postProcessEnabled);
    EXPECT_FALSE(seen.isHdrEnabled);
}

TEST(CameraDataOfAFrame, HasItsMatricesAsFunctions)
{
    Camera camera;
    camera.transform.localPosition = {1.0, 2.0, 3.0};
    camera.fieldOfView = 60.0f;
    camera.nearClipPlane = 0.5f;
    camera.farClipPlane = 20.0f;
    const CameraData seen = SeenBy(camera, 16, 8);
    const glm::dmat4 openGl = glm::perspectiveRH_NO(glm::radians(60.0), 2.0, 0.5, 20.0);
    const glm::dmat4 projection = seen.GetProjectionMatrix();
    for (int column = 0; column < 4; ++column)
    {
        for (int row = 0; row < 4; ++row)
        {
            EXPECT_NEAR(openGl[column][row], projection[column][row], 1e-6) << column << row;
        }
    }
    // A point 0.5 m in front of the camera, which looks along z in the world, along -z in the view.
    const glm::dvec4 nearest = seen.GetViewMatrix() * glm::dvec4(1.0, 2.0, 3.5, 1.0);
    EXPECT_NEAR(-0.5, nearest.z, 1e-12);
    const glm::vec4 clip = seen.GetGPUProjectionMatrix() * glm::vec4(nearest);
    EXPECT_NEAR(1.0f, clip.z / clip.w, 1e-6f) << "reversed depth is 1 at the near plane";
}

TEST(FullScreenDraw, IsThreeVerticesOfThePass)
{
    CommandBuffer cmd;
    auto material = std::make_shared<const Material>(
        ShaderOf("Shader \"T\" { SubShader { Pass { } Pass { } } }"));
    MaterialPropertyBlock properties;
    properties.SetFloat(ShaderPropertyId("_X"), 2.0f);
    CoreUtils::DrawFullScreen(cmd, material, properties, 1);
    ASSERT_EQ(1u, cmd.commands().size());
    const auto* draw = std::get_if<RecordedDraw>(&cmd.commands().front());
    ASSERT_NE(nullptr, draw);
    EXPECT_EQ(material, draw->material);
    EXPECT_EQ(glm::dmat4(1.0), draw->matrix);
    EXPECT_EQ(3u, draw->vertexCount);
    EXPECT_EQ(1, draw->shaderPass);
    ASSERT_NE(nullptr, cmd.PropertiesOf(*draw));
    EXPECT_EQ(2.0f, std::get<float>(*cmd.PropertiesOf(*draw)->Find(ShaderPropertyId("_X"))));
    EXPECT_THROW(CoreUtils::DrawFullScreen(cmd, nullptr), ContractError);

    CoreUtils::Destroy(material);
    EXPECT_EQ(nullptr, material);
    CoreUtils::Destroy(material); // twice, as features of C# do
}

} // namespace
} // namespace limn::test

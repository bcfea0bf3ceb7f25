#include "scene/SceneView.h"

#include "SceneFolder.h"
#include "precision/DevicePrecision.h"

#include <cmath>
#include <gtest/gtest.h>

namespace limn::test
{
namespace
{

/// A white wall 5 m away, before a sky.
constexpr const char* k_Wall = R"(camera: {position: [0, 0, -5], nearClipPlane: 1, farClipPlane: 11}
size: [16, 16]
skybox: sky
materials:
  sky: {shader: Skybox/Procedural}
  wall: {shader: Universal Render Pipeline/Unlit}
objects:
  - {name: Wall, mesh: Quad, scale: 20, material: wall}
)";

class SceneViewGpu : public GpuTest
{
protected:
    static int RedInTheMiddle(const RenderResult& result)
    {
        const Image image = SharedDevice().ReadBack(*result.output.rt());
        return std::to_integer<int>(image.texels[4 * (16 * 8 + 8)]);
    }

    SceneFolder m_Folder;
    UniversalRenderPipeline m_Pipeline{SharedDevice()};
};

TEST_F(SceneViewGpu, HasTheFogOfItsFile)
{
    SceneView clear(m_Folder.Load(k_Wall), m_Folder.assets);
    EXPECT_EQ(255, RedInTheMiddle(clear.Render(m_Pipeline, 0.0)));
    SceneView veiled(m_Folder.Load(std::string(k_Wall) + "renderSettings: {fog: true, fogMode: "
                                                         "Exponential, fogDensity: 0.2, "
                                                         "fogColor: [0, 0, 0]}\n"),
                     m_Folder.assets);
    // 4 of the 10 m between the planes, as a part of 11, and URP's density of this mode.
    const double seen = std::exp(-0.2 * std::sqrt(std::log(2.0)) * 4.4);
    const double encoded = 1.055 * std::pow(seen, 1.0 / 2.4) - 0.055;
    EXPECT_NEAR(255.0 * encoded, RedInTheMiddle(veiled.Render(m_Pipeline, 0.0)), 1.0);
}

TEST_F(SceneViewGpu, HasTheLightOfItsSkyFromTheFirstPictureOn)
{
    SceneView view(
        m_Folder.Load(std::string(k_Wall) +
                      "renderSettings: {ambientMode: Skybox, defaultReflectionMode: Skybox, "
                      "defaultReflectionResolution: 16}\n"),
        m_Folder.assets);
    const Scene& scene = view.asset().scene;
    EXPECT_EQ(nullptr, scene.skyReflection);
    EXPECT_EQ(scene.ambientProbe(0, 0), scene.ambientProbe(2, 0));
    view.Render(m_Pipeline, 0.0);
    const std::shared_ptr<const Texture> reflection = scene.skyReflection;
    ASSERT_NE(nullptr, reflection);
    EXPECT_EQ(16, reflection->width());
    EXPECT_GT(scene.ambientProbe(2, 0), 1.2f * scene.ambientProbe(0, 0)) << "the sky is blue";
    view.Render(m_Pipeline, 1.0);
    EXPECT_EQ(reflection, scene.skyReflection) << "once is enough";
}

TEST_F(SceneViewGpu, MakesNoLightThatNobodyAsksFor)
{
    SceneView view(m_Folder.Load(k_Wall), m_Folder.assets);
    view.Render(m_Pipeline, 0.0);
    EXPECT_EQ(nullptr, view.asset().scene.skyReflection);
    EXPECT_EQ(SphericalHarmonicsL2(), view.asset().scene.ambientProbe);
}

} // namespace
} // namespace limn::test

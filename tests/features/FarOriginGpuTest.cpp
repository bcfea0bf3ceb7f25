#include "features/OutlineScene.h"
#include "vulkan/GpuTestDevice.h"

#include <cmath>

using namespace limn;
using namespace limn::test;

namespace
{

constexpr int k_FarWidth = 96;
constexpr int k_FarHeight = 60;
constexpr double k_Distances[] = {1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

/// Draws scenes, each with an outline around what is selected or without one.
class FarOriginGpu : public GpuTest
{
protected:
    std::vector<std::byte> Draw(const Scene& scene, const Camera& camera, bool outline)
    {
        RenderRequest request;
        request.scene = &scene;
        request.camera = &camera;
        request.width = k_FarWidth;
        request.height = k_FarHeight;
        request.volumeStack = &m_Volumes.With(outline, Color{1, 0.5f, 0, 1}, 3.0f);
        if (!m_Pipeline)
        {
            m_Pipeline = std::make_unique<UniversalRenderPipeline>(SharedDevice());
            AddOutline(m_Renderer);
        }
        const RenderResult result = m_Pipeline->RenderSingleCamera(m_Renderer, request);
        return SharedDevice().ReadBack(*result.output.rt()).texels;
    }

private:
    std::unique_ptr<UniversalRenderPipeline> m_Pipeline;
    UniversalRenderer m_Renderer{Compiler()};
    BlendedOutline m_Volumes;
};

/// Pixels of RGBA8 pictures that differ.
int Differing(const std::vector<std::byte>& a, const std::vector<std::byte>& b)
{
    EXPECT_EQ(a.size(), b.size());
    int count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4)
    {
        count += std::equal(a.begin() + static_cast<std::ptrdiff_t>(i),
                            a.begin() + static_cast<std::ptrdiff_t>(i + 4),
                            b.begin() + static_cast<std::ptrdiff_t>(i))
                     ? 0
                     : 1;
    }
    return count;
}

/// Pixels unlike the first one, which shows the background.
int Drawn(const std::vector<std::byte>& picture)
{
    std::vector<std::byte> background;
    for (int i = 0; i < k_FarWidth * k_FarHeight; ++i)
    {
        background.insert(background.end(), picture.begin(), picture.begin() + 4);
    }
    return Differing(picture, background);
}

/// The outline scene, camera and all, below a parent that carries it away.
struct CarriedScene : OutlineScene
{
    Transform away;

    explicit CarriedScene(double distance)
    {
        away.localPosition = glm::dvec3(distance, -distance, distance / 2);
        camera.transform.parent = &away;
        for (const auto& object : scene.objects())
        {
            object->transform.parent = &away;
        }
    }
};

TEST_F(FarOriginGpu, DrawsTheSamePictureWhereverSceneAndCameraAre)
{
    for (const bool outline : {false, true})
    {
        const CarriedScene here(0.0);
        const auto expected = Draw(here.scene, here.camera, outline);
        ASSERT_GT(Drawn(expected), 500);
        for (const double distance : k_Distances)
        {
            const CarriedScene there(distance);
            EXPECT_EQ(0, Differing(expected, Draw(there.scene, there.camera, outline)))
                << "pixels differ at " << distance << " m, outline " << outline;
        }
    }
}

/// Cubes the size of mountains at places that are floats also at 1e9 m, where those lie 64 m apart.
struct MountainScene : OutlineScene
{
    explicit MountainScene(double distance)
    {
        const glm::vec3 away = glm::dvec3(distance, -distance, distance / 2);
        for (const auto& object : scene.objects())
        {
            object->activeSelf = false;
        }
        const auto material = scene.Find("Cube")->renderer->sharedMaterials.at(0);
        const glm::vec3 places[] = {{-192, 64, 1024}, {128, -128, 896}, {64, 192, 1280}};
        for (const glm::vec3& place : places)
        {
            Add("Mountain", PrimitiveType::Cube, away + place, material, place.x > 0.0f);
            scene.objects().back()->transform.localScale = {256, 192, 320};
            scene.objects().back()->transform.localRotation = EulerToRotation({15, 40, 5});
        }
        camera.transform.localPosition = away;
        camera.nearClipPlane = 10.0f;
        camera.farClipPlane = 4000.0f;
    }
};

TEST_F(FarOriginGpu, DrawsItWithoutAParentTooWherePlacesAreFloats)
{
    const MountainScene here(0.0);
    const auto expected = Draw(here.scene, here.camera, true);
    ASSERT_GT(Drawn(expected), 500);
    for (const double distance : k_Distances)
    {
        // A multiple of 64 m, so that distance and places are floats together.
        const MountainScene there(std::round(distance / 128.0) * 128.0);
        EXPECT_EQ(0, Differing(expected, Draw(there.scene, there.camera, true)))
            << "pixels differ at " << distance << " m";
    }
}

TEST_F(FarOriginGpu, MovesWithTheCameraByLessThanAPixelFarAway)
{
    // A pixel is 2.8 m * tan 25° / 30 = 44 mm wide where the scene is.
    CarriedScene here(0.0);
    CarriedScene there(1e6);
    const auto first = Draw(here.scene, here.camera, true);
    for (int step = 1; step <= 6; ++step)
    {
        const float x = static_cast<float>(step) / 256.0f;
        here.camera.transform.localPosition.x = x;
        there.camera.transform.localPosition.x = x;
        const auto expected = Draw(here.scene, here.camera, true);
        EXPECT_GT(Differing(first, expected), 0) << "no step " << step;
        EXPECT_EQ(0, Differing(expected, Draw(there.scene, there.camera, true)))
            << "pixels differ at step " << step;
    }
}

} // namespace

#include "features/OutlineScene.h"
#include "vulkan/GpuTestDevice.h"

#include <random>

using namespace limn;
using namespace limn::test;

namespace
{

/// A scene that changes, and how it is drawn by who has followed it and by who sees it new.
class MovingObjectsGpu : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        if (!IsSkipped() && !HasFatalFailure())
        {
            m_Material =
                std::make_shared<Material>(FindBuiltinShader("Limn/Half Lambert", Compiler()));
            m_Camera.transform.localPosition = {0, 0, -4};
            m_Camera.transform.parent = &m_World;
            m_Pipeline.emplace(SharedDevice());
        }
    }

    GameObject& Add(Scene& scene, const glm::vec3& position)
    {
        GameObject& object = AddCube(scene, "cube", position, {m_Material});
        object.transform.localScale = glm::vec3(0.6f);
        object.transform.parent = &m_World;
        return object;
    }

    std::vector<std::byte> Draw(const Scene& scene)
    {
        RenderRequest request;
        request.scene = &scene;
        request.camera = &m_Camera;
        request.width = 48;
        request.height = 32;
        const RenderResult result = m_Pipeline->RenderSingleCamera(m_Renderer, request);
        return SharedDevice().ReadBack(*result.output.rt()).texels;
    }

    /// The same objects in a scene that nobody has drawn.
    std::vector<std::byte> DrawNew()
    {
        Scene copy;
        for (const auto& object : m_Scene.objects())
        {
            GameObject& other = copy.Add(object->name);
            other.transform = object->transform;
            other.activeSelf = object->activeSelf;
            other.renderer = object->renderer;
        }
        return Draw(copy);
    }

    Transform m_World;
    Scene m_Scene;
    Camera m_Camera;
    std::shared_ptr<Material> m_Material;
    std::optional<UniversalRenderPipeline> m_Pipeline;
    UniversalRenderer m_Renderer{Compiler()};
};

TEST_F(MovingObjectsGpu, AreDrawnWhereTheyAreInEveryFrame)
{
    std::mt19937 random(5);
    const auto real = [&](float reach)
    {
        return std::uniform_real_distribution<float>(-reach, reach)(random);
    };
    for (int i = 0; i < 6; ++i)
    {
        Add(m_Scene, {real(2), real(1), real(1)});
    }
    std::vector<std::byte> last;
    int changes = 0;
    for (int frame = 0; frame < 24; ++frame)
    {
        SCOPED_TRACE("frame " + std::to_string(frame));
        GameObject& object = *m_Scene.objects()[random() % m_Scene.objects().size()];
        object.transform.localPosition = {real(2), real(1), real(1)};
        if (frame % 4 == 1)
        {
            object.transform.localRotation = EulerToRotation({real(90), real(90), 0});
        }
        if (frame % 5 == 2)
        {
            for (int i = 0; i < frame; ++i) // more than there is room for
            {
                Add(m_Scene, {real(2), real(1), real(1)});
            }
        }
        if (frame % 6 == 3)
        {
            object.activeSelf = !object.activeSelf;
        }
        if (frame == 12 || frame == 18)
        {
            m_World.localPosition.x = frame == 12 ? 1e7f : 0.0f; // and the camera with them
        }
        const std::vector<std::byte> picture = Draw(m_Scene);
        EXPECT_TRUE(picture == DrawNew());
        changes += picture != last ? 1 : 0;
        last = picture;
    }
    EXPECT_GT(changes, 16) << "hardly anything moves";
}

TEST_F(MovingObjectsGpu, AreThoseOfTheirOwnSceneAmongSeveral)
{
    Scene other;
    Add(m_Scene, {-1, 0, 0});
    Add(other, {1, 0, 0});
    const auto left = Draw(m_Scene);
    const auto right = Draw(other);
    EXPECT_FALSE(left == right);
    for (int again = 0; again < 3; ++again)
    {
        EXPECT_TRUE(left == Draw(m_Scene));
        EXPECT_TRUE(right == Draw(other));
    }
}

} // namespace

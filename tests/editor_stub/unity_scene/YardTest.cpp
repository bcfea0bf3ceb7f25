// The project `data/yard`, which was written by hand: two stacks of two crates, each a prefab in a
// prefab. The expected numbers follow from what its files say.

#include "Paths.h"
#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <limn/core/Material.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/features/ScreenSpaceOutline.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string k_Yard = SourcePath("tests/editor_stub/data/yard");

class Yard : public testing::Test
{
protected:
    const GameObject& Child(const std::string& stack, const std::string& crate)
    {
        for (const auto& object : m_Scene.scene.objects())
        {
            const Transform* parent = object->transform.parent;
            if (object->name == crate && parent == &m_Scene.scene.Find(stack)->transform)
            {
                return *object;
            }
        }
        throw std::runtime_error(stack + " has no " + crate);
    }
    static void ExpectAt(const GameObject& object, const glm::vec3& place)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            EXPECT_NEAR(object.transform.position()[axis], place[axis], 1e-6f)
                << object.name << ", axis " << axis;
        }
    }

    AssetContext m_Assets;
    SceneAsset m_Scene = LoadScene(k_Yard, m_Assets);
};

TEST_F(Yard, HasItsObjectsInUnitysOrder)
{
    std::vector<std::string> names;
    for (const auto& object : m_Scene.scene.objects())
    {
        names.push_back(object->name);
    }
    EXPECT_THAT(names, ElementsAre("Main Camera", "Sun", "Floor", "Global Volume", "Left", "Lower",
                                   "Upper", "Right", "Lower", "Upper"));
    ExpectAt(Child("Left", "Lower"), {-1.5f, 0.5f, 0.0f});
    ExpectAt(Child("Left", "Upper"), {-1.5f, 1.25f, 0.0f});
    ExpectAt(Child("Right", "Lower"), {1.5f, 0.5f, 0.0f});
    ExpectAt(Child("Right", "Upper"), {1.5f, 1.25f, 0.0f});
    EXPECT_EQ(Child("Right", "Upper").transform.localScale, glm::vec3(0.5f));
}

TEST_F(Yard, HasWhatItsInstancesChange)
{
    EXPECT_FALSE(Child("Left", "Lower").activeSelf);
    EXPECT_TRUE(Child("Right", "Lower").activeSelf);
    EXPECT_EQ(Child("Right", "Upper").layer, 6);
    EXPECT_EQ(Child("Left", "Upper").layer, 0);
    EXPECT_EQ(m_Scene.layers.Name(6), "Selectable");
    EXPECT_EQ(m_Scene.renderingLayers.Name(1), "Warm");
    const MaterialList& changed = Child("Right", "Lower").renderer->sharedMaterials;
    const MaterialList& own = Child("Left", "Upper").renderer->sharedMaterials;
    ASSERT_EQ(own.size(), 2u);
    ASSERT_EQ(changed.size(), 2u);
    EXPECT_NE(own[0], own[1]);
    EXPECT_EQ(changed[0], own[1]) << "painted all over";
    EXPECT_EQ(changed[1], own[1]);
}

TEST_F(Yard, HasItsMeshAndMaterials)
{
    const MeshRenderer& renderer = *Child("Left", "Upper").renderer;
    ASSERT_EQ(renderer.mesh->subMeshCount(), 2);
    EXPECT_EQ(renderer.mesh->subMesh(0).indexCount, 4u * 2 * 3) << "four sides";
    EXPECT_EQ(renderer.mesh->subMesh(1).indexCount, 2u * 2 * 3) << "two lids";
    EXPECT_EQ(renderer.mesh->bounds().extents, glm::vec3(0.5f));
    EXPECT_EQ(renderer.renderingLayerMask.bits, 257u);
    const ShaderPropertyId map("_BaseMap");
    EXPECT_EQ(renderer.sharedMaterials[0]->GetTextureScale(map), glm::vec2(2, 3));
    EXPECT_EQ(renderer.sharedMaterials[1]->renderQueue(), 2100);
    EXPECT_NE(renderer.sharedMaterials[0]->GetTexture(map), nullptr);
    EXPECT_NE(renderer.sharedMaterials[1]->GetTexture(map), nullptr);
}

TEST_F(Yard, HasItsLightCameraAndVolume)
{
    const DirectionalLight& sun = m_Scene.scene.mainLight;
    EXPECT_NEAR(sun.direction.y, -1.0f, 1e-6f) << "90 degrees about x turn +z down";
    EXPECT_EQ(sun.color, (Color{1, 0.5f, 0.25f, 1}));
    EXPECT_EQ(sun.intensity, 1.5f);
    EXPECT_EQ(sun.shadowStrength, 0.75f);
    EXPECT_EQ(m_Scene.camera.fieldOfView, 60.0f);
    EXPECT_EQ(m_Scene.camera.clearFlags, CameraClearFlags::SolidColor);
    EXPECT_EQ(m_Scene.shadows.shadowDistance, 40.0f);
    ASSERT_EQ(m_Scene.volumes.size(), 1u);
    EXPECT_EQ(m_Scene.volumes.front().priority, 2.0f);
    const auto* outline = m_Scene.volumes.front().sharedProfile->TryGet<ScreenSpaceOutline>();
    ASSERT_NE(outline, nullptr);
    EXPECT_EQ(outline->m_OutlineWidth.value(), 6.0f);
    EXPECT_EQ(m_Scene.renderer.featureTypes.front(), "ScreenSpaceOutlineRenderFeature");
}

TEST_F(Yard, IsInspectedAndExplained)
{
    const CommandRun inspected = RunCommand({"inspect", k_Yard});
    EXPECT_EQ(inspected.exitCode, 0);
    EXPECT_THAT(inspected.out, HasSubstr("m_OutlineWidth  6"));
    EXPECT_THAT(inspected.out, HasSubstr("[Selectable]"));
    const CommandRun explained =
        RunCommand({"explain", k_Yard, "--scene", "Assets/Scenes/Yard.unity", "--object", "Upper"});
    EXPECT_EQ(explained.exitCode, 0) << explained.err;
    EXPECT_THAT(explained.out, HasSubstr("Upper"));
}

TEST_F(Yard, SaysWhereToChangeIt)
{
    for (const std::string& scene : {k_Yard, k_Yard + "/Assets/Scenes/Yard.unity"})
    {
        const CommandRun run = RunCommand({"set", scene, "ScreenSpaceOutline.m_OutlineWidth=2"});
        EXPECT_EQ(run.exitCode, 1);
        EXPECT_THAT(run.err, HasSubstr("whose own files 'limn set' changes")) << scene;
    }
    EXPECT_THAT(RunCommand({"shader", k_Yard}).err, Not(HasSubstr("cannot take it")))
        << "a project's folder may hold shaders";
    const CommandRun run =
        RunCommand({"explain", k_Yard + "/Assets/Scenes/Yard.unity", "--scene", "x"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, HasSubstr("is no folder of a Unity project"));
}

TEST_F(Yard, HasOneLineOfItsProfileChanged)
{
    TemporaryFolder folder;
    std::filesystem::copy(k_Yard, folder.path(), std::filesystem::copy_options::recursive);
    const std::filesystem::path profile = folder / "Assets/Settings/Profile.asset";
    std::string expected = ReadText(profile);
    const CommandRun run =
        RunCommand({"set", profile.string(), "ScreenSpaceOutline.m_OutlineWidth=2"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    expected.replace(expected.find("m_Value: 6"), 10, "m_Value: 2");
    EXPECT_EQ(ReadText(profile), expected);
}

} // namespace
} // namespace limn::test

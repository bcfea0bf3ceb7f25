// The article's own Unity project, where LIMN_UNITY_DIR leads to it. The numbers are those of
// unity_project.md 10, worked out from its files by other means.

#include "unity_scene/UnityScene.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <limn/features/Bloom.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/Tonemapping.h>
#include <limn/features/Vignette.h>

namespace limn::test
{
namespace
{

using testing::UnorderedElementsAre;

class ArticleProject : public testing::Test
{
protected:
    void SetUp() override
    {
        const char* folder = std::getenv("LIMN_UNITY_DIR");
        if (folder == nullptr)
        {
            GTEST_SKIP() << "LIMN_UNITY_DIR names no folder with the article's project";
        }
        const std::filesystem::path project =
            std::filesystem::path(folder) / "URP-Screen-Space-Outline";
        EXPECT_EQ(FindFirstUnityScene(project), project / "Assets/Scenes/SampleScene.unity");
        asset = &Load(project);
    }

    /// Loads the scene once for all tests, none of which changes it.
    static SceneAsset& Load(const std::filesystem::path& project)
    {
        static AssetContext s_Assets;
        static SceneAsset s_Asset = LoadScene(project, s_Assets);
        return s_Asset;
    }

    const GameObject& Find(std::string_view name)
    {
        GameObject* object = asset->scene.Find(name);
        if (object == nullptr)
        {
            throw std::runtime_error("there is no " + std::string(name));
        }
        return *object;
    }

    /// Pixels of a picture of 1920x1080: left, top, right and bottom of all vertices.
    glm::dvec4 PixelsOf(const GameObject& object)
    {
        const glm::dmat4 clip =
            asset->camera.cullingMatrix(1920.0f / 1080.0f) * object.transform.worldMatrix();
        glm::dvec4 bounds(1e9, 1e9, -1e9, -1e9);
        for (const glm::vec3& vertex : object.renderer->mesh->data().vertices)
        {
            const glm::dvec4 at = clip * glm::dvec4(glm::dvec3(vertex), 1.0);
            const double x = (at.x / at.w * 0.5 + 0.5) * 1920.0;
            const double y = (0.5 - at.y / at.w * 0.5) * 1080.0;
            bounds = {std::min(bounds.x, x), std::min(bounds.y, y), std::max(bounds.z, x),
                      std::max(bounds.w, y)};
        }
        return bounds;
    }

    SceneAsset* asset = nullptr;
};

void ExpectNear(const glm::vec3& value, const glm::vec3& expected, float most)
{
    EXPECT_NEAR(value.x, expected.x, most);
    EXPECT_NEAR(value.y, expected.y, most);
    EXPECT_NEAR(value.z, expected.z, most);
}

TEST_F(ArticleProject, HasAllObjectsAndRenderers)
{
    EXPECT_EQ(asset->scene.objects().size(), 47u);
    std::size_t renderers = 0;
    std::size_t slots = 0;
    for (const auto& object : asset->scene.objects())
    {
        EXPECT_TRUE(object->activeSelf) << object->name;
        renderers += object->renderer ? 1 : 0;
        slots += object->renderer ? object->renderer->sharedMaterials.size() : 0;
    }
    EXPECT_EQ(renderers, 29u);
    EXPECT_EQ(slots, 48u);
}

TEST_F(ArticleProject, PutsThemWhereUnityDoes)
{
    const std::pair<const char*, glm::vec3> k_Places[] = {
        {"OSB Panel", {-0.1f, 0, 0}},
        {"Stud Frame", {1.78f, 1.22f, -0.05f}},
        {"Paint 1G Bucket", {0.8189f, 0, -0.7032f}},
        {"Paint 5G Bucket", {0.566f, 0, -0.508f}},
        {"Brush", {0.8442f, 0.0101f, -0.3827f}},
        {"Legs_Low", {1.327f, 0.6309f, -2.6853f}},
        {"Light_Heads_Low", {1.2988f, 1.4627f, -2.6274f}},
        {"Bench Bottom", {2.7206f, 0.351f, 1.0695f}},
        {"Bench Top", {2.714f, 0.73f, 1.062f}},
        {"Supports", {2.714f, 0.5659f, 1.062f}},
        {"Jigsaw", {2.5419f, 0.7602f, 1.3865f}},
        {"Hammer", {2.836f, 0.396f, 1.189f}},
        {"Safety Hat", {2.8324f, 0.9158f, 1.1087f}},
        {"Magnetic Level", {2.6673f, 0.3817f, 1.0103f}},
        {"Safety Goggles", {2.8655f, 0.7586f, 0.8569f}},
        {"Sphere", {1.443f, 0.529f, 0}}};
    for (const auto& [name, place] : k_Places)
    {
        SCOPED_TRACE(name);
        ExpectNear(Find(name).transform.position(), place, 1e-4f);
    }
}

TEST_F(ArticleProject, ShowsTheNearestLodAlone)
{
    int shown = 0;
    for (const auto& object : asset->scene.objects())
    {
        shown += object->renderer && object->renderer->enabled ? 1 : 0;
    }
    EXPECT_EQ(shown, 24) << "29 but for the five of the workbench's second LOD";
    EXPECT_TRUE(Find("Bench Top").renderer->enabled);
}

TEST_F(ArticleProject, HasUnitysTrianglesInEachSubMesh)
{
    const std::pair<const char*, std::vector<std::uint32_t>> k_Triangles[] = {
        {"Bench Top", {184, 1220, 116}},
        {"Bench Legs", {448, 128}},
        {"Supports", {6824, 2400}},
        {"Upper Covers", {1816}},
        {"Bench Bottom", {652}},
        {"Ground", {140, 880, 64}},
        {"Drywall Panel", {6, 38}},
        {"OSB Panel", {88}},
        {"Stud Frame", {1272}},
        {"Stud Pile", {308}},
        {"Jigsaw", {3446}},
        {"Hammer", {528}},
        {"Safety Hat", {1404}},
        {"Magnetic Level", {1428, 176, 432, 48}},
        {"Paint 5G Bucket", {666, 12, 176}},
        {"Paint 1G Bucket", {720}},
        {"Paint 1G Lid", {384}},
        {"Brush", {637}},
        {"Safety Goggles", {148, 242, 620, 540}}};
    for (const auto& [name, triangles] : k_Triangles)
    {
        const Mesh& mesh = *Find(name).renderer->mesh;
        std::vector<std::uint32_t> found;
        for (int i = 0; i < mesh.subMeshCount(); ++i)
        {
            found.push_back(mesh.subMesh(i).indexCount / 3);
        }
        EXPECT_EQ(found, triangles) << name;
    }
}

TEST_F(ArticleProject, OutlinesThreeObjects)
{
    std::vector<std::string> outlined;
    for (const auto& object : asset->scene.objects())
    {
        const bool isInLayer = ((1u << object->layer) & 64u) != 0;
        if (isInLayer && object->renderer && object->renderer->enabled &&
            (object->renderer->renderingLayerMask.bits & 256u) != 0)
        {
            outlined.push_back(object->name);
        }
    }
    EXPECT_THAT(outlined, UnorderedElementsAre("Bench Top", "Jigsaw", "Sphere"));
    ASSERT_EQ(asset->renderer.featureTypes.size() > 0, true);
    EXPECT_EQ(asset->renderer.featureTypes.front(), "ScreenSpaceOutlineRenderFeature");
}

TEST_F(ArticleProject, SeesThemInTheirPixels)
{
    const std::pair<const char*, glm::dvec4> k_Pixels[] = {
        {"Sphere", {861, 268, 1229, 636}},       {"Bench Top", {8, 465, 795, 771}},
        {"Jigsaw", {411, 416, 619, 706}},        {"Safety Hat", {152, 449, 411, 582}},
        {"Hammer", {238, 824, 460, 899}},        {"Paint 5G Bucket", {1178, 434, 1268, 556}},
        {"Light_Heads_Low", {836, 98, 963, 184}}};
    for (const auto& [name, pixels] : k_Pixels)
    {
        const glm::dvec4 found = PixelsOf(Find(name));
        for (int side = 0; side < 4; ++side)
        {
            EXPECT_NEAR(found[side], pixels[side], 2.0) << name << ", side " << side;
        }
    }
}

TEST_F(ArticleProject, HasItsCameraLightAndVolume)
{
    const Camera& camera = asset->camera;
    ExpectNear(camera.transform.position(), {2.32f, 1.203f, 2.378f}, 1e-4f);
    ExpectNear(camera.transform.forward(), {-0.24441f, -0.34441f, -0.90645f}, 1e-4f);
    EXPECT_EQ(camera.clearFlags, CameraClearFlags::Skybox);
    EXPECT_TRUE(camera.renderPostProcessing);
    EXPECT_EQ(camera.volumeLayerMask, LayerMask(1));

    const DirectionalLight& light = asset->scene.mainLight;
    ExpectNear(light.direction, {0.54168f, -0.70711f, -0.45452f}, 1e-4f);
    EXPECT_FLOAT_EQ(light.intensity, 2.0f);
    EXPECT_FLOAT_EQ(light.color.g, 0.95686275f);
    EXPECT_EQ(light.shadows, LightShadows::Soft);
    ASSERT_EQ(asset->scene.additionalLights.size(), 1u);
    const Light& spot = asset->scene.additionalLights.front();
    ExpectNear(spot.transform.localPosition, {1.2821f, 1.467f, -2.5932f}, 1e-3f);
    EXPECT_FLOAT_EQ(spot.intensity, 12.0f);
    EXPECT_FLOAT_EQ(spot.spotAngle, 90.0f);

    ASSERT_EQ(asset->volumes.size(), 1u);
    const Volume& volume = asset->volumes.front();
    EXPECT_TRUE(volume.isGlobal);
    ASSERT_TRUE(volume.sharedProfile);
    const auto* outline = volume.sharedProfile->TryGet<ScreenSpaceOutline>();
    ASSERT_NE(outline, nullptr);
    EXPECT_TRUE(outline->m_Enable.value());
    EXPECT_FLOAT_EQ(outline->m_OutlineWidth.value(), 10.0f);
    EXPECT_FLOAT_EQ(outline->m_OutlineColor.value().g, 0.49606514f);
}

TEST_F(ArticleProject, HasThePostProcessingOfItsProfile)
{
    const VolumeProfile& profile = *asset->volumes.front().sharedProfile;
    const auto* tonemapping = profile.TryGet<Tonemapping>();
    ASSERT_NE(tonemapping, nullptr);
    EXPECT_EQ(tonemapping->mode.value(), TonemappingMode::ACES);
    const auto* bloom = profile.TryGet<Bloom>();
    ASSERT_NE(bloom, nullptr);
    EXPECT_EQ(bloom->threshold.value(), 1.0f);
    EXPECT_EQ(bloom->intensity.value(), 1.0f);
    EXPECT_FALSE(bloom->scatter.overrideState());
    EXPECT_FLOAT_EQ(bloom->scatter.value(), 0.7f);
    const auto* vignette = profile.TryGet<Vignette>();
    ASSERT_NE(vignette, nullptr);
    EXPECT_FLOAT_EQ(vignette->intensity.value(), 0.25f);
    EXPECT_FLOAT_EQ(vignette->smoothness.value(), 0.4f);
}

TEST_F(ArticleProject, HasItsSkyAndFog)
{
    const Scene& scene = asset->scene;
    EXPECT_EQ(scene.ambientMode, AmbientMode::Skybox);
    EXPECT_EQ(scene.defaultReflectionMode, DefaultReflectionMode::Skybox);
    EXPECT_TRUE(scene.skybox);
    EXPECT_TRUE(scene.fog);
    EXPECT_EQ(scene.fogMode, FogMode::ExponentialSquared);
    EXPECT_FLOAT_EQ(scene.fogDensity, 0.05f);
    ExpectNear(glm::vec3(scene.fogColor.vector()), {0.65080994f, 0.666729f, 0.7075472f}, 1e-6f);
}

} // namespace
} // namespace limn::test

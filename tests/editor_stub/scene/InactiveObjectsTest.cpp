#include "SceneFolder.h"

#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <limn/core/Material.h>

namespace limn::test
{
namespace
{

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// A scene of which the files that only inactive objects name are broken behind their first bytes,
/// so that whoever decodes one says so.
class InactiveObjectsOfAScene : public testing::Test
{
protected:
    InactiveObjectsOfAScene()
    {
        m_Folder.Write("broken.gltf", "{\"asset\": ");
        WritePng(m_Folder / "whole.png",
                 Image{1, 1, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(4)});
        std::filesystem::copy_file(m_Folder / "whole.png", m_Folder / "broken.png");
        std::filesystem::resize_file(m_Folder / "broken.png", 40); // the header is there
    }

    SceneAsset Load(const std::string& text, InactiveObjects inactive = InactiveObjects::Check)
    {
        return LoadScene(m_Folder.Write("s.scene.yaml", "camera: {}\n" + text), m_Folder.assets,
                         inactive);
    }

    std::vector<std::string> ProblemsOf(const std::string& text, InactiveObjects inactive)
    {
        return Problems([&] { Load(text, inactive); });
    }

    SceneFolder m_Folder;
};

constexpr const char* k_Broken = "materials: {m: {shader: Universal Render Pipeline/Unlit, "
                                 "_BaseMap: broken.png}}\n"
                                 "objects:\n"
                                 "  - name: A\n"
                                 "    active: false\n"
                                 "    mesh: broken.gltf\n"
                                 "    material: m\n"
                                 "    bakeOutlineNormals: true\n"
                                 "    children: [{name: B, mesh: broken.gltf, materials: [m]}]\n";

TEST_F(InactiveObjectsOfAScene, AreLoadedForWhoeverMaySwitchThemOn)
{
    EXPECT_THAT(ProblemsOf(k_Broken, InactiveObjects::Load),
                Contains(HasSubstr("object 'A'.mesh: 'broken.gltf' cannot be used")));
    EXPECT_THAT(ProblemsOf(k_Broken, InactiveObjects::Load),
                Contains(HasSubstr("_BaseMap: 'broken.png' cannot be used")));
    const SceneAsset asset =
        Load("objects: [{name: A, active: false, mesh: cube}]\n", InactiveObjects::Load);
    EXPECT_TRUE(asset.scene.objects().at(0)->renderer->mesh);
}

TEST_F(InactiveObjectsOfAScene, NeedNoMeshAndNoPictureOfTheirsDecoded)
{
    const SceneAsset asset = Load(k_Broken);
    ASSERT_EQ(asset.scene.objects().size(), 2u);
    for (const auto& object : asset.scene.objects())
    {
        EXPECT_FALSE(object->activeSelf);
        ASSERT_TRUE(object->renderer);
        EXPECT_FALSE(object->renderer->mesh);
        EXPECT_THAT(object->renderer->sharedMaterials, IsEmpty());
    }
    EXPECT_THAT(m_Folder.assets.reachedFiles(), Contains(m_Folder / "broken.gltf"))
        << "watch has to know it, and no picture may be written over it";
}

TEST_F(InactiveObjectsOfAScene, ShareWithActiveOnesWhatThoseNeed)
{
    const SceneAsset asset =
        Load("materials: {m: {shader: Universal Render Pipeline/Unlit, _BaseMap: whole.png}}\n"
             "objects: [{name: A, active: false, mesh: cube, material: m}, "
             "{name: B, mesh: cube, material: m}]\n");
    const MeshRenderer& renderer = *asset.scene.objects().at(1)->renderer;
    EXPECT_TRUE(renderer.mesh);
    ASSERT_EQ(renderer.sharedMaterials.size(), 1u);
    EXPECT_EQ(renderer.sharedMaterials[0]->GetTexture("_BaseMap")->name(), "whole.png");
}

TEST_F(InactiveObjectsOfAScene, AreCheckedForWhatIsMissing)
{
    const std::vector<std::string> problems =
        ProblemsOf("objects:\n"
                   "  - {name: A, active: false, mesh: missing.glb}\n"
                   "  - {name: B, active: false, mesh: cub}\n"
                   "  - {name: C, active: false, mesh: cube, material: none}\n"
                   "  - {name: D, active: false, mesh: cube, materials: [none]}\n",
                   InactiveObjects::Check);
    EXPECT_THAT(problems, Contains(HasSubstr("object 'A'.mesh: 'missing.glb' cannot be used")));
    EXPECT_THAT(problems, Contains(HasSubstr("object 'B'.mesh: unknown mesh 'cub'")));
    EXPECT_THAT(problems, Contains(HasSubstr("object 'C'.material: unknown material 'none'")));
    EXPECT_THAT(problems, Contains(HasSubstr("object 'D'.materials[0]: unknown material 'none'")));
}

} // namespace
} // namespace limn::test

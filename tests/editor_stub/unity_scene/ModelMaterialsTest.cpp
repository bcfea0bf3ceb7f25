// The materials that a model gets where its prefab stands in a scene.

#include "TemporaryFolder.h"
#include "unity_scene/UnityScene.h"

#include <gmock/gmock.h>
#include <limn/core/Material.h>

namespace limn::test
{
namespace
{

/// A project with the model Assets/Things/Crate/crate.obj, whose one material is called Wood and
/// has the texture planks.png.
class ModelMaterials : public testing::Test
{
protected:
    ModelMaterials()
    {
        m_Folder.Write("Assets/Things/Crate/crate.obj",
                       "mtllib crate.mtl\nv 0 0 0\nv 0 1 0\nv 1 0 0\nusemtl Wood\nf 1 2 3\n");
        m_Folder.Write("Assets/Things/Crate/crate.mtl",
                       "newmtl Wood\nKd 0.25 0.5 0.75\nmap_Kd C:\\art\\planks.png\n");
        WriteText("Main.unity",
                  "--- !u!1 &1\nGameObject:\n  m_Name: Eye\n  m_IsActive: 1\n"
                  "--- !u!4 &2\nTransform:\n  m_GameObject: {fileID: 1}\n  m_Father: {fileID: 0}\n"
                  "--- !u!20 &3\nCamera:\n  m_GameObject: {fileID: 1}\n"
                  "--- !u!1001 &4\nPrefabInstance:\n  m_Modification:\n"
                  "    m_TransformParent: {fileID: 0}\n    m_Modifications: []\n"
                  "  m_SourcePrefab: {fileID: 100100000, guid: " +
                      std::string(32, 'c') + ", type: 3}\n",
                  'f');
    }

    void WriteText(const std::string& name, const std::string& text, char guid)
    {
        m_Folder.Write("Assets/" + name, "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n" + text);
        m_Folder.Write("Assets/" + name + ".meta", "guid: " + std::string(32, guid) + "\n");
    }
    /// Writes a material, and gives it a queue by which it is known again.
    void WriteMaterial(const std::string& path, char guid)
    {
        const int queue = 2100 + guid;
        m_Paths[queue] = path;
        WriteText(path,
                  "--- !u!21 &2100000\nMaterial:\n  m_CustomRenderQueue: " + std::to_string(queue) +
                      "\n  m_Shader: {fileID: 4800000, guid: 933532a4fcc9baf4fa0491de14d08ed7, "
                      "type: 3}\n",
                  guid);
    }
    /// Returns the material that the model has by these lines of its ModelImporter.
    std::shared_ptr<const Material> Load(const std::string& importer)
    {
        const std::string meta = "Assets/Things/Crate/crate.obj.meta";
        m_Folder.Write(meta, "guid: " + std::string(32, 'c') + "\nModelImporter:\n" + importer);
        m_Assets.Forget(m_Folder.path() / meta);
        m_Asset.emplace(LoadScene(m_Folder.path(), m_Assets));
        for (const auto& object : m_Asset->scene.objects())
        {
            if (object->renderer && !object->renderer->sharedMaterials.empty())
            {
                return object->renderer->sharedMaterials.front();
            }
        }
        return nullptr;
    }
    /// Returns the path of a material; "" if it is no file.
    std::string PathOf(const std::shared_ptr<const Material>& material) const
    {
        const auto found = m_Paths.find(material ? material->renderQueue() : 0);
        return found == m_Paths.end() ? "" : found->second;
    }
    std::string PathWith(const std::string& settings)
    {
        return PathOf(Load("  materials:\n" + settings));
    }
    static Color ColorOf(const Material& material)
    {
        return material.GetColor(ShaderPropertyId("_BaseColor"));
    }

    TemporaryFolder m_Folder;
    AssetContext m_Assets;
    std::optional<SceneAsset> m_Asset;
    std::map<int, std::string> m_Paths; ///< by render queue
};

constexpr const char* k_External = "    materialLocation: 0\n";

TEST_F(ModelMaterials, AreFilesThatHaveTheNameOfTheTextureOrOfTheMaterial)
{
    WriteMaterial("Things/Crate/Materials/Wood.mat", 'a');
    EXPECT_EQ("Things/Crate/Materials/Wood.mat",
              PathWith(std::string(k_External) + "    materialName: 0\n"));
    WriteMaterial("Things/Crate/Materials/planks.mat", 'b');
    EXPECT_EQ("Things/Crate/Materials/planks.mat",
              PathWith(std::string(k_External) + "    materialName: 0\n"));
    EXPECT_EQ("Things/Crate/Materials/Wood.mat",
              PathWith(std::string(k_External) + "    materialName: 1\n"));
    WriteMaterial("Things/Crate/Materials/crate-Wood.mat", 'd');
    EXPECT_EQ("Things/Crate/Materials/crate-Wood.mat",
              PathWith(std::string(k_External) + "    materialName: 2\n"));
    EXPECT_EQ("Things/Crate/Materials/planks.mat",
              PathWith(std::string(k_External) + "    materialName: 3\n"));
}

TEST_F(ModelMaterials, AreLookedForInTheFoldersThatTheSettingsName)
{
    const std::string name = std::string(k_External) + "    materialName: 1\n";
    WriteMaterial("Other/Wood.mat", 'a');
    EXPECT_EQ("Other/Wood.mat", PathWith(name + "    materialSearch: 2\n"));
    EXPECT_EQ("", PathWith(name + "    materialSearch: 1\n"));
    WriteMaterial("Materials/Wood.mat", 'b');
    EXPECT_EQ("Materials/Wood.mat", PathWith(name + "    materialSearch: 1\n"));
    EXPECT_EQ("Materials/Wood.mat", PathWith(name + "    materialSearch: 2\n"));
    EXPECT_EQ("", PathWith(name + "    materialSearch: 0\n"));
    WriteMaterial("Things/Materials/Wood.mat", 'd');
    EXPECT_EQ("Things/Materials/Wood.mat", PathWith(name + "    materialSearch: 1\n"));
}

// Unity 2017.2 and older wrote no location.
TEST_F(ModelMaterials, AreFilesWhereNoLocationIsWritten)
{
    WriteMaterial("Things/Crate/Materials/Wood.mat", 'a');
    EXPECT_EQ("Things/Crate/Materials/Wood.mat",
              PathWith("    importMaterials: 1\n    materialName: 1\n    materialSearch: 1\n"));
}

TEST_F(ModelMaterials, AreTheModelsOwnWhereTheSettingsSaySoOrNoFileIsFound)
{
    const Color own(0.25f, 0.5f, 0.75f);
    EXPECT_EQ(own, ColorOf(*Load(std::string("  materials:\n") + k_External)));
    WriteMaterial("Things/Crate/Materials/Wood.mat", 'a');
    EXPECT_EQ(own, ColorOf(*Load("  materials:\n    materialLocation: 1\n")));
    EXPECT_EQ(own, ColorOf(*Load("  meshes:\n    globalScale: 1\n")));
}

TEST_F(ModelMaterials, AreUnitysDefaultWhereNoneIsImported)
{
    WriteMaterial("Things/Crate/Materials/Wood.mat", 'a');
    const Color grey(0.5f, 0.5f, 0.5f);
    EXPECT_EQ(grey, ColorOf(*Load("  materials:\n    importMaterials: 0\n")));
    EXPECT_EQ(grey, ColorOf(*Load("  materials:\n    materialImportMode: 0\n"
                                  "    materialLocation: 1\n")));
}

TEST_F(ModelMaterials, AreThoseThatTheSettingsNameBeforeAllOthers)
{
    WriteMaterial("Things/Crate/Materials/Wood.mat", 'a');
    WriteMaterial("Other/Named.mat", 'b');
    const auto material = Load("  externalObjects:\n  - first:\n      type: UnityEngine:Material\n"
                               "      assembly: UnityEngine.CoreModule\n      name: Wood\n"
                               "    second: {fileID: 2100000, guid: " +
                               std::string(32, 'b') + ", type: 2}\n  materials:\n" + k_External);
    EXPECT_EQ("Other/Named.mat", PathOf(material));
}

} // namespace
} // namespace limn::test

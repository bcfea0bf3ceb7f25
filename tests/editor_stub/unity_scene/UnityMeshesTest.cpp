#include "Mentions.h"
#include "unity_scene/UnityScene.h"

#include "Paths.h"
#include "TemporaryFolder.h"

#include <gmock/gmock.h>
#include <limn/base/WorkerProcess.h>

namespace limn::test
{
namespace
{

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// A mesh of one triangle as text.
std::string TriangleText(const std::string& header, const std::string& more = "")
{
    std::string text = header + "\nMesh:\n  m_Name: Triangle\n  m_SubMeshes:\n"
                                "  - firstByte: 0\n    indexCount: 3\n    topology: 0\n"
                                "    baseVertex: 0\n  m_IndexFormat: 0\n"
                                "  m_IndexBuffer: 000001000200\n  m_VertexData:\n"
                                "    m_VertexCount: 3\n    m_Channels:\n"
                                "    - stream: 0\n      offset: 0\n      format: 0\n"
                                "      dimension: 3\n";
    for (int i = 1; i < 14; ++i)
    {
        text += "    - stream: 0\n      offset: 0\n      format: 0\n      dimension: 0\n";
    }
    // (0, 0, 0), (0, 2, 0), (2, 0, 0)
    return text +
           "    _typelessdata: 000000000000000000000000000000000000004000000000"
           "000000400000000000000000\n" +
           more;
}

/// A project whose one scene has a renderer of each mesh that is asked for.
class MeshesOfAProject : public testing::Test
{
protected:
    MeshesOfAProject()
    {
        ShaderCompilerOptions options;
        options.process = std::make_shared<WorkerProcess>();
        m_Assets.emplace(std::move(options));
    }

    void Write(const std::string& name, const std::string& text, const std::string& guid)
    {
        m_Folder.Write("Assets/" + name, text);
        m_Folder.Write("Assets/" + name + ".meta", "fileFormatVersion: 2\nguid: " + guid + "\n");
    }
    void WriteText(const std::string& name, const std::string& text, const std::string& guid)
    {
        Write(name, k_Head + text, guid);
    }
    /// @param meshes  references
    /// @param more    documents of the scene
    SceneAsset Load(const std::vector<std::string>& meshes, const std::string& more = "")
    {
        std::string text = k_Head + "--- !u!1 &1\nGameObject:\n  m_Name: Eye\n  m_IsActive: 1\n"
                                    "--- !u!4 &2\nTransform:\n  m_GameObject: {fileID: 1}\n"
                                    "  m_Father: {fileID: 0}\n--- !u!20 &3\nCamera:\n"
                                    "  m_GameObject: {fileID: 1}\n  m_Enabled: 1\n";
        int id = 1000;
        for (const std::string& mesh : meshes)
        {
            const std::string object = std::to_string(id);
            text += "--- !u!1 &" + object + "\nGameObject:\n  m_Name: Object" + object +
                    "\n  m_IsActive: 1\n--- !u!4 &" + std::to_string(id + 1) +
                    "\nTransform:\n  m_GameObject: {fileID: " + object +
                    "}\n  m_Father: {fileID: 0}\n--- !u!33 &" + std::to_string(id + 2) +
                    "\nMeshFilter:\n  m_GameObject: {fileID: " + object + "}\n  m_Mesh: " + mesh +
                    "\n--- !u!23 &" + std::to_string(id + 3) +
                    "\nMeshRenderer:\n  m_GameObject: {fileID: " + object +
                    "}\n  m_Enabled: 1\n  m_Materials: []\n";
            id += 10;
        }
        WriteText("Main.unity", text + more, std::string(32, 'f'));
        return LoadScene(m_Folder.path(), *m_Assets);
    }
    static std::string MeshNameOf(SceneAsset& asset, const std::string& object)
    {
        const GameObject* found = asset.scene.Find(object);
        return found != nullptr && found->renderer && found->renderer->mesh
                   ? found->renderer->mesh->name()
                   : "(none)";
    }
    static std::vector<std::string> NotesOf(const SceneAsset& asset)
    {
        std::vector<std::string> notes;
        for (const Diagnostic& note : asset.notes)
        {
            notes.push_back(note.file.substr(note.file.rfind('/') + 1) + ": " + note.message);
        }
        return notes;
    }

    const std::string k_Head = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
    const std::string k_A = std::string(32, 'a');
    const std::string k_B = std::string(32, 'b');
    TemporaryFolder m_Folder;
    std::optional<AssetContext> m_Assets;
};

TEST_F(MeshesOfAProject, MayBeTextInAFileOrInTheSceneItself)
{
    WriteText("Triangle.asset", TriangleText("--- !u!43 &4300000"), k_A);
    SceneAsset asset = Load({"{fileID: 4300000, guid: " + k_A + ", type: 2}", "{fileID: 77}",
                             "{fileID: 4300000, guid: " + k_A + ", type: 2}"},
                            TriangleText("--- !u!43 &77"));
    EXPECT_THAT(NotesOf(asset), testing::Each(testing::Not(HasSubstr("esh"))));
    for (const char* name : {"Object1000", "Object1010", "Object1020"})
    {
        EXPECT_EQ(MeshNameOf(asset, name), "Triangle") << name;
    }
    EXPECT_EQ(asset.scene.Find("Object1000")->renderer->mesh,
              asset.scene.Find("Object1020")->renderer->mesh)
        << "one file is one mesh";
    EXPECT_EQ(asset.scene.Find("Object1010")->renderer->mesh->bounds().extents, glm::vec3(1, 1, 0));
}

TEST_F(MeshesOfAProject, AreLeftOutWithASentenceWhereTheyAreNone)
{
    WriteText("Packed.asset",
              TriangleText("--- !u!43 &4300000",
                           "  m_CompressedMesh:\n    m_Vertices:\n      m_NumItems: 3\n"),
              k_A);
    WriteText("Empty.asset", "--- !u!21 &2100000\nMaterial:\n  m_Name: M\n", k_B);
    Write("Binary.asset", std::string("\0\0\0\0binary", 10), std::string(32, 'c'));
    Write("Pointer.asset", "version https://git-lfs.github.com/spec/v1\n", std::string(32, 'd'));
    const auto reference = [](char guid)
    {
        return "{fileID: 4300000, guid: " + std::string(32, guid) + ", type: 2}";
    };
    SceneAsset asset =
        Load({reference('a'), reference('b'), reference('c'), reference('d'), "{fileID: 1000}",
              "{fileID: 10202, guid: 0000000000000000e000000000000000, type: 0}"});
    const std::vector<std::string> notes = NotesOf(asset);
    EXPECT_THAT(notes, Contains(HasSubstr("Packed.asset: the mesh is compressed")));
    EXPECT_THAT(notes, Contains(HasSubstr("Empty.asset has no mesh with the id 4300000")));
    EXPECT_THAT(notes, Contains(HasSubstr("Binary.asset: this asset is saved as binary")));
    EXPECT_THAT(notes, Contains(HasSubstr("Pointer.asset: this is a pointer of Git LFS")));
    EXPECT_THAT(notes, Contains(HasSubstr("refers to an object that is no mesh")));
    for (const char* name : {"Packed.asset", "Binary.asset", "Pointer.asset"})
    {
        EXPECT_THAT(notes,
                    Contains(Mentions("m_Mesh", name, "cannot be read", "nothing is drawn")));
    }
    EXPECT_EQ(MeshNameOf(asset, "Object1000"), "(none)");
    EXPECT_NE(MeshNameOf(asset, "Object1050"), "(none)") << "the rest is drawn";
}

TEST_F(MeshesOfAProject, DoNotEndTheProgramWhereTheImporterCrashes)
{
    std::filesystem::create_directories(m_Folder / "Assets");
    for (const char* name : {"Good.fbx", "Bad.fbx"})
    {
        std::filesystem::copy_file(SourcePath("tests/fuzz/model_seeds/flag.fbx"),
                                   m_Folder / ("Assets/" + std::string(name)));
        m_Folder.Write("Assets/" + std::string(name) + ".meta",
                       "fileFormatVersion: 2\nguid: " + (*name == 'G' ? k_A : k_B) +
                           "\nModelImporter:\n  fileIDToRecycleName:\n    4300000: Flag\n");
    }
    setenv("LIMN_TEST_ABORT", "Bad.fbx", 1);
    ShaderCompilerOptions options;
    options.process = std::make_shared<WorkerProcess>();
    m_Assets.emplace(std::move(options));
    unsetenv("LIMN_TEST_ABORT");
    SceneAsset asset = Load({"{fileID: 4300000, guid: " + k_B + ", type: 3}",
                             "{fileID: 4300000, guid: " + k_A + ", type: 3}"});
    EXPECT_EQ(MeshNameOf(asset, "Object1000"), "(none)");
    EXPECT_EQ(MeshNameOf(asset, "Object1010"), "Flag");
    EXPECT_THAT(NotesOf(asset),
                Contains(Mentions("Bad.fbx:", "importer stopped", "signal 6")).Times(1));
    EXPECT_THAT(NotesOf(asset),
                Contains(Mentions("m_Mesh", "Bad.fbx", "cannot be read", "nothing is drawn")));
}

} // namespace
} // namespace limn::test

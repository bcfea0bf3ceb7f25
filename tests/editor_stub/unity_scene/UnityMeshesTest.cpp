#include "IsNear.h"
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

/// TriangleText with bones 0, 1 and both for its vertices. The second bone lies at (0, 2, 0).
std::string SkinnedTriangleText(const std::string& header)
{
    std::string text = TriangleText(header);
    const auto replace = [&text](const std::string& from, const std::string& to)
    {
        text.replace(text.rfind(from), from.size(), to);
    };
    const std::string none = "    - stream: 0\n      offset: 0\n      format: 0\n"
                             "      dimension: 0\n";
    replace(none + none,
            "    - stream: 0\n      offset: 12\n      format: 0\n      dimension: 2\n"
            "    - stream: 0\n      offset: 20\n      format: 10\n      dimension: 2\n");
    const std::string one = "0000803f";
    const std::string half = "0000003f";
    const std::string two = "00000040";
    const std::string zero = "00000000";
    const std::string second = "01000000"; // a bone's number
    replace(text.substr(text.rfind("_typelessdata")),
            "_typelessdata: " + zero + zero + zero + one + zero + zero + zero + //
                zero + two + zero + one + zero + second + zero +                //
                two + zero + zero + half + half + second + zero + "\n");
    const auto pose = [](const char* y)
    {
        std::string rows;
        for (int i = 0; i < 16; ++i)
        {
            rows += (i == 0 ? "  - e" : "    e") + std::to_string(i / 4) + std::to_string(i % 4) +
                    ": " +
                    (i == 7       ? y
                     : i % 5 == 0 ? "1"
                                  : "0") +
                    "\n";
        }
        return rows;
    };
    return text + "  m_BindPose:\n" + pose("0") + pose("-2");
}

/// Returns the documents of an object.
/// @param more  fields of its Transform
std::string ObjectText(int id, const std::string& name, const std::string& more)
{
    return "--- !u!1 &" + std::to_string(id) + "\nGameObject:\n  m_Name: " + name +
           "\n  m_IsActive: 1\n--- !u!4 &" + std::to_string(id + 1) +
           "\nTransform:\n  m_GameObject: {fileID: " + std::to_string(id) +
           "}\n  m_Father: {fileID: 0}\n" + more;
}

/// Three objects: a skinned renderer and, at (1, 0, 0) and (0, 3, 0), its bones.
std::string SkinnedObjects(const std::string& mesh, const std::string& bones)
{
    return ObjectText(50, "Skinned",
                      "  m_LocalPosition: {x: 5, y: 6, z: 7}\n"
                      "  m_LocalRotation: {x: 0.70710678, y: 0, z: 0, w: 0.70710678}\n") +
           "--- !u!137 &52\nSkinnedMeshRenderer:\n  m_GameObject: {fileID: 50}\n"
           "  m_Enabled: 1\n  m_Materials: []\n  m_Mesh: " +
           mesh + "\n  m_Bones:\n" + bones +
           ObjectText(60, "First", "  m_LocalPosition: {x: 1, y: 0, z: 0}\n") +
           ObjectText(70, "Second", "  m_LocalPosition: {x: 0, y: 3, z: 0}\n");
}

std::vector<glm::vec3> WorldVertices(SceneAsset& asset, const std::string& object)
{
    const GameObject& found = *asset.scene.Find(object);
    std::vector<glm::vec3> places;
    for (const glm::vec3& vertex : found.renderer->mesh->data().vertices)
    {
        places.emplace_back(found.transform.worldMatrix() * glm::dvec4(glm::dvec3(vertex), 1.0));
    }
    return places;
}

TEST_F(MeshesOfAProject, AreWhereTheirBonesPutThem)
{
    SceneAsset asset =
        Load({}, SkinnedTriangleText("--- !u!43 &77") +
                     SkinnedObjects("{fileID: 77}", "  - {fileID: 61}\n  - {fileID: 71}\n"));
    EXPECT_THAT(NotesOf(asset), testing::Each(testing::Not(HasSubstr("m_Bones"))));
    // By hand: the first bone moves by (1, 0, 0), the second by (0, 1, 0) from its bind pose, and
    // the object's own place does not matter.
    EXPECT_THAT(WorldVertices(asset, "Skinned"),
                testing::ElementsAre(IsNear(glm::vec3(1, 0, 0)), IsNear(glm::vec3(0, 3, 0)),
                                     IsNear(glm::vec3(2.5f, 0.5f, 0))));
}

TEST_F(MeshesOfAProject, AreAtRestWithASentenceWhereBonesAreMissing)
{
    SceneAsset asset =
        Load({}, SkinnedTriangleText("--- !u!43 &77") +
                     SkinnedObjects("{fileID: 77}", "  - {fileID: 61}\n  - {fileID: 999}\n"));
    EXPECT_THAT(NotesOf(asset),
                Contains(Mentions("m_Bones", "lacks 1 bone of the 2", "Triangle", "at rest")));
    EXPECT_THAT(WorldVertices(asset, "Skinned"),
                testing::ElementsAre(IsNear(glm::vec3(5, 6, 7)), IsNear(glm::vec3(5, 6, 9)),
                                     IsNear(glm::vec3(7, 6, 7))));
}

TEST_F(MeshesOfAProject, AreAtRestWithASentenceWhereNoBoneIsListed)
{
    const SceneAsset asset =
        Load({}, SkinnedTriangleText("--- !u!43 &77") + SkinnedObjects("{fileID: 77}", ""));
    EXPECT_THAT(NotesOf(asset), Contains(Mentions("m_Bones", "lacks 2 bones of the 2", "at rest")));
}

TEST_F(MeshesOfAProject, AreAtRestWithASentenceWhereTheyHaveNoWeights)
{
    SceneAsset asset =
        Load({}, TriangleText("--- !u!43 &77") +
                     SkinnedObjects("{fileID: 77}", "  - {fileID: 61}\n  - {fileID: 71}\n"));
    EXPECT_THAT(NotesOf(asset),
                Contains(Mentions("m_Bones", "no bone weights", "Triangle", "at rest")));
}

/// A figure of an FBX whose one bone, a child of a node that is turned, moves all of it.
TEST_F(MeshesOfAProject, OfAModelFollowTheBonesOfItsInstance)
{
    std::filesystem::create_directories(m_Folder / "Assets");
    std::filesystem::copy_file(SourcePath("tests/fuzz/model_seeds/figure.fbx"),
                               m_Folder / "Assets/Figure.fbx");
    m_Folder.Write("Assets/Figure.fbx.meta", "fileFormatVersion: 2\nguid: " + k_A +
                                                 "\nModelImporter:\n  fileIDToRecycleName:\n"
                                                 "    400000: Body\n    400002: Hips\n"
                                                 "    4300000: Body\n    13700000: Body\n");
    const auto modification = [&](const char* target, const char* path, const char* value)
    {
        return "    - target: {fileID: " + std::string(target) + ", guid: " + k_A +
               ", type: 3}\n      propertyPath: " + path + "\n      value: " + value +
               "\n      objectReference: {fileID: 0}\n";
    };
    // The body is turned onto its back, as old scenes have it, and the bone is lifted by 3 m.
    SceneAsset asset =
        Load({}, "--- !u!1001 &50\nPrefabInstance:\n  m_Modification:\n"
                 "    m_TransformParent: {fileID: 0}\n    m_Modifications:\n" +
                     modification("400000", "m_LocalRotation.x", "-0.70710678") +
                     modification("400000", "m_LocalRotation.w", "0.70710678") +
                     modification("400002", "m_LocalPosition.y", "4") +
                     "  m_SourcePrefab: {fileID: 100100000, guid: " + k_A + ", type: 3}\n");
    EXPECT_THAT(NotesOf(asset), testing::Each(testing::Not(HasSubstr("m_Bones"))));
    // By hand: (0, 0, 0), (1, 0, 0), (0, 2, 0) and (-1, 0, 0) metres, x turned over, and 3 m up.
    // The triangles' uv are mirrored, so that two vertices are there twice.
    EXPECT_THAT(
        WorldVertices(asset, "Body"),
        testing::UnorderedElementsAre(IsNear(glm::vec3(0, 3, 0)), IsNear(glm::vec3(0, 3, 0)),
                                      IsNear(glm::vec3(-1, 3, 0)), IsNear(glm::vec3(1, 3, 0)),
                                      IsNear(glm::vec3(0, 5, 0)), IsNear(glm::vec3(0, 5, 0))));
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

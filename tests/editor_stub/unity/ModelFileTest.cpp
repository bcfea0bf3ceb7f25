#include "unity/ModelFile.h"

#include "TemporaryFolder.h"
#include <gmock/gmock.h>
#include <limn/base/Diagnostic.h>

namespace limn::test
{
namespace
{

using testing::HasSubstr;

// unity_project.md 4.2: ids that were found in projects that Unity saved.
TEST(HashedFileID, IsUnitysOwn)
{
    EXPECT_EQ(HashedFileID("Type:GameObject->//RootNode/root0"), 919132149155446097);
    EXPECT_EQ(HashedFileID("Type:Transform->//RootNode/root/Transform0"), -8679921383154817045);
    EXPECT_EQ(HashedFileID("Type:Mesh->\xE6\xA3\xB1\xE8\xA7\x92\xE7\x90\x83"
                           "0"),
              6644018162127945665);
    EXPECT_EQ(HashedFileID("Type:Mesh->Arch_B0"), -8834942029629640327);
    EXPECT_EQ(HashedFileID("Type:Mesh->obj_screw_new0"), -1351841031486281740);
}

/// Two triangles, each with a material of its own, with uv and normals towards +z.
constexpr std::string_view k_Obj = "o Flag\n"
                                   "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n"
                                   "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                   "vn 0 0 1\n"
                                   "usemtl red\nf 1/1/1 2/2/1 3/3/1\n"
                                   "usemtl blue\nf 1/1/1 3/3/1 4/4/1\n";

class ModelOfAFile : public testing::Test
{
protected:
    Model Load(const ModelImport& import = {})
    {
        return LoadModel(m_Folder.Write("Flag.obj", k_Obj), import);
    }
    TemporaryFolder m_Folder;
};

TEST_F(ModelOfAFile, HasUnitysAxesAndWinding)
{
    const Model model = Load();
    ASSERT_EQ(model.meshes.size(), 1u);
    const Mesh& mesh = *model.meshes.front();
    // x is turned over; the front is clockwise seen from +z, where the normals point.
    EXPECT_EQ(mesh.bounds().center, glm::vec3(-1.0f, 0.5f, 0.0f));
    ASSERT_EQ(mesh.subMeshCount(), 2);
    const MeshData& data = mesh.data();
    for (std::size_t i = 0; i < data.triangles.size(); i += 3)
    {
        const glm::vec3 a = data.vertices[data.triangles[i]];
        const glm::vec3 b = data.vertices[data.triangles[i + 1]];
        const glm::vec3 c = data.vertices[data.triangles[i + 2]];
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), data.normals[data.triangles[i]]), 0.0f);
    }
    for (std::size_t i = 0; i < data.vertices.size(); ++i)
    {
        EXPECT_EQ(data.normals[i], glm::vec3(0, 0, 1));
        EXPECT_EQ(data.uv[i], glm::vec2(data.vertices[i].x * -0.5f, data.vertices[i].y));
    }
}

TEST_F(ModelOfAFile, IsScaledAsItsImporterSays)
{
    ModelImport import;
    import.globalScale = 0.1f;
    EXPECT_FLOAT_EQ(Load(import).meshes.front()->bounds().extents.x, 0.1f);
}

TEST_F(ModelOfAFile, IsFoundByItsHashOrItsTable)
{
    ModelImport import;
    const Model model = Load(import);
    const std::string name = model.meshes.front()->name();
    EXPECT_EQ(model.FindMesh(HashedFileID("Type:Mesh->" + name + "0")), model.meshes.front());
    EXPECT_EQ(model.FindMesh(17), nullptr);
    import.names[4300000] = name;
    const Model old = Load(import);
    EXPECT_EQ(old.FindMesh(4300000), old.meshes.front());
}

TEST_F(ModelOfAFile, IsAPrefabWithItsMaterials)
{
    ModelImport import;
    import.materials["red"] = {2100000, "0123456789abcdef0123456789abcdef"};
    const std::string text = PrefabTextOf(Load(import), "fedcba9876543210fedcba9876543210");
    EXPECT_THAT(text, HasSubstr("guid: 0123456789abcdef0123456789abcdef"));
    const UnityFile file(text, "Flag.obj");
    int renderers = 0;
    for (const UnityHeader& header : file.headers())
    {
        renderers += header.classID == static_cast<int>(UnityClass::MeshRenderer) ? 1 : 0;
    }
    EXPECT_EQ(renderers, 1);
}

TEST_F(ModelOfAFile, IsRefusedWhereItIsBroken)
{
    EXPECT_THROW(LoadModel(m_Folder.Write("a.fbx", "no model at all"), {}), AssetError);
    EXPECT_THROW(LoadModel(m_Folder / "none.fbx", {}), AssetError);
    try
    {
        LoadModel(m_Folder.Write("b.fbx", "version https://git-lfs.github.com/spec/v1\n"), {});
        FAIL();
    }
    catch (const AssetError& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("pointer of Git LFS"));
    }
}

} // namespace
} // namespace limn::test

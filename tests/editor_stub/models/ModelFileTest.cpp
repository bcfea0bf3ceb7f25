#include "models/ModelFile.h"

#include "models/AssimpModel.h"

#include "IsNear.h"
#include "Mentions.h"
#include "Paths.h"
#include "TemporaryFolder.h"
#include "core/ThrownMessage.h"
#include "plugins/PluginRun.h"
#include <fstream>
#include <gmock/gmock.h>
#include <limn/base/Diagnostic.h>
#include <limn/base/ReadFile.h>
#include <limn/base/WorkerProcess.h>
#include <limn/core/PrimitiveMesh.h>

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

TEST(Assimp, IsMissedInASentence)
{
    EXPECT_THAT(
        ThrownMessage<AssetError>([] { FindInAssimp("/none/libassimp.so.5", "aiFree"); }),
        Mentions("/none/libassimp.so.5:", "no model can be read", "no such file", "libassimp5"));
    EXPECT_THAT(
        ThrownMessage<AssetError>([] { FindInAssimp(BuiltPlugin("no_plugin.so"), "aiFree"); }),
        Mentions("no model can be read", "lacks aiFree"));
}

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

TEST_F(ModelOfAFile, IsAllOfItsFirstPartWhereUnityHasSplitIt)
{
    ModelImport import;
    const std::string name = Load(import).meshes.front()->name();
    import.names[4300000] = name + "_MeshPart0";
    import.names[4300002] = name + "_MeshPart1";
    import.names[4300004] = "Other_MeshPart0";
    Model model = Load(import);
    model.meshes.push_back(CreatePrimitive(PrimitiveType::Quad));
    EXPECT_EQ(model.FindMesh(4300000), model.meshes.front());
    EXPECT_FALSE(model.isLaterPart(4300000));
    EXPECT_EQ(model.FindMesh(4300002), nullptr);
    EXPECT_TRUE(model.isLaterPart(4300002));
    EXPECT_EQ(model.FindMesh(4300004), nullptr);
    EXPECT_FALSE(model.isLaterPart(4300004));
    // The file's own mesh may have such a name.
    const MeshData& quad = model.meshes.back()->data();
    model.meshes.push_back(std::make_shared<const Mesh>(name + "_MeshPart1", quad));
    EXPECT_EQ(model.FindMesh(4300002), model.meshes.back());
    EXPECT_FALSE(model.isLaterPart(4300002));
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

// Unity numbers what has the same name; one id for two objects would make the prefab unreadable.
TEST(ModelPrefab, MayHaveSeveralPartsOfOneName)
{
    ModelImport table; // as Unity until 2019.2 names them
    for (const int first : {100'000, 400'000, 2'300'000, 3'300'000, 4'300'000})
    {
        table.names[first] = "Leg";
        table.names[first + 2] = "Leg";
    }
    for (const ModelImport& import : {ModelImport(), table})
    {
        Model model;
        model.import = import;
        model.nodes.emplace_back().name = "Table";
        for (std::size_t i = 0; i < 2; ++i)
        {
            MeshData data = CreatePrimitive(PrimitiveType::Quad)->data();
            data.vertices.front().z = static_cast<float>(i);
            model.meshes.push_back(std::make_shared<const Mesh>("Leg", std::move(data)));
            model.skins.emplace_back();
            ModelNode& leg = model.nodes.emplace_back();
            leg.name = "Leg";
            leg.mesh = i;
        }
        const UnityFile file(PrefabTextOf(model, std::string(32, 'a')), "Table.fbx");
        std::vector<std::shared_ptr<const Mesh>> shown;
        for (const UnityHeader& header : file.headers())
        {
            if (header.classID == static_cast<int>(UnityClass::MeshFilter))
            {
                shown.push_back(
                    model.FindMesh(ReadUnityReference(file.Fields(header)["m_Mesh"]).fileID));
            }
        }
        EXPECT_EQ(model.meshes, shown);
    }
}

/// An FBX file of the tests' own: a node with a pivot, two polygons of a material each, colours and
/// two sets of uv.
class ModelOfAnFbx : public testing::Test
{
protected:
    ModelOfAnFbx()
    {
        std::filesystem::copy_file(SourcePath("tests/fuzz/model_seeds/flag.fbx"), m_File);
    }

    Importer Isolated(bool isKept = false,
                      std::chrono::milliseconds limit = std::chrono::minutes(1))
    {
        Importer::Options options;
        options.process = std::make_shared<WorkerProcess>();
        options.cacheFolder = isKept ? m_Folder / "cache" : std::filesystem::path();
        options.timeLimit = limit;
        return Importer(options);
    }
    std::string ProblemOf(const std::string& bytes, const Importer& importer)
    {
        try
        {
            LoadModel(m_Folder.Write("broken.fbx", bytes), {}, importer);
        }
        catch (const AssetError& error)
        {
            EXPECT_EQ(error.diagnostics().front().file, (m_Folder / "broken.fbx").generic_string());
            return error.diagnostics().front().message;
        }
        return "";
    }

    TemporaryFolder m_Folder;
    std::filesystem::path m_File = m_Folder / "Banner.fbx";
};

/// All that is drawn of a model.
void ExpectSameModel(const Model& a, const Model& b)
{
    ASSERT_EQ(a.meshes.size(), b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i)
    {
        EXPECT_EQ(a.meshes[i]->name(), b.meshes[i]->name());
        const MeshData& one = a.meshes[i]->data();
        const MeshData& other = b.meshes[i]->data();
        for (const VertexAttribute& attribute : VertexAttributes())
        {
            EXPECT_TRUE(std::ranges::equal(attribute.values(one), attribute.values(other)))
                << attribute.array;
        }
        EXPECT_EQ(one.triangles, other.triangles);
        EXPECT_EQ(one.subMeshes, other.subMeshes);
    }
    const std::string guid(32, 'a');
    EXPECT_EQ(PrefabTextOf(a, guid), PrefabTextOf(b, guid));
    ASSERT_EQ(a.materials.size(), b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i)
    {
        EXPECT_EQ(a.materials[i].name, b.materials[i].name);
        EXPECT_EQ(a.materials[i].color, b.materials[i].color);
    }
}

// 3ds Max writes files whose z is up. A point (x, y, z) of the file is (x, z, -y) where y is up.
TEST_F(ModelOfAnFbx, IsTurnedWhereItsZIsUp)
{
    std::string text = ReadFile(m_File);
    for (const auto& [axis, value] :
         {std::pair("\"UpAxis\"", "2"), {"\"FrontAxis\"", "1"}, {"\"FrontAxisSign\"", "-1"}})
    {
        const std::size_t end = text.find('\n', text.find(axis));
        text.replace(end - 1, 1, value);
    }
    const Model plain = LoadModel(m_File, {});
    const Model turned = LoadModel(m_Folder.Write("Turned.fbx", text), {});
    ModelImport bakes;
    bakes.bakesAxisConversion = true;
    const Model baked = LoadModel(m_Folder / "Turned.fbx", bakes);

    const auto vertices = [](const Model& model)
    {
        return model.meshes.front()->data().vertices;
    };
    const auto placed = [](const Model& model, const glm::vec3& vertex)
    {
        const ModelNode& node = model.nodes.front();
        return node.position + node.rotation * (node.scale * vertex);
    };
    EXPECT_EQ(vertices(turned), vertices(plain)) << "the node alone is turned";
    ASSERT_EQ(vertices(baked).size(), vertices(plain).size());
    for (std::size_t i = 0; i < vertices(plain).size(); ++i)
    {
        const glm::vec3 v = vertices(plain)[i];
        const glm::vec3 p = placed(plain, v);
        EXPECT_THAT(vertices(baked)[i], IsNear(glm::vec3(v.x, v.z, -v.y)));
        EXPECT_THAT(placed(turned, v), IsNear(glm::vec3(p.x, p.z, -p.y)));
        EXPECT_THAT(placed(baked, vertices(baked)[i]), IsNear(glm::vec3(p.x, p.z, -p.y)));
        const glm::vec3 n = plain.meshes.front()->data().normals[i];
        EXPECT_THAT(baked.meshes.front()->data().normals[i], IsNear(glm::vec3(n.x, n.z, -n.y)));
    }
}

TEST_F(ModelOfAnFbx, HasItsOriginAtThePivotInMetres)
{
    const Model model = LoadModel(m_File, {});
    ASSERT_EQ(model.nodes.size(), 1u) << "the one node at the top is the root";
    const ModelNode& node = model.nodes.front();
    EXPECT_EQ(node.name, "Banner");
    // Translation (100, 0, 0) and pivot (10, 20, 30), in centimetres, x turned over.
    EXPECT_NEAR(node.position.x, -1.1f, 1e-6f);
    EXPECT_NEAR(node.position.y, 0.2f, 1e-6f);
    EXPECT_NEAR(node.position.z, 0.3f, 1e-6f);
    // 90 degrees about y, turned over with x.
    EXPECT_NEAR(node.rotation.y, -std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(node.rotation.w, std::sqrt(0.5f), 1e-6f);
    ASSERT_EQ(model.meshes.size(), 1u);
    EXPECT_EQ(model.meshes.front()->name(), "Flag");
    const Bounds& bounds = model.meshes.front()->bounds();
    EXPECT_NEAR(bounds.center.x, -1.4f, 1e-6f); // 0 to 300, less 10
    EXPECT_NEAR(bounds.extents.x, 1.5f, 1e-6f);
    EXPECT_NEAR(bounds.center.y, 0.3f, 1e-6f); // 0 to 100, less 20
    EXPECT_NEAR(bounds.center.z, 0.2f, 1e-6f); // 0 to 100, less 30
    EXPECT_THAT(node.materials, testing::ElementsAre("red", "blue"));
}

TEST_F(ModelOfAnFbx, HasItsColoursUvAndTangents)
{
    const Model model = LoadModel(m_File, {});
    const MeshData& data = model.meshes.at(0)->data();
    ASSERT_EQ(data.vertices.size(), 8u);
    ASSERT_EQ(data.subMeshes.size(), 2u);
    EXPECT_EQ(data.subMeshes[0], (SubMesh{0, 6}));
    EXPECT_EQ(data.subMeshes[1], (SubMesh{6, 6}));
    ASSERT_EQ(data.colors.size(), 8u);
    EXPECT_EQ(data.colors[data.triangles[0]], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(data.colors[data.triangles[6]], glm::vec4(0, 0.5f, 0, 0.25f));
    ASSERT_EQ(data.uv2.size(), 8u);
    EXPECT_TRUE(data.uv3.empty());
    ASSERT_EQ(data.tangents.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i)
    {
        const bool isFlat = data.normals[i].z > 0.99f;
        const float second = isFlat ? 0.1f : 0.5f;
        EXPECT_GE(data.uv2[i].x, second);
        EXPECT_LE(data.uv2[i].x, second + 0.101f);
        // u grows with the file's x, which is Unity's -x; v grows upwards.
        EXPECT_LT(data.tangents[i].x, -0.7f);
        const glm::vec3 up =
            glm::cross(data.normals[i], glm::vec3(data.tangents[i])) * data.tangents[i].w;
        EXPECT_GT(up.y, 0.99f);
    }
}

TEST_F(ModelOfAnFbx, HasTheTangentsAndUvThatItsImporterSays)
{
    ModelImport import;
    import.tangents = ModelTangents::None;
    import.swapUVChannels = true;
    const Model model = LoadModel(m_File, import);
    const MeshData& data = model.meshes.at(0)->data();
    EXPECT_TRUE(data.tangents.empty());
    EXPECT_EQ(data.uv[data.triangles[0]].y > 0.05f, true) << "those of the light map";
    const std::string meta = "ModelImporter:\n  meshes:\n    swapUVChannels: 1\n"
                             "    bakeAxisConversion: 1\n"
                             "    globalScale: nan\n  tangentSpace:\n"
                             "    tangentImportMode: 2\n    normalSmoothAngle: 1e9\n";
    const ModelImport read = ReadModelImport(UnityTree(meta, "a.meta", 1).root());
    EXPECT_EQ(read.tangents, ModelTangents::None);
    EXPECT_TRUE(read.swapUVChannels);
    EXPECT_TRUE(read.bakesAxisConversion);
    EXPECT_FALSE(ModelImport().bakesAxisConversion);
    EXPECT_EQ(read.globalScale, 1.0f);
    EXPECT_EQ(read.normalSmoothAngle, 60.0f);
    EXPECT_EQ(ModelImport().tangents, ModelTangents::CalculateMikk);
}

TEST_F(ModelOfAnFbx, IsTheSameFromAnotherProcessAndFromTheCache)
{
    const Model here = LoadModel(m_File, {});
    ExpectSameModel(here, LoadModel(m_File, {}, Isolated()));
    const Importer keeping = Isolated(true);
    ExpectSameModel(here, LoadModel(m_File, {}, keeping));
    // No worker could answer within no time: what comes is what was kept.
    const Importer hurried = Isolated(true, std::chrono::milliseconds(1));
    ExpectSameModel(here, LoadModel(m_File, {}, hurried));
    ModelImport other;
    other.globalScale = 2.0f;
    EXPECT_NEAR(LoadModel(m_File, other, keeping).meshes.at(0)->bounds().extents.x, 3.0f, 1e-5f)
        << "other settings are another import";
}

TEST_F(ModelOfAnFbx, CostsOnlyItselfWhereTheImporterCrashesOnIt)
{
    setenv("LIMN_TEST_ABORT", "broken.fbx", 1);
    const Importer importer = Isolated();
    unsetenv("LIMN_TEST_ABORT");
    EXPECT_THAT(ProblemOf("x", importer),
                Mentions("model", "importer stopped", "Aborted", "signal"));
    EXPECT_EQ(LoadModel(m_File, {}, importer).meshes.size(), 1u);
    EXPECT_THAT(ProblemOf("", Importer()), Mentions("empty", "a model"))
        << "assimp ends the program on it";
}

TEST_F(ModelOfAnFbx, IsRefusedWithASentenceWhereItIsCutOff)
{
    const std::string whole = ReadFile(m_File);
    const Importer importer = Isolated();
    for (std::size_t size = 0; size < whole.size(); size += 97)
    {
        ProblemOf(whole.substr(0, size), importer); // a model or a sentence
    }
    EXPECT_NE(ProblemOf(whole.substr(0, whole.size() / 2), importer), "");
}

TEST_F(ModelOfAFile, IsImportedAgainWhenItsMaterialsChange)
{
    Importer::Options options;
    options.cacheFolder = m_Folder / "cache";
    const auto colorWith = [&](const std::string& material)
    {
        m_Folder.Write("flag.mtl", "newmtl red\nKd " + material + "\n");
        const Model model =
            LoadModel(m_Folder.Write("Flag.obj", "mtllib flag.mtl\n" + std::string(k_Obj)), {},
                      Importer(options));
        for (const ModelMaterial& found : model.materials)
        {
            if (found.name == "red")
            {
                return found.color.r;
            }
        }
        return -1.0f;
    };
    EXPECT_EQ(colorWith("1 0 0"), 1.0f);
    EXPECT_EQ(colorWith("0.5 0 0"), 0.5f);
}

} // namespace
} // namespace limn::test

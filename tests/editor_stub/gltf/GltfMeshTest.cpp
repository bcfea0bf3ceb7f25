#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limn/editor_stub/GltfMesh.h>

#include "TemporaryFolder.h"
#include "gltf/GltfFile.h"

namespace limn
{
namespace
{

using test::GltfFile;
using test::OnePrimitive;
using Indices = std::vector<std::uint32_t>;

std::shared_ptr<const Mesh> Load(const std::string& content, const std::string& name = "a.gltf")
{
    const test::TemporaryFolder folder;
    return LoadGltfMesh(folder.Write(name, content));
}

/// A counter-clockwise triangle in glTF's xy plane, so it faces +z.
const std::vector<float> k_Triangle = {1, 0, 0, 3, 0, 0, 1, 2, 0};

std::shared_ptr<const Mesh> LoadTriangle(const std::string& node)
{
    GltfFile file;
    const int position = file.AddFloats("VEC3", k_Triangle);
    return Load(file.Text(
        OnePrimitive(R"("attributes": {"POSITION": )" + std::to_string(position) + "}", node)));
}

std::vector<glm::vec3> Corners(const Mesh& mesh)
{
    std::vector<glm::vec3> corners;
    for (const std::uint32_t index : mesh.data().triangles)
    {
        corners.push_back(mesh.data().vertices.at(index));
    }
    return corners;
}

/// The side that a clockwise triangle shows in a left-handed space.
glm::vec3 FacingOf(const Mesh& mesh)
{
    const std::vector<glm::vec3> corners = Corners(mesh);
    return glm::normalize(glm::cross(corners.at(1) - corners.at(0), corners.at(2) - corners.at(0)));
}

void ExpectNear(glm::vec3 actual, glm::vec3 expected)
{
    EXPECT_LT(glm::length(actual - expected), 1e-5f)
        << actual.x << ' ' << actual.y << ' ' << actual.z << " for " << expected.x << ' '
        << expected.y << ' ' << expected.z;
}

TEST(GltfMesh, NegatesXAndReversesTheTriangles)
{
    const auto mesh = LoadTriangle("");
    EXPECT_EQ(mesh->data().vertices, (std::vector<glm::vec3>{{-1, 0, 0}, {-3, 0, 0}, {-1, 2, 0}}));
    EXPECT_EQ(mesh->data().triangles, (Indices{0, 2, 1}));
    ExpectNear(FacingOf(*mesh), {0, 0, 1});
}

TEST(GltfMesh, MakesMissingNormalsFlat)
{
    const auto mesh = LoadTriangle("");
    ASSERT_EQ(mesh->data().normals.size(), 3u);
    for (const glm::vec3& normal : mesh->data().normals)
    {
        ExpectNear(normal, {0, 0, 1});
    }
}

TEST(GltfMesh, MakesTheNormalsOfATriangleWithoutAreaPointUp)
{
    GltfFile file;
    file.AddFloats("VEC3", {1, 0, 0, 2, 0, 0, 3, 0, 0});
    const auto mesh = Load(file.Text(OnePrimitive(R"("attributes": {"POSITION": 0})")));
    EXPECT_EQ(mesh->data().normals, std::vector(3, glm::vec3(0, 1, 0)));
}

TEST(GltfMesh, IsNamedAfterTheFile)
{
    EXPECT_EQ(LoadTriangle("")->name(), "a");
}

TEST(GltfMesh, ReadsEveryVertexAttribute)
{
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    file.AddFloats("VEC3", {0.6f, 0, 0.8f, 0.6f, 0, 0.8f, 0.6f, 0, 0.8f});
    file.AddFloats("VEC4", {0.8f, 0, -0.6f, 1, 0.8f, 0, -0.6f, 1, 0.8f, 0, -0.6f, -1});
    file.AddFloats("VEC2", {0, 0, 1, 0, 0.25f, 0.75f});
    file.AddFloats("VEC4", {1, 0, 0, 1, 0, 1, 0, 0.5f, 0, 0, 1, 0});
    const auto mesh = Load(file.Text(OnePrimitive(
        R"("attributes": {"POSITION": 0, "NORMAL": 1, "TANGENT": 2, "TEXCOORD_0": 3, "COLOR_0": 4, "TEXCOORD_1": 3})")));
    const MeshData& data = mesh->data();
    ExpectNear(data.normals.at(0), {-0.6f, 0, 0.8f});
    ExpectNear(glm::vec3(data.tangents.at(0)), {-0.8f, 0, -0.6f});
    EXPECT_EQ(data.tangents.at(0).w, -1.0f);
    EXPECT_EQ(data.tangents.at(2).w, 1.0f);
    EXPECT_EQ(data.uv, (std::vector<glm::vec2>{{0, 1}, {1, 1}, {0.25f, 0.25f}}));
    EXPECT_EQ(data.uv2, (std::vector<glm::vec4>{{0, 1, 0, 0}, {1, 1, 0, 0}, {0.25f, 0.25f, 0, 0}}));
    EXPECT_EQ(data.colors, (std::vector<glm::vec4>{{1, 0, 0, 1}, {0, 1, 0, 0.5f}, {0, 0, 1, 0}}));
}

TEST(GltfMesh, ReadsNormalizedIntegersAndOpaqueColours)
{
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    file.AddIntegers<std::uint16_t>("VEC2", {0, 65535, 13107, 0, 0, 0}, true);
    // Vertex colours are padded to four bytes only in real files; three tight ones are as valid.
    file.AddIntegers<std::uint8_t>("VEC3", {255, 0, 51, 0, 0, 0, 0, 0, 0}, true);
    const auto mesh = Load(
        file.Text(OnePrimitive(R"("attributes": {"POSITION": 0, "TEXCOORD_0": 1, "COLOR_0": 2})")));
    EXPECT_EQ(mesh->data().uv.at(0), glm::vec2(0, 0));
    EXPECT_FLOAT_EQ(mesh->data().uv.at(1).x, 0.2f);
    EXPECT_FLOAT_EQ(mesh->data().colors.at(0).z, 0.2f);
    EXPECT_EQ(mesh->data().colors.at(0).w, 1.0f);
}

template <typename Index>
class GltfMeshIndices : public ::testing::Test
{
};
using IndexTypes = ::testing::Types<std::uint8_t, std::uint16_t, std::uint32_t>;
TYPED_TEST_SUITE(GltfMeshIndices, IndexTypes);

TYPED_TEST(GltfMeshIndices, AreReadInEachWidth)
{
    GltfFile file;
    file.AddFloats("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    file.AddFloats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    file.AddIndices<TypeParam>({0, 1, 2, 0, 2, 3});
    const auto mesh = Load(
        file.Text(OnePrimitive(R"("attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2)")));
    EXPECT_EQ(mesh->data().vertices.size(), 4u);
    EXPECT_EQ(mesh->data().triangles, (Indices{0, 2, 1, 0, 3, 2}));
}

TEST(GltfMesh, ReadsInterleavedAttributes)
{
    GltfFile file;
    file.AddFloats("VEC3", {1, 0, 0, 0, 0, 1, 3, 0, 0, 0, 0, 1, 1, 2, 0, 0, 0, 1});
    std::string text = file.Text(OnePrimitive(R"("attributes": {"POSITION": 0, "NORMAL": 1})"));
    const auto replace = [&text](const std::string& from, const std::string& to)
    {
        text.replace(text.find(from), from.size(), to);
    };
    replace(R"("byteLength": 72}])", R"("byteLength": 72, "byteStride": 24}])");
    replace(R"("bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 72)",
            R"("bufferViews": [{"buffer": 0, "byteOffset": 0, "byteStride": 24, "byteLength": 72)");
    replace(R"("count": 6, "type": "VEC3"})",
            R"("count": 3, "type": "VEC3"}, {"bufferView": 0, "byteOffset": 12,)"
            R"( "componentType": 5126, "count": 3, "type": "VEC3"})");
    const auto mesh = Load(text);
    EXPECT_EQ(mesh->data().vertices, (std::vector<glm::vec3>{{-1, 0, 0}, {-3, 0, 0}, {-1, 2, 0}}));
    ExpectNear(mesh->data().normals.at(2), {0, 0, 1});
}

TEST(GltfMesh, WritesStripsAndFansOutAsTriangles)
{
    for (const int mode : {5, 6})
    {
        const bool isStrip = mode == 5;
        GltfFile file;
        // The same square: as a strip in Z order, as a fan around its corner.
        file.AddFloats("VEC3", isStrip ? std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}
                                       : std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
        const auto mesh = Load(file.Text(
            OnePrimitive(R"("attributes": {"POSITION": 0}, "mode": )" + std::to_string(mode))));
        ASSERT_EQ(mesh->data().triangles.size(), 6u);
        for (const glm::vec3& normal : mesh->data().normals)
        {
            ExpectNear(normal, {0, 0, 1});
        }
        EXPECT_EQ(mesh->bounds(), (Bounds{{-0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}}));
    }
}

TEST(GltfMesh, AppliesTranslationRotationAndScale)
{
    // Scaled by (2, 1, 1), a quarter turn about y (x to -z), then moved by (0, 5, 0).
    const auto mesh =
        LoadTriangle(R"(, "translation": [0, 5, 0], "rotation": [0, 0.70710678, 0, 0.70710678],)"
                     R"( "scale": [2, 1, 1])");
    const std::vector<glm::vec3>& vertices = mesh->data().vertices;
    ExpectNear(vertices.at(0), {0, 5, -2});
    ExpectNear(vertices.at(1), {0, 5, -6});
    ExpectNear(vertices.at(2), {0, 7, -2});
    // It faced +z; the turn takes that to +x, and limn's x is the other way round.
    ExpectNear(FacingOf(*mesh), {-1, 0, 0});
    ExpectNear(mesh->data().normals.at(0), {-1, 0, 0});
}

TEST(GltfMesh, AppliesAMatrixInColumnOrder)
{
    const auto mesh =
        LoadTriangle(R"(, "matrix": [1, 0, 0, 0,  0, 3, 0, 0,  0, 0, 1, 0,  10, 20, 30, 1])");
    ExpectNear(mesh->data().vertices.at(2), {-11, 26, 30});
}

TEST(GltfMesh, KeepsTrianglesFacingTheirWayUnderAMirroringNode)
{
    const auto mesh = LoadTriangle(R"(, "scale": [-1, 1, 1])");
    EXPECT_EQ(mesh->data().vertices, (std::vector<glm::vec3>{{1, 0, 0}, {3, 0, 0}, {1, 2, 0}}));
    ExpectNear(FacingOf(*mesh), {0, 0, 1});
    ExpectNear(mesh->data().normals.at(0), {0, 0, 1});
}

// Files in centimetres have such nodes.
TEST(GltfMesh, KeepsDirectionsOfUnitLengthUnderASmallScale)
{
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    file.AddFloats("VEC3", {0.6f, 0, 0.8f, 0.6f, 0, 0.8f, 0.6f, 0, 0.8f});
    file.AddFloats("VEC4", {0.8f, 0, -0.6f, 1, 0.8f, 0, -0.6f, 1, 0.8f, 0, -0.6f, 1});
    const auto mesh =
        Load(file.Text(OnePrimitive(R"("attributes": {"POSITION": 0, "NORMAL": 1, "TANGENT": 2})",
                                    R"(, "scale": [0.01, 0.01, 0.01])")));
    ExpectNear(mesh->data().vertices.at(1), {-0.03f, 0, 0});
    ExpectNear(mesh->data().normals.at(0), {-0.6f, 0, 0.8f});
    ExpectNear(glm::vec3(mesh->data().tangents.at(0)), {-0.8f, 0, -0.6f});
}

TEST(GltfMesh, KeepsNormalsAcrossTheSurfaceUnderAnUnevenScale)
{
    GltfFile file;
    // A slope of 45 degrees rising along x; its normal is (-1, 1, 0) / sqrt(2).
    const float d = 0.70710678f;
    file.AddFloats("VEC3", {0, 0, 0, 0, 0, -1, 1, 1, 0});
    file.AddFloats("VEC3", {-d, d, 0, -d, d, 0, -d, d, 0});
    const auto mesh = Load(file.Text(
        OnePrimitive(R"("attributes": {"POSITION": 0, "NORMAL": 1})", R"(, "scale": [3, 1, 1])")));
    const glm::vec3 normal = mesh->data().normals.at(0);
    // Now it rises 1 in 3: the normal is (-1, 3) / sqrt(10), mirrored.
    ExpectNear(normal, {0.31622777f, 0.94868330f, 0});
    EXPECT_NEAR(std::abs(glm::dot(normal, FacingOf(*mesh))), 1.0f, 1e-5f);
}

TEST(GltfMesh, GoesThroughTheNodesWithTheirParentsTransforms)
{
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    const auto mesh = Load(file.Text(
        R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], )"
        R"("nodes": [{"translation": [0, 1, 0], "children": [1, 2]}, )"
        R"({"mesh": 0, "scale": [2, 2, 2]}, {"mesh": 0, "translation": [0, 0, 7]}, {"mesh": 0}], )"
        R"("scenes": [{"nodes": [3]}, {"nodes": [0]}], "scene": 1)"));
    ASSERT_EQ(mesh->subMeshCount(), 2);
    EXPECT_EQ(mesh->subMesh(0), (SubMesh{0, 3}));
    EXPECT_EQ(mesh->subMesh(1), (SubMesh{3, 3}));
    ExpectNear(mesh->data().vertices.at(0), {-2, 1, 0});
    ExpectNear(mesh->data().vertices.at(3), {-1, 1, 7});
    EXPECT_EQ(mesh->data().triangles, (Indices{0, 2, 1, 3, 5, 4}));
}

TEST(GltfMesh, ShowsTheRootNodesOfAFileWithoutScenes)
{
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    const std::string meshes = R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}])";
    const auto mesh = Load(file.Text(
        meshes + R"(, "nodes": [{"mesh": 0}, {"children": [0], "translation": [0, 0, 4]}])"));
    EXPECT_EQ(mesh->subMeshCount(), 1);
    ExpectNear(mesh->data().vertices.at(0), {-1, 0, 4});
    EXPECT_EQ(Load(file.Text(meshes))->data().vertices.size(), 3u);
}

TEST(GltfMesh, GoesDownAChainOfNodesThatIsDeeperThanAStack)
{
    constexpr int count = 20'000;
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    std::string nodes;
    for (int i = 1; i < count; ++i)
    {
        nodes += R"({"translation": [0, 0.25, 0], "children": [)" + std::to_string(i) + "]}, ";
    }
    const std::string rest = R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], )"
                             R"("nodes": [)" +
                             nodes + R"({"mesh": 0}])";
    for (const std::string scenes : {R"(, "scenes": [{"nodes": [0]}])", ""})
    {
        const auto mesh = Load(file.Text(rest + scenes));
        EXPECT_EQ(mesh->data().vertices.front(), glm::vec3(-1.0f, 0.25f * (count - 1), 0.0f));
    }
}

TEST(GltfMesh, FillsWhatOnePrimitiveLacks)
{
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    file.AddFloats("VEC2", {0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f});
    file.AddFloats("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    const auto mesh = Load(
        file.Text(R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 2}}, )"
                  R"({"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 1}}]}], )"
                  R"("nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}])"));
    const MeshData& data = mesh->data();
    ASSERT_EQ(data.uv.size(), 6u);
    EXPECT_EQ(data.uv[2], glm::vec2(0, 0));
    EXPECT_EQ(data.uv[3], glm::vec2(0.5f, 0.5f));
    ASSERT_EQ(data.uv2.size(), 6u);
    EXPECT_EQ(data.uv2[2], glm::vec4(0.0f));
    EXPECT_EQ(data.uv2[3], glm::vec4(0.5f, 0.5f, 0, 0));
    ASSERT_EQ(data.colors.size(), 6u);
    EXPECT_EQ(data.colors[2], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(data.colors[3], glm::vec4(1, 1, 1, 1));
    EXPECT_TRUE(data.tangents.empty());
}

TEST(GltfMesh, LeavesPointsAndLinesOut)
{
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    const auto mesh = Load(file.Text(
        R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}, )"
        R"({"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}])"));
    EXPECT_EQ(mesh->subMeshCount(), 1);
}

TEST(GltfMesh, ReadsTheBinaryContainerWhateverTheFileIsCalled)
{
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    const std::string bytes = file.Binary(OnePrimitive(R"("attributes": {"POSITION": 0})"));
    for (const std::string name : {"a.glb", "a.bin"})
    {
        ExpectNear(Load(bytes, name)->data().vertices.at(1), {-3, 0, 0});
    }
}

TEST(GltfMesh, ReadsABufferBesideTheFile)
{
    const test::TemporaryFolder folder;
    const auto* bytes = reinterpret_cast<const char*>(k_Triangle.data());
    folder.Write("data.bin", std::string_view(bytes, 36));
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    std::string text = file.Text(OnePrimitive(R"("attributes": {"POSITION": 0})"));
    const std::size_t begin = text.find("data:");
    text.replace(begin, text.find('"', begin) - begin, "data.bin");
    const auto mesh = LoadGltfMesh(folder.Write("a.gltf", text));
    ExpectNear(mesh->data().vertices.at(2), {-1, 2, 0});
}

TEST(GltfMesh, DoesNotMissItsPictures)
{
    GltfFile file;
    file.AddFloats("VEC3", k_Triangle);
    const auto mesh = Load(file.Text(OnePrimitive(R"("attributes": {"POSITION": 0})") +
                                     R"(, "images": [{"uri": "nowhere.png"}])"));
    EXPECT_EQ(mesh->data().vertices.size(), 3u);
}

} // namespace
} // namespace limn

#include <gtest/gtest.h>
#include <limits>
#include <limn/base/Diagnostic.h>
#include <limn/editor_stub/GltfMesh.h>

#include "Mentions.h"
#include "TemporaryFolder.h"
#include "core/ThrownMessage.h"
#include "gltf/GltfFile.h"

namespace limn
{
namespace
{

using test::GltfFile;
using test::Mentions;
using test::OnePrimitive;
using testing::ElementsAre;

/// What loading the file says, without the folder.
std::string MessageOf(const std::string& content)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.Write("a.gltf", content);
    std::string message =
        test::ThrownMessage<AssetError>([&] { static_cast<void>(LoadGltfMesh(path)); });
    const std::string prefix = path.parent_path().string() + "/";
    for (std::size_t at; (at = message.find(prefix)) != std::string::npos;)
    {
        message.erase(at, prefix.size());
    }
    return message;
}

std::string ErrorOf(const std::string& content)
{
    return test::OnlyLine(MessageOf(content));
}

GltfFile Triangle()
{
    GltfFile file;
    file.AddFloats("VEC3", {1, 0, 0, 3, 0, 0, 1, 2, 0});
    return file;
}

std::string Replaced(std::string text, const std::string& from, const std::string& to)
{
    text.replace(text.find(from), from.size(), to);
    return text;
}

TEST(GltfMeshError, SaysThatAFileIsMissing)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / "none.gltf";
    EXPECT_THAT(test::ThrownMessage<AssetError>([&] { static_cast<void>(LoadGltfMesh(path)); }),
                Mentions(path.string(), "no such file"));
}

TEST(GltfMeshError, SaysThatAFileIsAFolder)
{
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "a.gltf");
    EXPECT_THAT(test::ThrownMessage<AssetError>([&] { LoadGltfMesh(folder / "a.gltf"); }),
                Mentions((folder / "a.gltf").string(), "is a folder", "file is expected"));
}

TEST(GltfMeshError, SaysWhyABufferCannotBeRead)
{
    const test::TemporaryFolder outer;
    const std::filesystem::path folder = outer / "meshes";
    std::filesystem::create_directories(folder / "folder.bin");
    outer.Write("near.bin", "0123");
    const auto errorOf = [&](const std::string& uri)
    {
        const auto path =
            outer.Write("meshes/a.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"uri": ")" +
                                             uri + R"(", "byteLength": 4}]})");
        return test::ThrownMessage<AssetError>([&] { LoadGltfMesh(path); })
            .erase(0, path.string().size());
    };
    EXPECT_THAT(errorOf("none.bin"), Mentions("buffer 'none.bin'", "no such file"));
    EXPECT_THAT(errorOf("folder.bin"), Mentions("buffer 'folder.bin'", "is a folder"));
    EXPECT_THAT(errorOf("../near.bin"), Mentions("buffer 'near.bin'", "outside"));
    std::filesystem::create_symlink(outer / "near.bin", folder / "link.bin");
    EXPECT_THAT(errorOf("link.bin"), Mentions("buffer 'link.bin'", "outside"));
}

TEST(GltfMesh, TellsTheFilesOfItsBuffersAlsoThoseThatAreMissing)
{
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "sub");
    folder.Write("sub/my mesh.bin", "0123");
    std::vector<std::filesystem::path> reached;
    const auto load = [&](const std::string& buffers)
    {
        reached.clear();
        const auto path =
            folder.Write("a.gltf", R"({"asset": {"version": "2.0"}, "buffers": )" + buffers + "}");
        EXPECT_THROW(LoadGltfMesh(path, {}, [&](const auto& file) { reached.push_back(file); }),
                     AssetError);
    };
    load(R"([{"uri": "sub/my%20mesh.bin", "byteLength": 4}, {"uri": "100%", "byteLength": 4}])");
    EXPECT_EQ((std::vector{folder / "sub/my mesh.bin", folder / "100%"}), reached);
    load(R"([{"uri": "data:application/octet-stream;base64,AAAA", "byteLength": 3}])");
    EXPECT_TRUE(reached.empty());
}

TEST(GltfMesh, ReadsABufferFromAnotherRoot)
{
    const test::TemporaryFolder outer;
    std::filesystem::create_directory(outer / "meshes");
    outer.Write("near.bin", "0123");
    const auto path = outer.Write("meshes/a.gltf", R"({"asset": {"version": "2.0"}, "buffers": )"
                                                   R"([{"uri": "../near.bin", "byteLength": 4}]})");
    FileRoots roots;
    roots.Add(outer / "");
    EXPECT_THAT(test::ThrownMessage<AssetError>([&] { LoadGltfMesh(path, roots); }),
                Mentions(path.string(), "no triangles", "mesh"));
}

TEST(GltfMeshError, SaysThatAFileIsEmpty)
{
    EXPECT_THAT(ErrorOf(""), Mentions("a.gltf", "empty", "glTF 2.0"));
}

TEST(GltfMeshError, SaysWhereAFileIsNoJson)
{
    EXPECT_THAT(ErrorOf("{\n  \"asset\" ?\n}"),
                Mentions("a.gltf:2:11", "not glTF 2.0", "syntax error"));
}

TEST(GltfMeshError, SaysWhichNumberIsNone)
{
    EXPECT_THAT(ErrorOf(R"({"asset": {"version": "2.0"}, "scene": 0.1e400})"),
                Mentions("a.gltf", "not glTF 2.0", "overflow", "0.1e400"));
}

TEST(GltfMeshError, SaysThatAFileIsNoGltf)
{
    EXPECT_THAT(ErrorOf("[1, 2]"), Mentions("a.gltf", "not glTF 2.0", "JSON object"));
    EXPECT_THAT(ErrorOf("glTF and then nothing much"),
                Mentions("a.gltf", "not glTF 2.0", "binary"));
}

TEST(GltfMeshError, NamesTheVersionOfAnOlderFile)
{
    const std::string text = Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 0})"));
    EXPECT_THAT(ErrorOf(Replaced(text, R"("version": "2.0")", R"("version": "1.0")")),
                Mentions("a.gltf", "version is 1.0", "2.0"));
}

TEST(GltfMeshError, SaysThatAFileHoldsNoTriangles)
{
    const auto expected = Mentions("a.gltf", "no triangles", "mesh");
    EXPECT_THAT(ErrorOf(R"({"asset": {"version": "2.0"}})"), expected);
    EXPECT_THAT(
        ErrorOf(Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 0}, "mode": 1)"))),
        expected);
    EXPECT_THAT(ErrorOf(Triangle().Text(OnePrimitive(R"("attributes": {})"))), expected);
}

/// `count` times `text`.
std::string Repeated(const std::string& text, std::size_t count)
{
    std::string result;
    for (std::size_t i = 0; i < count; ++i)
    {
        result += text;
    }
    return result;
}

TEST(GltfMeshError, RejectsWhatIsNestedDeeperThanAStackIs)
{
    const std::string rest = OnePrimitive(R"("attributes": {"POSITION": 0})");
    for (const std::string open : {"[", R"({"a": )"})
    {
        const std::string close = open == "[" ? "]" : "}";
        const std::string extras = ", \n  \"extras\": " + Repeated(open, 100'000) +
                                   (open == "[" ? "" : "0") + Repeated(close, 100'000);
        const std::size_t column =
            13 + 63 * open.size(); // the file's own object is the first level
        EXPECT_THAT(ErrorOf(Triangle().Text(rest + extras)),
                    Mentions("a.gltf:2:" + std::to_string(column) + ":", "nested", "64 levels"));
        EXPECT_THAT(ErrorOf(Triangle().Binary(rest + extras)),
                    Mentions("a.gltf: ", "nested", "64 levels"));
    }
}

TEST(GltfMeshError, DoesNotCountBracketsInTextOrInABinaryChunk)
{
    const std::string rest = OnePrimitive(R"("attributes": {"POSITION": 0})") +
                             R"(, "extras": [")" + Repeated("[{\\\"", 1000) + R"("])";
    const test::TemporaryFolder folder;
    EXPECT_EQ(LoadGltfMesh(folder.Write("a.gltf", Triangle().Text(rest)))->data().triangles.size(),
              3u);
    GltfFile brackets = Triangle();
    brackets.AddIntegers<std::uint8_t>("SCALAR", std::vector<std::uint8_t>(1000, '['));
    EXPECT_EQ(LoadGltfMesh(folder.Write("a.glb", brackets.Binary(rest)))->data().triangles.size(),
              3u);
}

TEST(GltfMeshError, RejectsCompressionItCannotRead)
{
    const std::string text = Triangle().Text(
        OnePrimitive(R"("attributes": {"POSITION": 0})") +
        R"(, "extensionsRequired": ["KHR_materials_unlit", "KHR_draco_mesh_compression"])");
    EXPECT_THAT(ErrorOf(text), Mentions("a.gltf", "'KHR_draco_mesh_compression'", "not supported",
                                        "without compression"));
}

TEST(GltfMeshError, RejectsAnAccessorThatDoesNotExist)
{
    EXPECT_THAT(ErrorOf(Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 4})"))),
                Mentions("a.gltf", "'shape' primitive 0", "accessor 4", "not exist", "has 1"));
}

TEST(GltfMeshError, RejectsElementsThatLeaveTheBuffer)
{
    const std::string text = Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 0})"));
    const auto expected =
        Mentions("a.gltf", "'shape' primitive 0", "accessor 0", "leave", "36 bytes");
    EXPECT_THAT(ErrorOf(Replaced(text, R"("count": 3)", R"("count": 4)")), expected);
    EXPECT_THAT(ErrorOf(Replaced(text, R"("count": 3)", R"("count": 9223372036854775807)")),
                expected);
    EXPECT_THAT(ErrorOf(Replaced(text, R"("byteOffset": 0)", R"("byteOffset": 4)")), expected);
}

TEST(GltfMeshError, RejectsElementsOfAnotherShape)
{
    GltfFile file = Triangle();
    file.AddFloats("VEC2", {0, 0, 0, 0, 0, 0});
    EXPECT_THAT(ErrorOf(file.Text(OnePrimitive(R"("attributes": {"POSITION": 1})"))),
                Mentions("a.gltf", "'shape' primitive 0", "accessor 1", "2 numbers", "3"));
}

TEST(GltfMeshError, RejectsIndicesThatAreNoIntegers)
{
    EXPECT_THAT(
        ErrorOf(Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 0}, "indices": 0)"))),
        Mentions("a.gltf", "'shape' primitive 0", "accessor 0", "5126", "indices",
                 "5121, 5123 or 5125"));
}

TEST(GltfMeshError, RejectsSparseAccessors)
{
    const std::string text = Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 0})"));
    EXPECT_THAT(ErrorOf(Replaced(text, R"({"bufferView": 0, )", "{")),
                Mentions("a.gltf", "'shape' primitive 0", "accessor 0", "no buffer view", "dense"));
}

TEST(GltfMeshError, RejectsAnAttributeOfAnotherLength)
{
    GltfFile file = Triangle();
    file.AddFloats("VEC2", {0, 0, 1, 1});
    EXPECT_THAT(
        ErrorOf(file.Text(OnePrimitive(R"("attributes": {"POSITION": 0, "TEXCOORD_0": 1})"))),
        Mentions("a.gltf", "'shape' primitive 0", "TEXCOORD_0", "2 elements", "3 vertices"));
}

TEST(GltfMeshError, RejectsNodesThatFormACircle)
{
    const std::string text = Triangle().Text(
        R"("nodes": [{"children": [1]}, {"children": [0, 5]}], "scenes": [{"nodes": [0]}])");
    EXPECT_THAT(test::MessageLines(MessageOf(text)),
                ElementsAre(Mentions("a.gltf", "node 0", "not exist", "two parents"),
                            Mentions("a.gltf", "node 5", "not exist", "two parents")));
}

TEST(GltfMeshError, RejectsAMeshThatDoesNotExist)
{
    EXPECT_THAT(ErrorOf(Triangle().Text(R"("nodes": [{"mesh": 2}], "scenes": [{"nodes": [0]}])")),
                Mentions("a.gltf", "mesh 2", "not exist", "is 0"));
}

TEST(GltfMeshError, RejectsPositionsThatAreNoNumbers)
{
    GltfFile file;
    file.AddFloats("VEC3", {1, 0, 0, 3, 0, 0, 1, std::numeric_limits<float>::infinity(), 0});
    file.AddFloats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
    EXPECT_THAT(ErrorOf(file.Text(OnePrimitive(R"("attributes": {"POSITION": 0, "NORMAL": 1})"))),
                Mentions("a.gltf", "mesh", "primitive 0", "vertices[2]", "not a finite number"));
}

TEST(GltfMeshError, ListsEveryPrimitiveThatCannotBeRead)
{
    GltfFile file = Triangle();
    file.AddIndices<std::uint16_t>({0, 1, 3});
    file.AddIndices<std::uint16_t>({0, 1, 2, 0});
    const std::string text = file.Text(R"("meshes": [{"name": "m", "primitives": [)"
                                       R"({"attributes": {"POSITION": 0}, "indices": 1}, )"
                                       R"({"attributes": {"POSITION": 0}, "indices": 2}]}], )"
                                       R"("nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}])");
    EXPECT_THAT(
        test::MessageLines(MessageOf(text)),
        ElementsAre(Mentions("a.gltf", "'m' primitive 0", "index 3", "3 vertices"),
                    Mentions("a.gltf", "'m' primitive 1", "4 indices", "multiple of three")));
}

} // namespace
} // namespace limn

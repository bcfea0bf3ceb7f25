#include <gtest/gtest.h>
#include <limits>
#include <limn/base/Diagnostic.h>
#include <limn/core/GltfMesh.h>

#include "TemporaryFolder.h"
#include "ThrownMessage.h"
#include "gltf/GltfFile.h"

namespace limn
{
namespace
{

using test::GltfFile;
using test::OnePrimitive;

/// What loading the file says, without the folder.
std::string ErrorOf(const std::string& content)
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
    EXPECT_EQ(test::ThrownMessage<AssetError>([&] { static_cast<void>(LoadGltfMesh(path)); }),
              path.string() + ": error: there is no such file");
}

TEST(GltfMeshError, SaysThatAFileIsAFolder)
{
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "a.gltf");
    EXPECT_EQ(test::ThrownMessage<AssetError>([&] { LoadGltfMesh(folder / "a.gltf"); }),
              (folder / "a.gltf").string() + ": error: is a folder; a file is expected");
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
    EXPECT_EQ(errorOf("none.bin"), ": error: buffer 'none.bin': there is no such file");
    EXPECT_EQ(errorOf("folder.bin"),
              ": error: buffer 'folder.bin': is a folder; a file is expected");
    EXPECT_EQ(errorOf("../near.bin"), ": error: buffer 'near.bin': it lies outside the folders "
                                      "that references may lead into");
    std::filesystem::create_symlink(outer / "near.bin", folder / "link.bin");
    EXPECT_EQ(errorOf("link.bin"), ": error: buffer 'link.bin': it lies outside the folders that "
                                   "references may lead into");
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
    EXPECT_EQ(test::ThrownMessage<AssetError>([&] { LoadGltfMesh(path, roots); }),
              path.string() +
                  ": error: holds no triangles; at least one node of its scene must have a mesh");
}

TEST(GltfMeshError, SaysThatAFileIsEmpty)
{
    EXPECT_EQ(ErrorOf(""), "a.gltf: error: is empty; a glTF 2.0 file is expected");
}

TEST(GltfMeshError, SaysWhereAFileIsNoJson)
{
    const std::string message = ErrorOf("{\n  \"asset\" ?\n}");
    EXPECT_EQ(message.rfind("a.gltf:2:11: error: is not glTF 2.0: syntax error", 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(GltfMeshError, SaysWhichNumberIsNone)
{
    EXPECT_EQ(ErrorOf(R"({"asset": {"version": "2.0"}, "scene": 0.1e400})"),
              "a.gltf: error: is not glTF 2.0: number overflow parsing '0.1e400'");
}

TEST(GltfMeshError, SaysThatAFileIsNoGltf)
{
    EXPECT_EQ(ErrorOf("[1, 2]"),
              "a.gltf: error: is not glTF 2.0: Root element is not a JSON object");
    EXPECT_EQ(ErrorOf("glTF and then nothing much"),
              "a.gltf: error: is not glTF 2.0: Invalid glTF binary.");
}

TEST(GltfMeshError, NamesTheVersionOfAnOlderFile)
{
    const std::string text = Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 0})"));
    EXPECT_EQ(ErrorOf(Replaced(text, R"("version": "2.0")", R"("version": "1.0")")),
              "a.gltf: error: asset: the version is 1.0; limn reads 2.0");
}

TEST(GltfMeshError, SaysThatAFileHoldsNoTriangles)
{
    const std::string expected =
        "a.gltf: error: holds no triangles; at least one node of its scene must have a mesh";
    EXPECT_EQ(ErrorOf(R"({"asset": {"version": "2.0"}})"), expected);
    EXPECT_EQ(ErrorOf(Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 0}, "mode": 1)"))),
              expected);
    EXPECT_EQ(ErrorOf(Triangle().Text(OnePrimitive(R"("attributes": {})"))), expected);
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
        const std::string message = "error: lists and objects are nested more than 64 levels deep; "
                                    "glTF needs less than ten";
        EXPECT_EQ(ErrorOf(Triangle().Text(rest + extras)),
                  "a.gltf:2:" + std::to_string(column) + ": " + message);
        EXPECT_EQ(ErrorOf(Triangle().Binary(rest + extras)), "a.gltf: " + message);
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
    EXPECT_EQ(ErrorOf(text), "a.gltf: error: extension 'KHR_draco_mesh_compression' is not "
                             "supported; export without compression");
}

TEST(GltfMeshError, RejectsAnAccessorThatDoesNotExist)
{
    EXPECT_EQ(
        ErrorOf(Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 4})"))),
        "a.gltf: error: mesh 'shape' primitive 0: accessor 4: does not exist; the file has 1");
}

TEST(GltfMeshError, RejectsElementsThatLeaveTheBuffer)
{
    const std::string text = Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 0})"));
    const std::string expected = "a.gltf: error: mesh 'shape' primitive 0: accessor 0: its "
                                 "elements leave the buffer of 36 bytes";
    EXPECT_EQ(ErrorOf(Replaced(text, R"("count": 3)", R"("count": 4)")), expected);
    EXPECT_EQ(ErrorOf(Replaced(text, R"("count": 3)", R"("count": 9223372036854775807)")),
              expected);
    EXPECT_EQ(ErrorOf(Replaced(text, R"("byteOffset": 0)", R"("byteOffset": 4)")), expected);
}

TEST(GltfMeshError, RejectsElementsOfAnotherShape)
{
    GltfFile file = Triangle();
    file.AddFloats("VEC2", {0, 0, 0, 0, 0, 0});
    EXPECT_EQ(ErrorOf(file.Text(OnePrimitive(R"("attributes": {"POSITION": 1})"))),
              "a.gltf: error: mesh 'shape' primitive 0: accessor 1: each element has 2 numbers; 3 "
              "are expected here");
}

TEST(GltfMeshError, RejectsIndicesThatAreNoIntegers)
{
    EXPECT_EQ(
        ErrorOf(Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 0}, "indices": 0)"))),
        "a.gltf: error: mesh 'shape' primitive 0: accessor 0: component type 5126 cannot be "
        "indices; 5121, 5123 or 5125 (unsigned) is expected");
}

TEST(GltfMeshError, RejectsSparseAccessors)
{
    const std::string text = Triangle().Text(OnePrimitive(R"("attributes": {"POSITION": 0})"));
    EXPECT_EQ(ErrorOf(Replaced(text, R"({"bufferView": 0, )", "{")),
              "a.gltf: error: mesh 'shape' primitive 0: accessor 0: is sparse or names no buffer "
              "view, which limn does not read; export it dense");
}

TEST(GltfMeshError, RejectsAnAttributeOfAnotherLength)
{
    GltfFile file = Triangle();
    file.AddFloats("VEC2", {0, 0, 1, 1});
    EXPECT_EQ(ErrorOf(file.Text(OnePrimitive(R"("attributes": {"POSITION": 0, "TEXCOORD_0": 1})"))),
              "a.gltf: error: mesh 'shape' primitive 0: TEXCOORD_0 has 2 elements for 3 vertices");
}

TEST(GltfMeshError, RejectsNodesThatFormACircle)
{
    const std::string text = Triangle().Text(
        R"("nodes": [{"children": [1]}, {"children": [0, 5]}], "scenes": [{"nodes": [0]}])");
    EXPECT_EQ(ErrorOf(text), "a.gltf: error: node 0: does not exist or has two parents; nodes form "
                             "a tree\n"
                             "a.gltf: error: node 5: does not exist or has two parents; nodes form "
                             "a tree");
}

TEST(GltfMeshError, RejectsAMeshThatDoesNotExist)
{
    EXPECT_EQ(ErrorOf(Triangle().Text(R"("nodes": [{"mesh": 2}], "scenes": [{"nodes": [0]}])")),
              "a.gltf: error: mesh 2: does not exist; the file has 0");
}

TEST(GltfMeshError, RejectsPositionsThatAreNoNumbers)
{
    GltfFile file;
    file.AddFloats("VEC3", {1, 0, 0, 3, 0, 0, 1, std::numeric_limits<float>::infinity(), 0});
    file.AddFloats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
    EXPECT_EQ(ErrorOf(file.Text(OnePrimitive(R"("attributes": {"POSITION": 0, "NORMAL": 1})"))),
              "a.gltf: error: vertices[2]: the value is not a finite number");
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
    EXPECT_EQ(ErrorOf(text),
              "a.gltf: error: mesh 'm' primitive 0: index 3 is too large for 3 vertices\n"
              "a.gltf: error: "
              "mesh 'm' primitive 1: it has 4 indices; their number must be a multiple of three");
}

} // namespace
} // namespace limn

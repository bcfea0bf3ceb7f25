#include "models/TextMesh.h"

#include "Mentions.h"
#include <cstring>
#include <gmock/gmock.h>
#include <limits>
#include <limn/base/Diagnostic.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

template <typename T>
std::string HexOf(const std::vector<T>& values)
{
    static constexpr char k_Digits[] = "0123456789abcdef";
    std::string text;
    for (const T value : values)
    {
        std::uint8_t bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        for (const std::uint8_t byte : bytes)
        {
            text += k_Digits[byte >> 4];
            text += k_Digits[byte & 15];
        }
    }
    return text;
}

/// The text of a mesh as Unity writes it.
struct MeshText
{
    std::string subMeshes = "  - firstByte: 0\n    indexCount: 6\n    topology: 0\n"
                            "    baseVertex: 0\n    firstVertex: 0\n    vertexCount: 4\n";
    std::string compressed = "    m_Vertices:\n      m_NumItems: 0\n      m_Data: \n"
                             "    m_UV:\n      m_NumItems: 0\n      m_Data: \n";
    std::string indices = HexOf<std::uint16_t>({0, 1, 2, 0, 2, 3});
    int indexFormat = 0;
    int vertexCount = 4;
    /// stream, offset, format, dimension
    std::vector<std::array<int, 4>> channels = std::vector<std::array<int, 4>>(14);
    std::string data;

    std::string Text() const
    {
        std::string text = "  m_Name: Flag\n  m_SubMeshes:\n" + subMeshes +
                           "  m_IndexFormat: " + std::to_string(indexFormat) +
                           "\n  m_IndexBuffer: " + indices +
                           "\n  m_VertexData:\n    serializedVersion: 3\n    m_VertexCount: " +
                           std::to_string(vertexCount) + "\n    m_Channels:\n";
        for (const auto& [stream, offset, format, dimension] : channels)
        {
            text += "    - stream: " + std::to_string(stream) +
                    "\n      offset: " + std::to_string(offset) +
                    "\n      format: " + std::to_string(format) +
                    "\n      dimension: " + std::to_string(dimension) + "\n";
        }
        return text + "    m_DataSize: " + std::to_string(data.size() / 2) +
               "\n    _typelessdata: " + data + "\n  m_CompressedMesh:\n" + compressed +
               "  m_StreamData:\n    offset: 0\n    size: 0\n    path: \n";
    }
    std::shared_ptr<const Mesh> Read() const
    {
        const std::string text = Text();
        const UnityTree tree(text, "Flag.asset", 4);
        return ReadTextMesh(tree.root(), "Flag.asset").mesh;
    }
    std::string Problem() const
    {
        try
        {
            Read();
        }
        catch (const AssetError& error)
        {
            EXPECT_GT(error.diagnostics().front().location.line, 3);
            return error.diagnostics().front().message;
        }
        return "";
    }
};

/// A square of positions alone.
MeshText SquareText()
{
    MeshText mesh;
    mesh.channels[0] = {0, 0, 0, 3};
    mesh.data = HexOf<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    return mesh;
}

TEST(TextMesh, HasItsTriangles)
{
    const auto mesh = SquareText().Read();
    EXPECT_EQ(mesh->name(), "Flag");
    EXPECT_THAT(mesh->data().triangles, ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_THAT(mesh->data().vertices, ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0),
                                                   glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)));
    EXPECT_TRUE(mesh->data().normals.empty());
    EXPECT_EQ(mesh->subMeshCount(), 1);
}

TEST(TextMesh, HasSubMeshesOfAnyIndexFormatAndTopology)
{
    MeshText text = SquareText();
    text.indexFormat = 1;
    text.indices = HexOf<std::uint32_t>({0, 1, 2, 3, 0, 1, 1, 0, 1});
    text.subMeshes = "  - firstByte: 0\n    indexCount: 4\n    topology: 2\n    baseVertex: 0\n"
                     "  - firstByte: 16\n    indexCount: 2\n    topology: 3\n    baseVertex: 0\n"
                     "  - firstByte: 24\n    indexCount: 3\n    topology: 0\n    baseVertex: 2\n";
    const auto mesh = text.Read();
    EXPECT_THAT(mesh->data().triangles, ElementsAre(0, 1, 2, 0, 2, 3, 3, 2, 3));
    EXPECT_THAT(mesh->data().subMeshes, ElementsAre(SubMesh{0, 6}, SubMesh{6, 0}, SubMesh{6, 3}));
}

TEST(TextMesh, HasArraysOfEveryFormatInStreams)
{
    MeshText text;
    text.vertexCount = 1;
    text.indices = HexOf<std::uint16_t>({0, 0, 0, 0, 0, 0});
    text.channels[0] = {0, 0, 0, 3};
    text.channels[1] = {0, 12, 3, 4};   // normal: snorm8
    text.channels[2] = {0, 16, 5, 4};   // tangent: snorm16
    text.channels[3] = {1, 0, 2, 4};    // colour: unorm8
    text.channels[4] = {1, 4, 1, 2};    // uv: float16
    text.channels[5] = {2, 0, 4, 0x32}; // uv2: unorm16, the high nibble aside
    text.channels[6] = {2, 4, 6, 4};    // uv3: uint8
    text.channels[7] = {2, 8, 9, 2};    // uv4: sint16
    text.channels[8] = {2, 12, 10, 1};  // uv5: uint32
    text.channels[9] = {2, 16, 11, 1};  // uv6: sint32
    text.channels[10] = {2, 20, 7, 4};  // uv7: sint8
    text.data = HexOf<float>({1, 2, 3}) + HexOf<std::int8_t>({0, 127, -128, 0}) +
                HexOf<std::int16_t>({32767, 0, 0, -32767}) + std::string(16, '0') + // to 32 bytes
                HexOf<std::uint8_t>({255, 0, 51, 102}) + HexOf<std::uint16_t>({0x3800, 0x4000}) +
                std::string(16, '0') + // to 48 bytes
                HexOf<std::uint16_t>({65535, 0}) + HexOf<std::uint8_t>({1, 2, 3, 255}) +
                HexOf<std::int16_t>({-5, 6}) + HexOf<std::uint32_t>({70000}) +
                HexOf<std::int32_t>({-70000}) + HexOf<std::int8_t>({-1, 2, -3, 4});
    const auto mesh = text.Read();
    const MeshData& data = mesh->data();
    EXPECT_EQ(data.vertices.at(0), glm::vec3(1, 2, 3));
    EXPECT_EQ(data.normals.at(0), glm::vec3(0, 1, -1));
    EXPECT_EQ(data.tangents.at(0), glm::vec4(1, 0, 0, -1));
    EXPECT_EQ(data.colors.at(0), glm::vec4(1, 0, 51.0f / 255.0f, 102.0f / 255.0f));
    EXPECT_EQ(data.uv.at(0), glm::vec2(0.5f, 2.0f));
    EXPECT_EQ(data.uv2.at(0), glm::vec4(1, 0, 0, 0));
    EXPECT_EQ(data.uv3.at(0), glm::vec4(1, 2, 3, 255));
    EXPECT_EQ(data.uv4.at(0), glm::vec4(-5, 6, 0, 0));
    EXPECT_EQ(data.uv5.at(0), glm::vec4(70000, 0, 0, 0));
    EXPECT_EQ(data.uv6.at(0), glm::vec4(-70000, 0, 0, 0));
    EXPECT_EQ(data.uv7.at(0), glm::vec4(-1, 2, -3, 4));
}

/// ProBuilder saves tangents that are no numbers for triangles without area.
TEST(TextMesh, HasZeroForATangentThatIsNoNumber)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    MeshText text = SquareText();
    text.channels[2] = {1, 0, 0, 4};
    text.data += HexOf<float>({1, 0, 0, 1, nan, 0, 0, 1, 0, 1, 0, -1, 1, 0, 0, 1});
    EXPECT_EQ(text.Read()->data().tangents.at(1), glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(text.Read()->data().tangents.at(2), glm::vec4(0, 1, 0, -1));

    text.data = HexOf<float>({0, 0, 0, nan, 0, 0, 1, 1, 0, 0, 1, 0}) + text.data.substr(96);
    EXPECT_THAT(text.Problem(), HasSubstr("finite")); // a place is needed
}

TEST(TextMesh, IsRefusedWhereItIsCompressed)
{
    MeshText text = SquareText();
    text.compressed = "    m_Vertices:\n      m_NumItems: 12\n      m_Data: 00\n";
    EXPECT_THAT(text.Problem(), HasSubstr("compressed"));
}

TEST(TextMesh, IsRefusedWhereItsNumbersDoNotFit)
{
    const auto problem = [](auto&& change)
    {
        MeshText text = SquareText();
        change(text);
        return text.Problem();
    };
    EXPECT_EQ(problem([](MeshText&) {}), "");
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.vertexCount = 5; }),
                HasSubstr("48 bytes; 5 vertices take 60"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.vertexCount = 2'000'000'000; }),
                HasSubstr("m_VertexCount is '2000000000'"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.vertexCount = -1; }),
                HasSubstr("m_VertexCount is '-1'"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.data.pop_back(); }),
                HasSubstr("ends within a byte"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.data[7] = 'x'; }), HasSubstr("holds 'x'"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.channels.resize(8); }),
                HasSubstr("8 vertex channels; 14 are expected"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.channels[0][3] = 7; }),
                HasSubstr("7 components"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.channels[0][2] = 12; }),
                HasSubstr("format is '12'"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.channels[0][0] = 4; }),
                HasSubstr("stream is '4'"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.indices.resize(20); }),
                Mentions("6 indices", "index buffer", "10 bytes"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.indices[2] = '9'; }), HasSubstr("index"));
    EXPECT_THAT(problem(
                    [](MeshText& mesh)
                    {
                        mesh.subMeshes = "  - firstByte: 4000000000\n    indexCount: 3\n"
                                         "    topology: 0\n    baseVertex: 0\n";
                    }),
                HasSubstr("firstByte is '4000000000'"));
    EXPECT_THAT(problem([](MeshText& mesh) { mesh.channels[0][3] = 0; }), HasSubstr("vert"));
    EXPECT_THAT(problem(
                    [](MeshText& mesh)
                    {
                        mesh.vertexCount = 0;
                        mesh.data.clear();
                    }),
                HasSubstr("vert"));
}

} // namespace
} // namespace limn::test

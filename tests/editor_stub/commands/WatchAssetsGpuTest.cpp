#include "commands/WatchTest.h"
#include "commands/WatchedAssets.h"

#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

class WatchAssets : public WatchTest
{
protected:
    void SetUp() override
    {
        WatchTest::SetUp();
        WriteAssets(folder);
    }

    bool WaitForColor(const std::string& color, double x = 0.5) const
    {
        return WaitFor([&] { return ColorAt(folder / "out.png", x) == color; });
    }
};

} // namespace

TEST_F(WatchAssets, FollowsAShaderAndWhatItIncludes)
{
    Start();
    ASSERT_TRUE(WaitForColor("#ffffff")) << ReadText(folder / "err");
    folder.Write("Tint.hlsl", TintText("1, 0, 0"));
    EXPECT_TRUE(WaitForColor("#ff0000")) << "an include";
    folder.Write("own.shader", ShaderText("0"));
    EXPECT_TRUE(WaitForColor("#000000")) << "a shader";
    folder.Write("own.tmp", ShaderText("1"));
    std::filesystem::rename(folder / "own.tmp", folder / "own.shader");
    EXPECT_TRUE(WaitForColor("#ff0000")) << "a shader that is renamed into its place";
}

TEST_F(WatchAssets, FollowsATextureAMeshAndItsBuffer)
{
    Start();
    ASSERT_TRUE(WaitForColor("#ffffff")) << ReadText(folder / "err");
    WriteTexture(folder / "t.png", 0, 0, 255);
    EXPECT_TRUE(WaitForColor("#0000ff")) << "a texture";
    folder.Write("m.bin", CornerBytes(100.0f));
    EXPECT_TRUE(WaitForColor("#000000")) << "a buffer beside a mesh";
    folder.Write("m.gltf", GltfText("-100, 0, 0"));
    EXPECT_TRUE(WaitForColor("#0000ff")) << "a mesh";
}

TEST_F(WatchAssets, SaysWhichBufferIsMissingAndGoesOnWhenItComes)
{
    std::filesystem::remove(folder / "m.bin");
    Start();
    EXPECT_TRUE(
        WaitFor([&] { return ReadText(folder / "err").find("m.bin") != std::string::npos; }));
    EXPECT_FALSE(std::filesystem::exists(folder / "out.png"));
    folder.Write("m.bin", CornerBytes(0.0f));
    EXPECT_TRUE(WaitForColor("#ffffff")) << ReadText(folder / "err");
}

TEST_F(WatchAssets, DrawsWhatAShaderThatDoesNotCompileDrawsInMagenta)
{
    folder.Write("s.scene.yaml",
                 "size: [64, 36]\n"
                 "camera: {position: [0, 0, -4], backgroundColor: \"#000000\"}\n"
                 "materials:\n"
                 "  own: {shader: own.shader}\n"
                 "  other: {shader: Universal Render Pipeline/Unlit, _BaseColor: \"#0000ff\"}\n"
                 "objects:\n"
                 "  - {name: Left, mesh: cube, material: own, position: [-1.2, 0, 0]}\n"
                 "  - {name: Right, mesh: cube, material: other, position: [1.2, 0, 0]}\n");
    Start();
    ASSERT_TRUE(WaitForColor("#ffffff", 0.3)) << ReadText(folder / "err");
    folder.Write("own.shader", ShaderText("undeclared"));
    EXPECT_TRUE(WaitForColor("#ff00ff", 0.3)) << ReadText(folder / "err");
    EXPECT_EQ("#0000ff", ColorAt(folder / "out.png", 0.7));
    EXPECT_THAT(ReadText(folder / "err"), HasSubstr(Path("own.shader") + ":20:"));
    EXPECT_THAT(ReadText(folder / "err"), HasSubstr("undeclared"));
    folder.Write("own.shader", ShaderText("1"));
    EXPECT_TRUE(WaitForColor("#ffffff", 0.3));
    EXPECT_EQ("#0000ff", ColorAt(folder / "out.png", 0.7));
}

} // namespace limn::test

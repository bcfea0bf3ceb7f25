#include "commands/WatchedAssets.h"

#include <gtest/gtest.h>
#include <limn/core/Image.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/AssetParameters.h>

namespace limn::test
{

namespace
{

using Paths = std::set<std::filesystem::path>;

struct Tint : VolumeComponent
{
    Texture2DParameter ramp{this, "m_Ramp", {}};
};

class AssetContextTest : public testing::Test
{
protected:
    void SetUp() override { WriteAssets(folder); }

    TemporaryFolder folder;
    AssetContext assets;
};

} // namespace

TEST_F(AssetContextTest, ReachesEveryFileOfASceneAndWhatItsShadersInclude)
{
    LoadScene(folder / "s.scene.yaml", assets);
    const Paths loaded{folder / "m.bin",          folder / "m.gltf",       folder / "own.shader",
                       folder / "p.profile.yaml", folder / "s.scene.yaml", folder / "t.png",
                       folder / "t.png.meta"}; // should there ever be one
    EXPECT_EQ(loaded, assets.reachedFiles());
    assets.LoadShader(folder / "own.shader")->Compile(0);
    EXPECT_EQ(1u, assets.reachedFiles().count(folder / "Tint.hlsl"));
}

TEST_F(AssetContextTest, LetsFeaturesFindShippedShadersAndThoseThatWereLoaded)
{
    EXPECT_EQ(assets.shaderSource()->Find("Hidden/ScreenSpaceOutline"),
              assets.FindShader("Hidden/ScreenSpaceOutline"));
    const auto own = assets.LoadShader(folder / "own.shader");
    EXPECT_EQ(assets.shaderSource()->Find(own->name()), own);
}

TEST_F(AssetContextTest, ReachesAnIncludeThatIsMissing)
{
    std::filesystem::remove(folder / "Tint.hlsl");
    EXPECT_THROW(assets.LoadShader(folder / "own.shader")->Compile(0), AssetError);
    EXPECT_EQ(1u, assets.compiler()->includeFiles().count(folder / "Tint.hlsl"));
}

TEST_F(AssetContextTest, ReachesIncludesOfShadersFromTheCacheAsWell)
{
    const ShaderCompilerOptions options{folder / "cache", {}, {}};
    AssetContext(options).LoadShader(folder / "own.shader")->Compile(0);
    AssetContext cached(options);
    cached.LoadShader(folder / "own.shader")->Compile(0);
    EXPECT_EQ(1, cached.compiler()->statistics().loadedFromCache);
    EXPECT_EQ(1u, cached.reachedFiles().count(folder / "Tint.hlsl"));
}

TEST_F(AssetContextTest, ReadsAForgottenFileAgainAndNoOther)
{
    const auto shader = assets.LoadShader(folder / "own.shader");
    const auto mesh = assets.LoadMesh(folder / "m.gltf");
    const auto texture = assets.LoadTexture(folder / "t.png");
    assets.Forget(folder / "sub/../t.png");
    EXPECT_NE(texture, assets.LoadTexture(folder / "t.png"));
    EXPECT_EQ(mesh, assets.LoadMesh(folder / "m.gltf"));
    assets.Forget(folder / "m.gltf");
    EXPECT_NE(mesh, assets.LoadMesh(folder / "m.gltf"));
    EXPECT_EQ(shader, assets.LoadShader(folder / "own.shader"));
    assets.Forget(folder / "own.shader");
    EXPECT_NE(shader, assets.LoadShader(folder / "own.shader"));
}

TEST_F(AssetContextTest, PutsThePicturesBottomRowAtVZeroAsUnityImportsIt)
{
    std::vector<std::byte> redAboveBlue(8);
    redAboveBlue[0] = redAboveBlue[3] = redAboveBlue[6] = redAboveBlue[7] = std::byte{255};
    WritePng(folder / "two.png", {1, 2, GraphicsFormat::R8G8B8A8_SRGB, redAboveBlue});
    const auto texture =
        std::dynamic_pointer_cast<const Texture2D>(assets.LoadTexture(folder / "two.png"));
    ASSERT_NE(nullptr, texture);
    EXPECT_EQ(std::byte{255}, texture->texels().at(2)) << "row 0 is blue";
    EXPECT_EQ(std::byte{255}, texture->texels().at(4)) << "row 1 is red";
}

TEST_F(AssetContextTest, GivesTexturesAllMipLevelsAsUnityImportsThem)
{
    WritePng(folder / "wide.png",
             {8, 2, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(8 * 2 * 4)});
    EXPECT_EQ(4, assets.LoadTexture(folder / "wide.png")->mipmapCount()); // 8x2, 4x1, 2x1, 1x1
}

TEST_F(AssetContextTest, ForgetsTheMeshOfABufferAndTheShadersOfAnInclude)
{
    const auto shader = assets.LoadShader(folder / "own.shader");
    shader->Compile(0);
    const auto mesh = assets.LoadMesh(folder / "m.gltf");
    assets.Forget(folder / "m.bin");
    EXPECT_NE(mesh, assets.LoadMesh(folder / "m.gltf"));
    EXPECT_EQ(shader, assets.LoadShader(folder / "own.shader"));
    assets.Forget(folder / "Tint.hlsl");
    EXPECT_NE(shader, assets.LoadShader(folder / "own.shader"));
}

TEST_F(AssetContextTest, GivesAProfileTheTextureItNamesAfterThatChanged)
{
    assets.volumeComponents().Register<Tint>("Tint");
    folder.Write("p.profile.yaml", "Tint: {ramp: ramp.png}\n");
    WriteTexture(folder / "ramp.png", 255, 0, 0);
    const auto redOfRamp = [&]
    {
        const SceneAsset scene = LoadScene(folder / "s.scene.yaml", assets);
        const Tint& paint = *scene.volumes.at(0).sharedProfile->TryGet<Tint>();
        const auto& ramp = dynamic_cast<const Texture2D&>(*paint.ramp.value().asset);
        return std::to_integer<int>(ramp.texels().front());
    };
    EXPECT_EQ(255, redOfRamp());
    EXPECT_EQ(1u, assets.reachedFiles().count(folder / "ramp.png"));
    WriteTexture(folder / "ramp.png", 7, 0, 0);
    EXPECT_EQ(255, redOfRamp());
    assets.Forget(folder / "ramp.png");
    EXPECT_EQ(7, redOfRamp());
}

} // namespace limn::test

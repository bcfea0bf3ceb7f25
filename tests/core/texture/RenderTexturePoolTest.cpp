#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/RenderTexturePool.h>

#include "ThrownMessage.h"

namespace limn
{
namespace
{

TEST(RenderTexturePool, GivesATextureOfTheAskedKind)
{
    RenderTexturePool pool;
    const TemporaryTexture color = pool.GetTemporary(640, 360);
    EXPECT_EQ(color.rt()->descriptor(),
              RenderTextureDescriptor(640, 360, GraphicsFormat::R8G8B8A8_SRGB));
    EXPECT_EQ(color.rt()->sampler().filterMode, FilterMode::Bilinear);
    EXPECT_EQ(color.rt()->sampler().wrapModeU, TextureWrapMode::Clamp);
    EXPECT_EQ(
        pool.GetTemporary(8, 8, 0, RenderTextureFormat::ARGB32, RenderTextureReadWrite::Linear)
            .rt()
            ->graphicsFormat(),
        GraphicsFormat::R8G8B8A8_UNorm);
    EXPECT_EQ(color.rt()->depthBuffer(), nullptr);
    const TemporaryTexture both = pool.GetTemporary(8, 8, 24);
    EXPECT_EQ(both.rt()->graphicsFormat(), GraphicsFormat::R8G8B8A8_SRGB);
    ASSERT_TRUE(both.rt()->depthBuffer());
    EXPECT_EQ(both.rt()->depthBuffer()->graphicsFormat(), GraphicsFormat::D32_SFloat_S8_UInt);
    const TemporaryTexture samples =
        pool.GetTemporary(8, 8, 0, RenderTextureFormat::R8, RenderTextureReadWrite::Default, 4);
    EXPECT_EQ(samples.rt()->descriptor().msaaSamples, 4);
    EXPECT_EQ(samples.rt()->graphicsFormat(), GraphicsFormat::R8_UNorm);
}

TEST(RenderTexturePool, GivesAReleasedTextureOutAgainToWhoAsksForItsKind)
{
    RenderTexturePool pool;
    TemporaryTexture first = pool.GetTemporary(8, 4);
    const auto texture = first.rt();
    RenderTexturePool::ReleaseTemporary(first);
    EXPECT_FALSE(first);
    EXPECT_FALSE(first.handle());
    const TemporaryTexture larger = pool.GetTemporary(8, 5);
    const TemporaryTexture point =
        pool.GetTemporary({8, 4, GraphicsFormat::R8G8B8A8_SRGB}, FilterMode::Point);
    const TemporaryTexture again = pool.GetTemporary(8, 4);
    EXPECT_NE(larger.rt(), texture);
    EXPECT_NE(point.rt(), texture);
    EXPECT_EQ(again.rt(), texture);
}

TEST(RenderTexturePool, GivesNobodyWhatAnotherStillHas)
{
    RenderTexturePool pool;
    const TemporaryTexture first = pool.GetTemporary(8, 4);
    const TemporaryTexture second = pool.GetTemporary(8, 4);
    EXPECT_NE(first.rt(), second.rt());
    EXPECT_EQ(pool.size(), 2u);
}

TEST(RenderTexturePool, GetsATextureBackAtTheEndOfItsScopeOrWhereAnotherTakesItsPlace)
{
    RenderTexturePool pool;
    {
        const TemporaryTexture scoped = pool.GetTemporary(8, 4);
    }
    TemporaryTexture held = pool.GetTemporary(8, 4);
    const auto first = held.rt();
    EXPECT_EQ(pool.size(), 1u);
    held = pool.GetTemporary(8, 4); // asked for before the old one went back
    EXPECT_NE(held.rt(), first);
    TemporaryTexture moved = std::move(held);
    EXPECT_EQ(pool.GetTemporary(8, 4).rt(), first);
    EXPECT_EQ(pool.size(), 2u);
}

// The order in which textures go back must not matter: a frame would never be like the last.
TEST(RenderTexturePool, GivesTheSameTexturesInTheSameOrderToEachFrame)
{
    RenderTexturePool pool;
    const auto frame = [&]
    {
        pool.BeginFrame();
        std::vector<std::shared_ptr<const RenderTexture>> textures;
        TemporaryTexture stencil = pool.GetTemporary(8, 4);
        TemporaryTexture blur = pool.GetTemporary(8, 4);
        TemporaryTexture temp = pool.GetTemporary(8, 4);
        textures = {stencil.rt(), blur.rt(), temp.rt()};
        RenderTexturePool::ReleaseTemporary(temp);
        RenderTexturePool::ReleaseTemporary(stencil);
        textures.push_back(pool.GetTemporary(8, 4).rt());
        return textures;
    };
    const auto first = frame();
    EXPECT_EQ(first[3], first[0]);
    EXPECT_EQ(frame(), first);
    EXPECT_EQ(frame(), first);
    EXPECT_EQ(pool.size(), 3u);
}

TEST(RenderTexturePool, ForgetsWhatNobodyAskedForInFifteenFrames)
{
    RenderTexturePool pool;
    const TemporaryTexture held = pool.GetTemporary(4, 4);
    pool.GetTemporary(8, 4); // and back
    for (int frame = 0; frame < 15; ++frame)
    {
        pool.BeginFrame();
    }
    EXPECT_EQ(pool.size(), 2u);
    pool.GetTemporary(8, 4);
    for (int frame = 0; frame < 15; ++frame)
    {
        pool.BeginFrame();
    }
    EXPECT_EQ(pool.size(), 2u);
    pool.BeginFrame();
    EXPECT_EQ(pool.size(), 1u) << "what is given out stays";
}

TEST(RenderTexturePool, MayGoBeforeItsTextures)
{
    TemporaryTexture texture;
    {
        RenderTexturePool pool;
        texture = pool.GetTemporary(8, 4);
    }
    EXPECT_EQ(texture.rt()->width(), 8);
}

TEST(RenderTexturePool, RefusesWhatIsNoTexture)
{
    RenderTexturePool pool;
    EXPECT_NE(test::ThrownMessage<ContractError>([&] { pool.GetTemporary(0, 4); }), "");
    EXPECT_EQ(pool.size(), 0u);
}

} // namespace
} // namespace limn

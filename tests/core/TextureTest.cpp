#include <gtest/gtest.h>
#include <limn/core/Texture.h>
#include <limn/shaderlab/Diagnostic.h>

#include "ThrownMessage.h"

namespace limn
{
namespace
{

using test::ThrownMessage;

TEST(Texture2D, KeepsWhatItIsMadeFrom)
{
    const std::vector<std::byte> texels = {std::byte{1}, std::byte{2}, std::byte{3},
                                           std::byte{4}, std::byte{5}, std::byte{6}};
    const SamplerState sampler{FilterMode::Point, TextureWrapMode::Clamp, TextureWrapMode::Mirror,
                               false};
    const Texture2D texture("mask", 3, 2, GraphicsFormat::R8_UNorm, texels, sampler);
    EXPECT_EQ(texture.name(), "mask");
    EXPECT_EQ(texture.width(), 3);
    EXPECT_EQ(texture.height(), 2);
    EXPECT_EQ(texture.graphicsFormat(), GraphicsFormat::R8_UNorm);
    EXPECT_EQ(texture.texels(), texels);
    EXPECT_EQ(texture.sampler(), sampler);
}

TEST(Texture2D, NeverUsesAnIdAgain)
{
    const auto makeId = []
    {
        return Texture2D("t", 1, 1, GraphicsFormat::R8_UNorm, {std::byte{0}}).id();
    };
    const std::uint64_t first = makeId();
    const std::uint64_t second = makeId();
    EXPECT_NE(first, second);
}

TEST(Texture2D, RejectsASizeThatIsNotPositive)
{
    EXPECT_EQ(ThrownMessage<ContractError>(
                  [] { Texture2D("noise", 0, 4, GraphicsFormat::R8_UNorm, {}); }),
              "texture 'noise': size 0x4; both must be at least 1");
    EXPECT_EQ(ThrownMessage<ContractError>(
                  [] { Texture2D("noise", 4, -1, GraphicsFormat::R8_UNorm, {}); }),
              "texture 'noise': size 4x-1; both must be at least 1");
}

TEST(Texture2D, RejectsBytesThatDoNotFitItsSize)
{
    const std::vector<std::byte> tooFew(23);
    EXPECT_EQ(ThrownMessage<ContractError>(
                  [&] { Texture2D("noise", 3, 2, GraphicsFormat::R8G8B8A8_UNorm, tooFew); }),
              "texture 'noise': 23 bytes of texels; 3x2 of R8G8B8A8_UNorm takes 24");
}

TEST(Texture2D, RejectsAFormatThatTexelsFromTheCpuCannotHave)
{
    EXPECT_EQ(
        ThrownMessage<ContractError>([] { Texture2D("noise", 1, 1, GraphicsFormat::None, {}); }),
        "texture 'noise': format None; it needs a format");
    EXPECT_EQ(ThrownMessage<ContractError>(
                  []
                  { Texture2D("z", 1, 1, GraphicsFormat::D32_SFloat, std::vector<std::byte>(4)); }),
              "texture 'z': format D32_SFloat; only a RenderTexture can hold depth");
}

} // namespace
} // namespace limn

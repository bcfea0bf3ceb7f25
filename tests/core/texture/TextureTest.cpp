#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/Texture.h>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

using test::Mentions;
using test::ThrownMessage;

TEST(Texture2D, KeepsWhatItIsMadeFrom)
{
    const std::vector<std::byte> texels = {std::byte{1}, std::byte{2}, std::byte{3},
                                           std::byte{4}, std::byte{5}, std::byte{6}};
    const SamplerState sampler{FilterMode::Point, TextureWrapMode::Clamp, TextureWrapMode::Mirror,
                               TextureWrapMode::Repeat, false};
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
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [] { Texture2D("noise", 0, 4, GraphicsFormat::R8_UNorm, {}); }),
                Mentions("'noise'", "0x4", "at least 1"));
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [] { Texture2D("noise", 4, -1, GraphicsFormat::R8_UNorm, {}); }),
                Mentions("'noise'", "4x-1", "at least 1"));
}

TEST(Texture2D, RejectsBytesThatDoNotFitItsSize)
{
    const std::vector<std::byte> tooFew(23);
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [&] { Texture2D("noise", 3, 2, GraphicsFormat::R8G8B8A8_UNorm, tooFew); }),
                Mentions("'noise'", "23 bytes", "3x2 of R8G8B8A8_UNorm", "24"));
}

TEST(Texture2D, RejectsAFormatThatTexelsFromTheCpuCannotHave)
{
    EXPECT_THAT(
        ThrownMessage<ContractError>([] { Texture2D("noise", 1, 1, GraphicsFormat::None, {}); }),
        Mentions("'noise'", "format is None"));
    EXPECT_THAT(
        ThrownMessage<ContractError>(
            [] { Texture2D("z", 1, 1, GraphicsFormat::D32_SFloat, std::vector<std::byte>(4)); }),
        Mentions("'z'", "D32_SFloat", "RenderTexture"));
}

/// `count` bytes of this value.
std::vector<std::byte> Bytes(std::size_t count, int value = 0)
{
    return std::vector<std::byte>(count, static_cast<std::byte>(value));
}

/// Faces of one byte each: 10, 11 ... 15 for `first` = 10.
CubemapFaces OneByteFaces(int first)
{
    CubemapFaces faces;
    for (std::vector<std::byte>& face : faces)
    {
        face = Bytes(1, first++);
    }
    return faces;
}

std::vector<int> TexelsOf(const TexelTexture& texture)
{
    std::vector<int> values;
    for (const std::byte texel : texture.texels())
    {
        values.push_back(std::to_integer<int>(texel));
    }
    return values;
}

constexpr GraphicsFormat k_R8 = GraphicsFormat::R8_UNorm;

TEST(Texture3D, KeepsItsSlicesInOrder)
{
    const Texture3D texture("fog", 1, 1, 3, k_R8, {std::byte{7}, std::byte{8}, std::byte{9}});
    EXPECT_EQ(texture.dimension(), TextureDimension::Tex3D);
    EXPECT_EQ(texture.slices(), 3);
    EXPECT_EQ(TexelsOf(texture), (std::vector{7, 8, 9}));
    EXPECT_EQ(texture.DescribeSize(), "1x1x3 3D");
}

TEST(Texture3D, RejectsASizeThatIsNotPositiveAndBytesThatDoNotFit)
{
    EXPECT_THAT(ThrownMessage<ContractError>([] { Texture3D("fog", 4, 4, 0, k_R8, {}); }),
                Mentions("'fog'", "4x4x0", "at least 1"));
    EXPECT_THAT(ThrownMessage<ContractError>([] { Texture3D("fog", 4, 3, 2, k_R8, Bytes(12)); }),
                Mentions("'fog'", "12 bytes", "4x3x2 of R8_UNorm", "24"));
}

TEST(Texture2DArray, KeepsItsElementsInOrder)
{
    const Texture2DArray texture("sheets", 2, 1, k_R8, {Bytes(2, 7), Bytes(2, 8)});
    EXPECT_EQ(texture.dimension(), TextureDimension::Tex2DArray);
    EXPECT_EQ(texture.slices(), 2);
    EXPECT_EQ(TexelsOf(texture), (std::vector{7, 7, 8, 8}));
    EXPECT_EQ(texture.DescribeSize(), "2x1x2 2DArray");
}

TEST(Texture2DArray, NamesTheElementThatDoesNotFit)
{
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [] {
                        Texture2DArray("sheets", 2, 2, k_R8, {Bytes(4), Bytes(5)});
                    }),
                Mentions("'sheets'", "element 1", "5 bytes", "2x2 of R8_UNorm", "4"));
    EXPECT_THAT(ThrownMessage<ContractError>([] { Texture2DArray("sheets", 2, 2, k_R8, {}); }),
                Mentions("'sheets'", "2x2x0", "at least 1"));
}

TEST(Cubemap, KeepsItsFacesInOrder)
{
    const Cubemap texture("sky", 1, k_R8, OneByteFaces(10));
    EXPECT_EQ(texture.dimension(), TextureDimension::Cube);
    EXPECT_EQ(texture.width(), 1);
    EXPECT_EQ(texture.height(), 1);
    EXPECT_EQ(texture.slices(), 6);
    EXPECT_EQ(TexelsOf(texture), (std::vector{10, 11, 12, 13, 14, 15}));
    EXPECT_EQ(texture.DescribeSize(), "1x1 Cube");
}

TEST(Cubemap, NamesTheFaceThatDoesNotFit)
{
    CubemapFaces faces = OneByteFaces(0);
    faces[3].clear();
    EXPECT_THAT(ThrownMessage<ContractError>([&] { Cubemap("sky", 1, k_R8, faces); }),
                Mentions("'sky'", "face -Y", "0 bytes", "1x1 of R8_UNorm", "1"));
    EXPECT_THAT(ThrownMessage<ContractError>([] { Cubemap("sky", -2, k_R8, CubemapFaces()); }),
                Mentions("'sky'", "-2x-2", "at least 1"));
}

/// Faces of 2x2 and of 1x1 texels.
std::vector<CubemapFaces> TwoLevels()
{
    CubemapFaces large;
    large.fill(std::vector<std::byte>(4, std::byte{7}));
    return {large, OneByteFaces(10)};
}

TEST(Cubemap, KeepsMipLevelsOfItsOwn)
{
    const Cubemap texture("sky", 2, k_R8, TwoLevels());
    EXPECT_EQ(2, texture.mipmapCount());
    EXPECT_EQ(2, texture.levelsOfTexels());
    std::vector<std::byte> expected(24, std::byte{7});
    for (int face = 10; face < 16; ++face)
    {
        expected.push_back(std::byte(face));
    }
    EXPECT_EQ(expected, texture.texels());
    EXPECT_EQ(1, Cubemap("sky", 1, k_R8, OneByteFaces(10)).levelsOfTexels());
}

TEST(Cubemap, NamesTheLevelThatDoesNotFit)
{
    std::vector<CubemapFaces> levels = TwoLevels();
    levels[1][2].resize(4);
    EXPECT_THAT(ThrownMessage<ContractError>([&] { Cubemap("sky", 2, k_R8, levels); }),
                Mentions("'sky'", "level 1", "face +Y", "4 bytes", "1x1 of R8_UNorm", "1"));
    levels.push_back(levels.back());
    EXPECT_THAT(ThrownMessage<ContractError>([&] { Cubemap("sky", 2, k_R8, levels); }),
                Mentions("'sky'", "3 mip levels", "2x2", "1 to 2"));
    levels.clear();
    EXPECT_THAT(ThrownMessage<ContractError>([&] { Cubemap("sky", 2, k_R8, levels); }),
                Mentions("'sky'", "0 mip levels", "2x2", "1 to 2"));
}

TEST(CubemapArray, KeepsItsCubesInOrder)
{
    const CubemapArray texture("skies", 1, k_R8, {OneByteFaces(10), OneByteFaces(20)});
    EXPECT_EQ(texture.dimension(), TextureDimension::CubeArray);
    EXPECT_EQ(texture.slices(), 12);
    EXPECT_EQ(TexelsOf(texture), (std::vector{10, 11, 12, 13, 14, 15, 20, 21, 22, 23, 24, 25}));
    EXPECT_EQ(texture.DescribeSize(), "1x1x12 CubeArray");
}

TEST(CubemapArray, NamesTheCubeAndFaceThatDoNotFit)
{
    CubemapFaces faces = OneByteFaces(0);
    faces[4] = Bytes(2);
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [&] {
                        CubemapArray("skies", 1, k_R8, {OneByteFaces(0), faces});
                    }),
                Mentions("'skies'", "cube 1", "face +Z", "2 bytes", "1x1 of R8_UNorm", "1"));
    EXPECT_THAT(ThrownMessage<ContractError>([] { CubemapArray("skies", 1, k_R8, {}); }),
                Mentions("'skies'", "1x1x0", "at least 1"));
}

TEST(TexelTexture, HoldsNoDepth)
{
    EXPECT_THAT(ThrownMessage<ContractError>(
                    [] { Cubemap("shadow", 1, GraphicsFormat::D32_SFloat, CubemapFaces()); }),
                Mentions("'shadow'", "D32_SFloat", "RenderTexture"));
}

} // namespace
} // namespace limn

#include "golden/GoldenImage.h"
#include "Paths.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

constexpr int k_Tolerance = 3; // of 255
constexpr double k_AllowedShare = 0.001;

/// The absolute difference times 8, opaque; and how many pixels are beyond the tolerance.
std::pair<Image, int> Diff(const Image& actual, const Image& golden)
{
    Image diff = golden;
    int beyond = 0;
    for (std::size_t pixel = 0; pixel < golden.texels.size(); pixel += 4)
    {
        int largest = 0;
        for (std::size_t channel = 0; channel < 4; ++channel)
        {
            const int distance = std::abs(std::to_integer<int>(actual.texels[pixel + channel]) -
                                          std::to_integer<int>(golden.texels[pixel + channel]));
            largest = std::max(largest, distance);
            diff.texels[pixel + channel] =
                static_cast<std::byte>(channel == 3 ? 255 : std::min(distance * 8, 255));
        }
        beyond += largest > k_Tolerance ? 1 : 0;
    }
    return {std::move(diff), beyond};
}

} // namespace

void ExpectGolden(const std::string& name, const Image& actual)
{
    namespace fs = std::filesystem;
    const fs::path path = fs::path(SourcePath("tests/golden")) / (name + ".png");
    if (std::getenv("LIMN_UPDATE_GOLDEN") != nullptr)
    {
        WritePng(path, actual);
        FAIL() << "wrote " << path << "; look at it, then run without LIMN_UPDATE_GOLDEN";
    }
    const Image golden = ReadPng(path);
    ASSERT_EQ(actual.width, golden.width);
    ASSERT_EQ(actual.height, golden.height);
    const auto [diff, beyond] = Diff(actual, golden);
    if (beyond > k_AllowedShare * golden.width * golden.height)
    {
        const fs::path folder = fs::absolute(fs::path("golden_failures") / name);
        fs::create_directories(folder);
        WritePng(folder / "actual.png", actual);
        WritePng(folder / "diff.png", diff);
        FAIL() << beyond << " of " << golden.width * golden.height << " pixels differ from " << path
               << " by more than " << k_Tolerance << "/255; see " << folder;
    }
}

} // namespace limn::test

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

/// How far a channel's value is from what a golden shows in a pixel and, within `reach`, around it.
int Distance(const Image& actual, const Image& golden, std::size_t value, int reach)
{
    const int place = static_cast<int>(value / 4);
    const int x = place % golden.width;
    const int y = place / golden.width;
    int low = 255;
    int high = 0;
    for (int row = std::max(y - reach, 0); row <= std::min(y + reach, golden.height - 1); ++row)
    {
        for (int column = std::max(x - reach, 0); column <= std::min(x + reach, golden.width - 1);
             ++column)
        {
            const auto at = static_cast<std::size_t>(row * golden.width + column) * 4 + value % 4;
            low = std::min(low, std::to_integer<int>(golden.texels[at]));
            high = std::max(high, std::to_integer<int>(golden.texels[at]));
        }
    }
    const int seen = std::to_integer<int>(actual.texels[value]);
    return std::max({low - seen, seen - high, 0});
}

/// The absolute difference times 8, opaque; and how many pixels are beyond the tolerance.
std::pair<Image, int> Diff(const Image& actual, const Image& golden, int reach)
{
    Image diff = golden;
    int beyond = 0;
    for (std::size_t pixel = 0; pixel < golden.texels.size(); pixel += 4)
    {
        int largest = 0;
        for (std::size_t channel = 0; channel < 4; ++channel)
        {
            const int distance = Distance(actual, golden, pixel + channel, reach);
            largest = std::max(largest, distance);
            diff.texels[pixel + channel] =
                static_cast<std::byte>(channel == 3 ? 255 : std::min(distance * 8, 255));
        }
        beyond += largest > k_Tolerance ? 1 : 0;
    }
    return {std::move(diff), beyond};
}

} // namespace

void ExpectGolden(const std::string& name, const Image& actual, bool mayMove)
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
    const auto [diff, beyond] = Diff(actual, golden, mayMove ? 1 : 0);
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

#include "../../../features/screen_space_ambient_occlusion/src/BlueNoise.h"

#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

namespace limn::test
{
namespace
{

std::vector<int> Values()
{
    std::vector<int> values;
    const std::vector<std::byte>& texels = BlueNoise()->texels();
    for (std::size_t i = 0; i < texels.size(); i += 4)
    {
        values.push_back(std::to_integer<int>(texels[i]));
        EXPECT_EQ(texels[i], texels[i + 3]) << "shaders read the alpha";
    }
    return values;
}

/// The mean power of the waves whose length lies between two lengths, texels.
double PowerBetween(const std::vector<int>& values, double shortest, double longest)
{
    const int size = k_BlueNoiseSize;
    double sum = 0.0;
    int count = 0;
    for (int v = -size / 2; v < size / 2; ++v)
    {
        for (int u = -size / 2; u < size / 2; ++u)
        {
            const double length = size / std::max(std::hypot(u, v), 1e-9);
            if (length < shortest || length > longest || (u + v) % 3 != 0) // a third will do
            {
                continue;
            }
            std::complex<double> wave = 0.0;
            for (int i = 0; i < size * size; ++i)
            {
                const double turn =
                    2.0 * std::numbers::pi * (u * (i % size) + v * (i / size)) / size;
                wave += (values[static_cast<std::size_t>(i)] - 127.5) * std::polar(1.0, turn);
            }
            sum += std::norm(wave);
            ++count;
        }
    }
    return sum / count;
}

TEST(BlueNoise, HasEachValueEquallyOften)
{
    std::map<int, int> counts;
    const std::vector<int> values = Values();
    ASSERT_EQ(values.size(), 48u * 48u);
    for (const int value : values)
    {
        ++counts[value];
    }
    EXPECT_EQ(counts.size(), 256u);
    for (const auto& [value, count] : counts)
    {
        EXPECT_EQ(count, 9) << value;
    }
}

TEST(BlueNoise, HasHardlyAnyLongWaves)
{
    const std::vector<int> values = Values();
    // White noise has the same power at all lengths: 2304 times the variance of 0 ... 255.
    const double white = 2304.0 * (256.0 * 256.0 - 1.0) / 12.0;
    EXPECT_LT(PowerBetween(values, 8.0, 48.0), 0.05 * white);
    EXPECT_GT(PowerBetween(values, 2.0, 2.5), 0.8 * white);
}

} // namespace
} // namespace limn::test

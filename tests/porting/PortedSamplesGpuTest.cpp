#include "PortedScene.h"

#include "vulkan/GpuTestDevice.h"

#include <algorithm>
#include <cstdlib>

namespace limn::test
{
namespace
{

class PortedSamplesGpu : public GpuTest, public testing::WithParamInterface<PortedSample>
{
protected:
    static std::vector<std::byte> Picture(PortedScene& scene)
    {
        const RenderResult result = scene.Render();
        return SharedDevice().ReadBack(*result.output.rt()).texels;
    }

    /// Of two channels, in steps of 8 bits.
    static int LargestDifference(const std::vector<std::byte>& a, const std::vector<std::byte>& b)
    {
        EXPECT_EQ(a.size(), b.size());
        int largest = 0;
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        {
            largest = std::max(largest,
                               std::abs(std::to_integer<int>(a[i]) - std::to_integer<int>(b[i])));
        }
        return largest;
    }

    /// None, but where one style draws a quad (cmd.Blit), the other a triangle (Blitter), and both
    /// look between texels. Vulkan does not promise the same last bits of what both interpolate,
    /// and a rounding to 8 bits, one a blur, may then give either neighbour; a mean of texels that
    /// are off by steps is off by no more. Lavapipe interpolates both alike.
    static int AllowedSteps()
    {
        constexpr int k_Blurs = 4; // "iterations" of the sample's scene
        const bool isLavapipe = SharedDevice().deviceName().starts_with("llvmpipe");
        return GetParam().name == std::string("blurred_glass") && !isLavapipe ? k_Blurs : 0;
    }
};

} // namespace

TEST_P(PortedSamplesGpu, DrawTheSamePictureBitForBitInBothStyles)
{
    PortedScene oldStyle(GetParam(), SharedDevice(), PortedBy::HandOld);
    PortedScene newStyle(GetParam(), SharedDevice(), PortedBy::HandNew);
    const std::vector<std::byte> expected = Picture(oldStyle);
    EXPECT_LE(LargestDifference(Picture(newStyle), expected), AllowedSteps());
    EXPECT_LE(LargestDifference(Picture(newStyle), Picture(oldStyle)), AllowedSteps())
        << "and in the next frame";
    oldStyle.SetActive(false);
    EXPECT_NE(Picture(oldStyle), expected) << "the feature is seen";
}

TEST_P(PortedSamplesGpu, DrawTheSamePictureByHandAndByLimnPort)
{
    PortedScene byHand(GetParam(), SharedDevice(), PortedBy::HandOld);
    const std::vector<std::byte> expected = Picture(byHand);
    for (const PortedBy by : {PortedBy::LimnOld, PortedBy::LimnNew})
    {
        PortedScene byLimn(GetParam(), SharedDevice(), by);
        const int allowed = by == PortedBy::LimnNew ? AllowedSteps() : 0;
        EXPECT_LE(LargestDifference(Picture(byLimn), expected), allowed) << static_cast<int>(by);
        EXPECT_LE(LargestDifference(Picture(byLimn), expected), allowed) << "in the next frame";
    }
}

INSTANTIATE_TEST_SUITE_P(Each, PortedSamplesGpu, testing::ValuesIn(k_PortedSamples),
                         [](const auto& tested) { return std::string(tested.param.name); });

} // namespace limn::test

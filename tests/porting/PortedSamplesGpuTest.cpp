#include "PortedScene.h"

#include "vulkan/GpuTestDevice.h"

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
};

} // namespace

TEST_P(PortedSamplesGpu, DrawTheSamePictureBitForBitInBothStyles)
{
    PortedScene oldStyle(GetParam(), SharedDevice(), false);
    PortedScene newStyle(GetParam(), SharedDevice(), true);
    const std::vector<std::byte> expected = Picture(oldStyle);
    EXPECT_EQ(Picture(newStyle), expected);
    EXPECT_EQ(Picture(newStyle), Picture(oldStyle)) << "and in the next frame";
    oldStyle.SetActive(false);
    EXPECT_NE(Picture(oldStyle), expected) << "the feature is seen";
}

INSTANTIATE_TEST_SUITE_P(Each, PortedSamplesGpu, testing::ValuesIn(k_PortedSamples),
                         [](const auto& tested) { return std::string(tested.param.name); });

} // namespace limn::test

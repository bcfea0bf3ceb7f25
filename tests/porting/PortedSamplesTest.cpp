#include "PortedScene.h"

#include "features/render_graph/CompiledText.h"
#include <gmock/gmock.h>
#include <limn/core/RecordingDevice.h>

namespace limn::test
{
namespace
{

class PortedSamples : public testing::TestWithParam<PortedSample>
{
};

} // namespace

TEST_P(PortedSamples, CompileToNoMoreInTheNewStyleThanInTheOld)
{
    RecordingDevice oldDevice;
    RecordingDevice newDevice;
    PortedScene oldStyle(GetParam(), oldDevice, PortedBy::HandOld);
    PortedScene newStyle(GetParam(), newDevice, PortedBy::HandNew);
    for (int frame = 0; frame < 3; ++frame)
    {
        const RenderResult expected = oldStyle.Render();
        const RenderResult actual = newStyle.Render();
        EXPECT_LE(PassesOf(actual).size(), PassesOf(expected).size())
            << testing::PrintToString(PassesOf(actual))
            << testing::PrintToString(PassesOf(expected));
        EXPECT_LE(TextureCount(actual), TextureCount(expected));
        EXPECT_THAT(expected.report.notes, testing::IsEmpty());
        EXPECT_THAT(actual.report.notes, testing::IsEmpty());
    }
}

TEST_P(PortedSamples, CostNothingWhereTheyAreNotActive)
{
    RecordingDevice device;
    PortedScene scene(GetParam(), device, PortedBy::HandOld);
    const std::vector<std::string> with = PassesOf(scene.Render());
    scene.SetActive(false);
    scene.Render();
    const std::vector<std::string> without = PassesOf(scene.Render());
    EXPECT_LE(without.size(), 1u);
    EXPECT_NE(with, without);
}

INSTANTIATE_TEST_SUITE_P(Each, PortedSamples, testing::ValuesIn(k_PortedSamples),
                         [](const auto& tested) { return std::string(tested.param.name); });

} // namespace limn::test

#include "PluginRun.h"

#include <gmock/gmock.h>
#include <limn/core/Image.h>

namespace limn::test
{

TEST(PluginGpu, DrawsWithItsShaderWhatItsComponentSays)
{
    const PluginFolder folder;
    ASSERT_THAT(folder.Run("render s.scene.yaml -o o.png --plugin probe.so"),
                testing::EndsWith("exit 0\n"));
    const Image image = ReadPng("o.png");
    ASSERT_EQ(64u * 4, image.texels.size());
    for (std::size_t i = 0; i < image.texels.size(); i += 4)
    {
        // sRGB shows a light of 0.75 as 1.055 * 0.75^(1 / 2.4) - 0.055 = 0.8809 of 255.
        EXPECT_NEAR(224.6, std::to_integer<int>(image.texels[i]), 1.0);
        EXPECT_EQ(0, std::to_integer<int>(image.texels[i + 1]));
        EXPECT_EQ(0, std::to_integer<int>(image.texels[i + 2]));
    }
}

TEST(PluginGpu, IsInTheSceneThatReportMeasures)
{
    const PluginFolder folder;
    const std::string arguments = "report s.scene.yaml -o report --quick";
    EXPECT_THAT(folder.Run(arguments), testing::HasSubstr("unknown feature 'ProbeFeature'"));
    EXPECT_THAT(folder.Run(arguments + " --plugin probe.so"),
                testing::HasSubstr("no active feature outlines anything"));
}

TEST(PluginGpu, HasTechniquesThatReportKnows)
{
    const PluginFolder folder;
    folder.Write("o.scene.yaml", "size: [16, 16]\ncamera: {position: [0, 0, -3]}\n"
                                 "renderer: {features: [{type: StrokeOutlineRendererFeature}]}\n"
                                 "objects: [{name: ball, mesh: sphere}]\n");
    const std::string arguments = "report o.scene.yaml -o report --technique Redpaint";
    EXPECT_THAT(folder.Run(arguments), testing::HasSubstr("unknown technique 'Redpaint' (known: "));
    EXPECT_THAT(folder.Run(arguments + " --plugin probe.so"),
                testing::HasSubstr("did you mean 'Red paint'?"));
}

} // namespace limn::test

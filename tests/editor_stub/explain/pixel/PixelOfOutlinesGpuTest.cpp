#include "explain/pixel/PixelTest.h"

namespace limn::test
{

namespace
{

/// A selected square of 16 ... 48, another one left of it, and an outline of 4 pixels around the
/// first, by this feature and component.
std::string OutlinedScene(const std::string& feature)
{
    return "size: [64, 64]\n"
           "layers: {6: Selectable}\n"
           "renderingLayers: {8: Selected}\n"
           "camera: {orthographic: true, orthographicSize: 1, position: [0, 0, -5],\n"
           "         backgroundColor: \"#000000\"}\n"
           "renderer:\n"
           "  features:\n"
           "    - {type: " +
           feature +
           "RendererFeature, name: Line, m_LayerMask: Selectable, m_RenderingLayerMask: "
           "Selected}\n"
           "volumes: [{name: V, profile: " +
           feature +
           ".profile.yaml}]\n"
           "materials: {dark: {shader: Universal Render Pipeline/Unlit, _BaseColor: "
           "\"#0000ff\"}}\n"
           "objects:\n"
           "  - {name: Chosen, mesh: quad, material: dark, layer: Selectable,\n"
           "     renderingLayerMask: [Default, Selected]}\n"
           "  - {name: Plain, mesh: quad, material: dark, layer: Selectable,\n"
           "     position: [-0.75, 0, 1], scale: [0.5, 2, 1]}\n";
}

} // namespace

class PixelHistoryOfOutlines : public PixelHistoryGpu
{
protected:
    PixelHistory TraceOutline(const std::string& feature, int x, int y)
    {
        folder.Write(feature + ".profile.yaml",
                     feature + ": {m_Enable: true, m_OutlineColor: \"#00ff00\", "
                               "m_OutlineWidth: 4}\n");
        return Trace(folder.Load(OutlinedScene(feature)), x, y);
    }

    static bool IsGreen(const PixelHistory& history)
    {
        return history.written[1] == 255 && history.written[0] == 0 && history.written[2] == 0;
    }
};

TEST_F(PixelHistoryOfOutlines, FindTheOutlineInItsBandAndNotBeyond)
{
    for (const char* feature : {"StrokeOutline", "WideOutline"})
    {
        const PixelHistory band = TraceOutline(feature, 50, 32);
        EXPECT_TRUE(IsGreen(band)) << feature;
        EXPECT_TRUE(ChangesCamera(band, "Line")) << feature;
        EXPECT_THAT(band.uncovered, testing::Contains("Chosen")) << feature;

        const PixelHistory beyond = TraceOutline(feature, 62, 32);
        EXPECT_FALSE(IsGreen(beyond)) << feature;
        EXPECT_FALSE(ChangesCamera(beyond, "Line")) << feature;
        const bool isNamed = HasEvent(beyond, "Line", PixelFate::OutOfReach) ||
                             HasEvent(beyond, "Line", PixelFate::Blend) ||
                             std::ranges::any_of(beyond.uncoveredDraws, [](const auto& draws)
                                                 { return draws.pass == "Line"; });
        EXPECT_TRUE(isNamed) << feature;
    }
}

TEST_F(PixelHistoryOfOutlines, TellWhichFilterLeavesAnObjectWithoutOutline)
{
    const PixelHistory history = TraceOutline("WideOutline", 4, 32);
    EXPECT_EQ(PixelFate::Drawn, EventOf(history, "Plain").fate);
    const bool isFiltered =
        std::ranges::any_of(history.filtered,
                            [](const PixelFiltered& one)
                            {
                                return one.object == "Plain" && one.pass == "Line" &&
                                       one.verdict == FilterVerdict::RenderingLayerMaskMiss;
                            });
    EXPECT_TRUE(isFiltered);
}

TEST_F(PixelHistoryOfOutlines, SayThatAFullScreenPassDoesNotReachSoFar)
{
    folder.Write("X.profile.yaml", "ScreenSpaceOutline: {m_Enable: true, m_OutlineWidth: 2}\n");
    std::string scene = OutlinedScene("X");
    const std::string named = "XRendererFeature";
    scene.replace(scene.find(named), named.size(),
                  "ScreenSpaceOutlineRenderFeature, m_ScreenSpaceOutlineShader: "
                  "Hidden/ScreenSpaceOutline");
    // Large enough that the passes are worth drawing in a part only.
    scene.replace(scene.find("64, 64"), 6, "512, 512");
    const PixelHistory near = Trace(folder.Load(scene), 385, 256);
    EXPECT_TRUE(HasEvent(near, "Line", PixelFate::Drawn));
    const PixelHistory far = Trace(folder.Load(scene), 500, 20);
    EXPECT_TRUE(HasEvent(far, "Line", PixelFate::OutOfReach));
    EXPECT_FALSE(HasEvent(far, "Line", PixelFate::Drawn));
    EXPECT_THAT(far.written, testing::ElementsAre(0, 0, 0));
}

} // namespace limn::test

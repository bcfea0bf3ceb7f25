#include "Mentions.h"
#include "commands/CommandRun.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

using testing::HasSubstr;

/// A cube in the middle of the picture with an outline around it, and the places where one line
/// more keeps the outline away.
struct Way
{
    const char* name;
    std::string profile = "WideOutline: {m_Enable: true}\n";
    std::string camera{};
    std::string feature{}; ///< of the outline's entry in the renderer
    std::string volume{};
    std::string object{};
    std::string more{};                         ///< of the file
    std::vector<std::string> told{};            ///< parts of a line that `explain` prints
    std::vector<std::string> toldOfTheObject{}; ///< parts of a line of `explain --object Cube`
    const char* shader = "Universal Render Pipeline/Unlit";

    std::string Scene() const
    {
        return "camera: {position: [0, 0, -5]" + camera +
               "}\n"
               "size: [64, 64]\n"
               "layers: {6: Furniture}\n"
               "renderingLayers: {3: Chosen}\n"
               "renderer:\n"
               "  features:\n"
               "    - {type: WideOutlineRendererFeature, name: Outline" +
               feature +
               "}\n"
               "volumes:\n"
               "  - {name: On, profile: on.profile.yaml" +
               volume +
               "}\n"
               "materials:\n"
               "  Plain: {shader: " +
               shader +
               "}\n"
               "objects:\n"
               "  - {name: Cube, mesh: Cube, material: Plain" +
               object + "}\n" + more;
    }
};

void PrintTo(const Way& way, std::ostream* out)
{
    *out << way.name;
}

const std::vector<std::string> k_NoVolume{"Outline:", "not drawn", "no volume",
                                          "WideOutline.m_Enable"};
constexpr const char* k_OnlyDepth =
    "Shader \"Only/Depth\" { SubShader { Pass { Tags { \"LightMode\" = \"DepthOnly\" }\n"
    "HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
    "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
    "float4 F() : SV_Target { return 1; }\nENDHLSL } } }\n";

const Way k_Ways[] = {
    {.name = "Layer",
     .feature = ", m_LayerMask: Furniture",
     .told = {"Outline:", "not drawn", "the layer mask leaves out 1"},
     .toldOfTheObject = {"Outline, Plain: left out, layer mask"}},
    {.name = "RenderingLayer",
     .feature = ", m_RenderingLayerMask: Chosen",
     .told = {"Outline:", "not drawn", "rendering layer mask leaves out 1"},
     .toldOfTheObject = {"Outline, Plain: left out, rendering layer mask"}},
    {.name = "RenderQueue",
     .feature = ", m_RenderQueueRange: Transparent",
     .told = {"Outline:", "not drawn", "render queue range leaves out 1"},
     .toldOfTheObject = {"Outline, Plain: left out, render queue"}},
    {.name = "VolumeOff",
     .volume = ", enabled: false",
     .told = {"On: it is off"},
     .toldOfTheObject = k_NoVolume},
    {.name = "WeightOfZero",
     .volume = ", weight: 0",
     .told = {"On: its weight is 0"},
     .toldOfTheObject = k_NoVolume},
    {.name = "VolumeFarAway",
     .volume = ", isGlobal: false, blendDistance: 1, position: [0, 0, 50], colliders: [{type: "
               "sphere, radius: 1}]",
     .told = {"On:", "camera", "54 m", "collider"},
     .toldOfTheObject = k_NoVolume},
    {.name = "VolumeInAnotherLayer",
     .camera = ", volumeLayerMask: [Default]",
     .volume = ", layer: Furniture",
     .told = {"On: its layer"},
     .toldOfTheObject = k_NoVolume},
    {.name = "WidthOfZero",
     .profile = "WideOutline: {m_Enable: true, m_OutlineWidth: 0}\n",
     .told = {"Outline:", "not drawn", "WideOutline.m_OutlineWidth is 0"},
     .toldOfTheObject = {"Outline:", "not drawn", "WideOutline.m_OutlineWidth is 0"}},
    {.name = "AlphaOfZero",
     .profile = "WideOutline: {m_Enable: true, m_OutlineColor: {r: 1, g: 1, b: 1, a: 0}}\n",
     .told = {"Outline:", "not drawn", "WideOutline.m_OutlineColor", "alpha 0"},
     .toldOfTheObject = {"Outline:", "not drawn", "WideOutline.m_OutlineColor", "alpha 0"}},
    {.name = "BehindTheCamera",
     .object = ", position: [0, 0, -20]",
     .told = {"1 object of 1", "outside", "frustum", "Cube"},
     .toldOfTheObject = {"Cube:", "not drawn", "outside", "frustum"}},
    {.name = "OffScreen",
     .object = ", position: [40, 0, 0]",
     .told = {"1 object of 1", "outside", "frustum", "Cube"},
     .toldOfTheObject = {"Cube:", "not drawn", "outside", "frustum"}},
    {.name = "CullingMask",
     .camera = ", cullingMask: [Furniture]",
     .told = {"1 object of 1", "layer", "culling mask", "Cube"},
     .toldOfTheObject = {"Cube:", "not drawn", "layer", "culling mask"}},
    {.name = "LightMode",
     .told = {"Outline:", "not drawn", "1 has no pass", "LightMode"},
     .toldOfTheObject = {"Outline, Plain: left out", "no pass", "LightMode"},
     .shader = "depth.shader"},
    {.name = "FeatureOff",
     .feature = ", active: false",
     .told = {"Outline:", "not drawn", "inactive"},
     .toldOfTheObject = {"Outline:", "not drawn", "inactive"}},
    {.name = "ComponentThatNoVolumeSets",
     .profile = "StrokeOutline: {m_Enable: true}\n",
     .told = k_NoVolume,
     .toldOfTheObject = k_NoVolume},
};

class NoOutline : public testing::TestWithParam<Way>
{
};

TEST_P(NoOutline, IsExplained)
{
    const Way& way = GetParam();
    const TemporaryFolder folder;
    folder.Write("on.profile.yaml", way.profile);
    folder.Write("depth.shader", k_OnlyDepth);
    const std::string scene = folder.Write("s.scene.yaml", way.Scene()).string();
    const CommandRun all = RunCommand({"explain", scene});
    EXPECT_EQ(0, all.exitCode) << all.err;
    EXPECT_THAT(LinesOf(all.out), testing::Contains(MentionsInOrder(way.told)));
    const CommandRun object = RunCommand({"explain", scene, "--object", "Cube"});
    EXPECT_EQ(0, object.exitCode) << object.err;
    EXPECT_THAT(LinesOf(object.out), testing::Contains(MentionsInOrder(way.toldOfTheObject)));
}

/// What the file asks for and is not there is an error of the file.
TEST(NoOutlineAtAll, IsRefusedWithTheCause)
{
    const TemporaryFolder folder;
    folder.Write("on.profile.yaml", "WideOutline: {m_Enable: true}\n");
    const auto explain = [&](const Way& way, const std::vector<std::string>& more)
    {
        std::vector<std::string> args{"explain",
                                      folder.Write("s.scene.yaml", way.Scene()).string()};
        args.insert(args.end(), more.begin(), more.end());
        const CommandRun run = RunCommand(args);
        EXPECT_NE(0, run.exitCode);
        return run.err;
    };
    EXPECT_THAT(explain({.name = "", .shader = "Unlit/Texure"}, {}), HasSubstr("Unlit/Texure"))
        << "a shader that is none";
    EXPECT_THAT(explain({.name = "", .feature = "}\n    - {type: GlowFeature"}, {}),
                HasSubstr("unknown feature 'GlowFeature'"))
        << "a feature of a plug-in that is not loaded";
    EXPECT_THAT(explain({.name = "", .more = "  - {name: Empty}\n"}, {"--object", "Empty"}),
                HasSubstr("unknown object with a mesh 'Empty'"))
        << "an object without a mesh";
}

INSTANTIATE_TEST_SUITE_P(Ways, NoOutline, testing::ValuesIn(k_Ways),
                         [](const auto& way) { return std::string(way.param.name); });

} // namespace
} // namespace limn::test

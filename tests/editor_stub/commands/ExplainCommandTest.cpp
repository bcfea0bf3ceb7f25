#include "Mentions.h"
#include "Paths.h"
#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

constexpr const char* k_ExplainedScene = "camera: {position: [0, 0, -5]}\n"
                                         "size: [64, 64]\n"
                                         "volumes:\n"
                                         "  - {name: Placement, profile: p.profile.yaml}\n"
                                         "  - name: Corner\n"
                                         "    profile: q.profile.yaml\n"
                                         "    isGlobal: false\n"
                                         "    priority: 1\n"
                                         "    weight: 0.5\n"
                                         "    blendDistance: 4\n"
                                         "    position: [0, 0, -2]\n"
                                         "    colliders: [{type: sphere, radius: 1}]\n"
                                         "objects:\n"
                                         "  - {name: Seen, mesh: Cube}\n"
                                         "  - {name: Behind, mesh: Cube, position: [0, 0, -50]}\n"
                                         "  - {name: Off, mesh: Cube, active: false}\n";

class ExplainCommand : public testing::Test
{
protected:
    CommandRun Explain(const std::vector<std::string>& more = {},
                       const std::string& scene = k_ExplainedScene) const
    {
        m_Folder.Write("p.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 4}\n");
        m_Folder.Write("on.profile.yaml", "ScreenSpaceOutline: {m_Enable: true}\n");
        m_Folder.Write("q.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 8}\n");
        const std::filesystem::path path = m_Folder.Write("s.scene.yaml", scene);
        std::vector<std::string> args{"explain", path.string()};
        args.insert(args.end(), more.begin(), more.end());
        return RunCommand(args);
    }

    TemporaryFolder m_Folder;
};

TEST_F(ExplainCommand, ShowsTheShadowMapAndWhoThrowsShadowsOnly)
{
    const std::string objects = "size: [64, 64]\n"
                                "shadows: {mainLightShadowmapResolution: 256}\n"
                                "objects:\n"
                                "  - {name: Floor, mesh: Plane, position: [0, -1, 0]}\n"
                                "  - {name: Roof, mesh: Cube, shadowCastingMode: ShadowsOnly}\n";
    const CommandRun run =
        Explain({}, "camera: {position: [0, 0, -5]}\nlight: {shadows: Soft}\n" + objects);
    EXPECT_THAT(run.out, HasSubstr("  50   MainLightShadow: 2 of 2 drawn"));
    EXPECT_THAT(run.out, HasSubstr("_MainLightShadowmapTexture 256x256 D32_SFloat"));
    EXPECT_THAT(run.out, HasSubstr("1 object of 2 is not drawn, it only throws shadows: Roof\n"));
    EXPECT_THAT(Explain({}, "camera: {position: [0, 0, -5]}\n" + objects).out,
                testing::Not(HasSubstr("MainLightShadow")));
}

TEST_F(ExplainCommand, ShowsTheSkyboxWhereItIsDrawn)
{
    const char* const sky = "size: [64, 64]\n"
                            "skybox: sky\n"
                            "materials: {sky: {shader: Skybox/Procedural}}\n";
    EXPECT_THAT(Explain({}, std::string("camera: {clearFlags: Skybox}\n") + sky).out,
                HasSubstr("  350  Draw Skybox\n"));
    EXPECT_THAT(Explain({}, std::string("camera: {clearFlags: SolidColor}\n") + sky).out,
                testing::Not(HasSubstr("Skybox")));
}

TEST_F(ExplainCommand, FitsOnAScreenWithWhatIsOddFirst)
{
    const CommandRun run = Explain();
    EXPECT_EQ(0, run.exitCode);
    EXPECT_EQ("", run.err);
    EXPECT_EQ("odd:\n"
              "  1 object of 3 is not drawn, inactive: Off\n"
              "  1 object of 3 is not drawn, outside the camera's frustum: Behind\n"
              "the camera takes volumes at:\n"
              "  (0, 0, -5), its own position; layers 0\n"
              "volume values:\n"
              "  ScreenSpaceOutline.m_OutlineWidth 5.5 ← Placement, Corner\n"
              "passes:\n"
              "  250  Draw Opaque Objects: 1 of 1 drawn\n"
              "  450  Draw Transparent Objects: 0 of 1 drawn; left out: 1 render queue\n"
              "  1001 Final Blit\n"
              "the device runs:\n"
              "  1 Draw Opaque Objects, 64x64: 1 draw; limn_Output (clear, store), "
              "_CameraDepthAttachment (clear, -); 2 barriers\n"
              "left out:\n"
              "  Final Blit: 'limn_Output' is drawn into directly: nothing else reads "
              "'_CameraColorAttachmentA', nor blends with it\n"
              "textures drawn into:\n"
              "  limn_Output 64x64 R8G8B8A8_SRGB, 16.0 KiB, pass 1 and after\n"
              "  _CameraDepthAttachment 64x64 D32_SFloat, 16.0 KiB, pass 1\n"
              "3 objects, 3 textures of 32.0 KiB, 1 shader variant of 2 built: -v lists them, "
              "--object NAME and --pixel X,Y explain one\n",
              run.out);
}

TEST_F(ExplainCommand, CountsByFeatureAndVerdictAndSaysWhatAFeatureLacks)
{
    const CommandRun run = Explain({}, "camera: {position: [0, 0, -5]}\n"
                                       "layers: {6: Furniture}\n"
                                       "renderer:\n"
                                       "  features:\n"
                                       "    - type: ScreenSpaceOutlineRenderFeature\n"
                                       "      name: Outline\n"
                                       "      m_ScreenSpaceOutlineShader: "
                                       "Hidden/ScreenSpaceOutline\n"
                                       "      m_LayerMask: [Furniture]\n"
                                       "      m_RenderingLayerMask: 1\n"
                                       "volumes: [{name: On, profile: on.profile.yaml}]\n"
                                       "objects:\n"
                                       "  - {name: A, mesh: cube}\n"
                                       "  - {name: B, mesh: cube}\n"
                                       "  - {name: C, mesh: cube, layer: Furniture}\n");
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out,
                testing::StartsWith("odd:\n"
                                    "  Outline: 0 of 3 renderers are drawn: the layer mask "
                                    "leaves out 2, and the rendering layer mask leaves "
                                    "out 1\n"));
    EXPECT_THAT(run.out, HasSubstr("  500  Outline: 0 of 3 drawn; left out: 2 layer mask, 1 "
                                   "rendering layer mask\n"));
}

TEST_F(ExplainCommand, CannotBeCommandedToForgeALine)
{
    const CommandRun run = Explain({}, "camera: {position: [0, 0, -5]}\n"
                                       "objects: [{name: \"A\\n  B\\e[2J\", mesh: cube, active: "
                                       "false}]\n");
    EXPECT_THAT(run.out, testing::StartsWith(
                             "odd:\n  1 object of 1 is not drawn, inactive: A\\n  B\\x1B[2J\n"));
}

TEST_F(ExplainCommand, TellsWhereEveryVolumeValueComesFrom)
{
    const CommandRun run = Explain({"-v"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out,
                HasSubstr("volume values:\n"
                          "  ScreenSpaceOutline.m_OutlineWidth ← Placement (factor 1, weight 1, "
                          "global) → 4\n"
                          "  ScreenSpaceOutline.m_OutlineWidth ← Corner (factor 0.375, weight 0.5, "
                          "distance 2 m) → 5.5\n"));
}

TEST_F(ExplainCommand, TellsWhereTheCameraTakesVolumes)
{
    EXPECT_THAT(Explain().out, HasSubstr("the camera takes volumes at:\n"
                                         "  (0, 0, -5), its own position; layers 0\n"));
    const std::string own = "{camera: {volumeTrigger: [1, 2, 3], volumeLayerMask: [0, 4]}}";
    EXPECT_THAT(Explain({}, own).out, HasSubstr("(1, 2, 3), its volumeTrigger; layers 0 4\n"));
    const auto json = nlohmann::json::parse(Explain({"--json"}, own).out);
    EXPECT_EQ(nlohmann::json::parse("[1, 2, 3]"), json.at("trigger").at("position"));
    EXPECT_EQ(17, json.at("trigger").at("volumeLayerMask"));
    const std::string none = "camera: {volumeLayerMask: Nothing}";
    EXPECT_THAT(Explain({}, none).out, HasSubstr("its own position; no layer\n"));
}

TEST_F(ExplainCommand, TellsWhyAVolumeChangesNothing)
{
    m_Folder.Write("idle.profile.yaml", "ScreenSpaceOutline: {m_Enable: true}\n");
    const std::string scene = "camera: {}\nvolumes:\n"
                              "  - {name: Placement, profile: idle.profile.yaml, weight: 0}\n"
                              "  - {name: All, profile: idle.profile.yaml}\n";
    EXPECT_THAT(Explain({}, scene).out, HasSubstr("volumes that change nothing:\n"
                                                  "  Placement: its weight is 0\n"
                                                  "volume values:\n"));
    const auto idle = nlohmann::json::parse(Explain({"--json"}, scene).out).at("idleVolumes");
    ASSERT_EQ(1u, idle.size());
    EXPECT_EQ("Placement", idle.at(0).at("name"));
}

TEST_F(ExplainCommand, ListsThePassesOfShadersWithTheirKeywordsAndEveryTextureUsed)
{
    m_Folder.Write("own.shader",
                   "Shader \"Test/Own\" { Properties { _BaseMap (\"Map\", 2D) = \"red\" {} }\n"
                   "SubShader { Pass { Name \"Only\" Blend One One\nHLSLPROGRAM\n"
                   "#pragma vertex V\n#pragma fragment F\n"
                   "#pragma multi_compile WARM COLD\n#pragma multi_compile _ OFF\n"
                   "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/"
                   "Core.hlsl\"\n"
                   "TEXTURE2D(_BaseMap); SAMPLER(sampler_BaseMap);\n"
                   "float4 V(float4 p : POSITION) : SV_POSITION\n"
                   "{ return TransformObjectToHClip(p.xyz); }\n"
                   "half4 F() : SV_Target\n"
                   "{ return SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, float2(0, 0)); }\n"
                   "ENDHLSL\n} } }\n");
    const std::string scene = "{camera: {position: [0, 0, -5]}, size: [64, 32],\n"
                              " materials: {own: {shader: own.shader}},\n"
                              " objects: [{name: A, mesh: cube, material: own},\n"
                              "           {name: B, mesh: sphere, material: own}]}\n";
    const CommandRun run = Explain({"-v"}, scene);
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out, HasSubstr("variants:\n  Test/Own, pass 0 'Only': WARM\n"));
    EXPECT_THAT(run.out, HasSubstr("full screen: no keywords\n"));
    EXPECT_THAT(run.out, HasSubstr("  red 1x1 R8G8B8A8_UNorm, 4 B, pass 1\n"));
    EXPECT_THAT(run.out, HasSubstr(" 64x32 R8G8B8A8_SRGB, 8.0 KiB, pass 2 and after\n"));
    const auto json = nlohmann::json::parse(Explain({"--json"}, scene).out);
    EXPECT_EQ(nlohmann::json::parse(R"({"shader": "Test/Own", "pass": 0, "name": "Only",
                                        "keywords": ["WARM"], "fullScreen": false})"),
              json.at("variants")[0]);
}

TEST_F(ExplainCommand, NamesEveryOneOfManyObjects)
{
    constexpr int k_Count = 1000;
    std::string scene = "camera: {position: [0, 0, -5]}\nobjects:\n";
    for (int i = 0; i < k_Count; ++i)
    {
        scene += "  - {name: O" + std::to_string(i) + ", mesh: cube}\n";
    }
    const auto json = nlohmann::json::parse(Explain({"--json"}, scene).out);
    ASSERT_EQ(static_cast<std::size_t>(k_Count), json.at("objects").size());
    for (const auto& object : json.at("objects"))
    {
        EXPECT_TRUE(object.at("draws")[0].at("drawn")) << object.at("name");
    }
}

TEST_F(ExplainCommand, TellsWhyEachObjectIsDrawnOrNot)
{
    const CommandRun run = Explain({"-v"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_THAT(run.out, HasSubstr("  Seen\n"));
    EXPECT_THAT(run.out, HasSubstr("Default-Material: drawn\n"));
    EXPECT_THAT(run.out, HasSubstr("Default-Material: left out, render queue\n"));
    EXPECT_THAT(run.out, HasSubstr("  Behind: it is not drawn; outside the camera's frustum\n"));
    EXPECT_THAT(run.out, HasSubstr("  Off: it is not drawn; inactive\n"));
}

TEST_F(ExplainCommand, ShowsOnlyTheObjectAskedFor)
{
    const CommandRun run = Explain({"--object", "Off"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ("Off: it is not drawn; inactive\n", run.out);
    EXPECT_EQ("Seen\n"
              "  Draw Opaque Objects, Default-Material: drawn\n"
              "  Draw Transparent Objects, Default-Material: left out, render queue\n",
              Explain({"--object", "Seen"}).out);
}

/// Five features that could draw the cubes: one does, the others do not, each for another reason.
constexpr const char* k_SceneOfFeatures =
    "camera: {position: [0, 0, -5]}\n"
    "size: [64, 64]\n"
    "layers: {6: Furniture}\n"
    "renderingLayers: {3: Chosen}\n"
    "renderer:\n"
    "  features:\n"
    "    - {type: WideOutlineRendererFeature, name: Wide, m_LayerMask: Everything}\n"
    "    - {type: StrokeOutlineRendererFeature, name: Strokes, m_LayerMask: Everything,\n"
    "       m_RenderingLayerMask: Chosen}\n"
    "    - {type: RimOutlineRendererFeature, name: Rim, m_LayerMask: Furniture}\n"
    "    - {type: InflatedOutlineRendererFeature, name: Hull, m_LayerMask: Everything}\n"
    "    - {type: SelectionOutlineRendererFeature, name: Off, m_LayerMask: Everything,\n"
    "       active: false}\n"
    "volumes:\n"
    "  - {name: On, profile: outlines.profile.yaml}\n"
    "objects: [{name: A, mesh: Cube}, {name: B, mesh: Cube}]\n";

constexpr const char* k_OutlinesOn = "WideOutline: {m_Enable: true}\n"
                                     "StrokeOutline: {m_Enable: true}\n"
                                     "RimOutline: {m_Enable: true}\n"
                                     "SelectionOutline: {m_Enable: true}\n";

TEST_F(ExplainCommand, NamesEveryFeatureThatCouldDrawTheObjectAndTheRuleThatKeptItOut)
{
    m_Folder.Write("outlines.profile.yaml", k_OutlinesOn);
    EXPECT_EQ(
        "A\n"
        "  Draw Opaque Objects, Default-Material: drawn\n"
        "  Draw Transparent Objects, Default-Material: left out, render queue\n"
        "  Wide, Default-Material: drawn\n"
        "  Strokes, Default-Material: left out, rendering layer mask\n"
        "  Rim, Default-Material: left out, layer mask\n"
        "features that draw nothing:\n"
        "  Hull: it is not drawn; no volume at the camera sets InflatedOutline.m_Enable, which is "
        "false by default\n"
        "  Off: it is not drawn; the feature is inactive\n",
        Explain({"--object", "A"}, k_SceneOfFeatures).out);
}

TEST_F(ExplainCommand, CountsTheFiltersOfFeaturesThatDoNotDrawByDrawRenderers)
{
    m_Folder.Write("outlines.profile.yaml", k_OutlinesOn);
    const CommandRun run = Explain({}, k_SceneOfFeatures);
    EXPECT_THAT(run.out, HasSubstr("Wide: 2 of 2 drawn\n"));
    const auto json =
        nlohmann::json::parse(Explain({"--json"}, k_SceneOfFeatures).out, nullptr, false);
    ASSERT_TRUE(json.is_object());
    EXPECT_EQ(4u, json["idleFeatures"].size());
    EXPECT_EQ("Off", json["idleFeatures"][3]["name"]);
    EXPECT_THAT(json["idleFeatures"][3]["why"].get<std::string>(),
                Mentions("not drawn", "inactive"));
    EXPECT_EQ("rendering layer mask", json["objects"][0]["draws"][3]["rule"]);
}

/// The filter takes the object, and yet nothing of it is drawn.
TEST_F(ExplainCommand, TellsWhatKeepsAFeatureFromDrawingAnObjectThatItTakes)
{
    m_Folder.Write("outlines.profile.yaml",
                   "MaskDifferenceOutline: {m_Enable: true, m_ClipDistance: 0.1}\n");
    const CommandRun run =
        Explain({"--object", "A"}, "camera: {position: [0, 0, -5]}\n"
                                   "renderer:\n"
                                   "  features:\n"
                                   "    - {type: MaskDifferenceOutlineRendererFeature, name: Mask, "
                                   "m_LayerMask: Everything}\n"
                                   "volumes: [{name: On, profile: outlines.profile.yaml}]\n"
                                   "objects: [{name: A, mesh: Cube}]\n");
    EXPECT_THAT(run.out, HasSubstr("  Mask, Default-Material: taken, but it is not drawn; "));
}

TEST(ExplainSample, CountsWhatHangsBelowTheObjectAskedFor)
{
    std::vector<std::string> args{
        "explain", test::SourcePath("samples/furniture/furniture.scene.yaml"), "--object", "Sofa"};
    const CommandRun run = RunCommand(args);
    EXPECT_EQ(0, run.exitCode) << run.err;
    EXPECT_EQ("Sofa, 16 objects:\n"
              "  Draw Opaque Objects: 13 of 16 drawn; left out: 3 render queue\n"
              "  Draw Transparent Objects: 3 of 16 drawn; left out: 13 render queue\n"
              "  Screen Space Outline: 13 of 16 drawn; left out: 3 render queue\n"
              "-v lists the objects\n",
              run.out);
    args.push_back("-v");
    const std::string all = RunCommand(args).out;
    EXPECT_THAT(all, HasSubstr("Screen Space Outline, petrol: drawn\n"));
    EXPECT_THAT(all, testing::Not(HasSubstr("Slab")));
    EXPECT_THAT(all, testing::Not(HasSubstr("Screen Space Outline, oak: drawn\n")));
}

TEST(ExplainSample, FitsOnAScreen)
{
    const std::string text =
        RunCommand({"explain", test::SourcePath("samples/furniture/furniture.scene.yaml")}).out;
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 24);
    EXPECT_THAT(text, HasSubstr("  500  Screen Space Outline: 13 of 370 drawn; left out: 241 "
                                "rendering layer mask, 72 render queue, 44 layer mask\n"));
}

TEST_F(ExplainCommand, RefusesAnObjectThatIsNotThere)
{
    const CommandRun run = Explain({"--object", "Sen"});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_EQ("", run.out);
    EXPECT_THAT(run.err, Mentions("s.scene.yaml:", "unknown object", "'Sen'", "'Seen'"));
}

TEST_F(ExplainCommand, GivesTheSameToProgramsAsJson)
{
    const CommandRun run = Explain({"--json"});
    ASSERT_EQ(0, run.exitCode) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    ASSERT_EQ(1u, json.at("volumes").size());
    const auto& width = json.at("volumes")[0];
    EXPECT_EQ("m_OutlineWidth", width.at("parameter"));
    EXPECT_EQ("3", width.at("default"));
    EXPECT_EQ("5.5", width.at("value"));
    ASSERT_EQ(2u, width.at("steps").size());
    EXPECT_TRUE(width.at("steps")[0].at("distance").is_null());
    EXPECT_EQ(0.375, width.at("steps")[1].at("factor"));
    EXPECT_EQ(2.0, width.at("steps")[1].at("distance"));
    EXPECT_FALSE(json.at("passes").empty());
    EXPECT_FALSE(json.at("textures").empty());
    EXPECT_FALSE(json.at("variants").empty());
    EXPECT_EQ("Behind", json.at("objects")[1].at("name"));
    EXPECT_EQ("outside the camera's frustum", json.at("objects")[1].at("absence"));
}

TEST_F(ExplainCommand, NamesWhatIsWrongWithAShapeAndItsWeight)
{
    const CommandRun run = Explain(
        {}, "camera: {}\nvolumes:\n  - name: V\n    profile: p.profile.yaml\n    isGlobal: false\n"
            "    weight: .nan\n    colliders: [{type: spher}, {type: capsule, direction: w}]\n");
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, HasSubstr("volume 'V'.weight: '.nan' is not a finite number"));
    EXPECT_THAT(run.err,
                Mentions("volume 'V'.colliders[0].type:", "unknown shape", "'spher'", "'sphere'"));
    EXPECT_THAT(run.err,
                Mentions("volume 'V'.colliders[1].direction:", "'w'", "no axis", "x, y or z"));
}

} // namespace

} // namespace limn::test

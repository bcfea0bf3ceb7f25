#include "Mentions.h"
#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limn::test
{

namespace
{

using testing::HasSubstr;
using testing::Not;

constexpr const char* k_Scene =
    "size: [64, 64]\n"
    "camera: {position: [0, 0, -10]}\n"
    "layers: {6: Selectable}\n"
    "renderingLayers: {8: Selected}\n"
    "renderer:\n"
    "  features:\n"
    "    - {type: ScreenSpaceOutlineRenderFeature, name: Outline,\n"
    "       m_ScreenSpaceOutlineShader: Hidden/ScreenSpaceOutline,\n"
    "       m_RenderQueueRange: Opaque, m_LayerMask: Selectable, m_RenderingLayerMask: Selected}\n"
    "volumes:\n"
    "  - {name: Placement, profile: p.profile.yaml}\n"
    "  - {name: Corner, profile: q.profile.yaml, isGlobal: false, priority: 1,\n"
    "     position: [0, 0, 5], colliders: [{type: sphere, radius: 1}]}\n"
    "materials: {shadow: {_BaseColor: \"#ffffff\", renderQueue: 3000}}\n"
    "objects:\n"
    "  - name: Sofa\n"
    "    layer: Selectable\n"
    "    renderingLayerMask: [Default, Selected]\n"
    "    children:\n"
    "      - {name: Seat, mesh: cube}\n"
    "      - {name: Back, mesh: cube}\n"
    "      - {name: Leg, mesh: cube}\n"
    "      - {name: Leg, mesh: cube}\n"
    "      - {name: Shadow, mesh: cube, material: shadow}\n"
    "  - {name: Lamp, mesh: cube, layer: Selectable, renderingLayerMask: [Default, Selected]}\n"
    "  - {name: Rug, mesh: cube, layer: Selectable}\n"
    "  - {name: Off, mesh: cube, layer: Selectable, renderingLayerMask: Selected, active: false}\n"
    "  - {name: 'A<&\"B', mesh: cube}\n"
    "  - {name: \"no\\uFFFFcharacter\", mesh: cube}\n";

const std::string k_Good =
    "features:\n"
    "  Outline:\n"
    "    drawn: [Sofa, not Shadow, Lamp]  # all that is selected\n"
    "    drawnAtLeast: [Sofa/Seat]\n"
    "    notDrawn: [Rug, Shadow]\n"
    "    passes: {Outline: {drawn: [Seat, Back, Leg, Lamp]}}\n"
    "passes:\n"
    "  Draw Transparent Objects:\n"
    "    drawn:\n"
    "      - Shadow\n"
    "values:\n"
    "  - at: camera\n"
    "    ScreenSpaceOutline.m_OutlineWidth: 4\n"
    "    ScreenSpaceOutline.outlineColor: {r: 1, g: 0.5, b: 0}\n"
    "  - at: {x: 0, y: 0, z: 5}\n"
    "    ScreenSpaceOutline.m_OutlineWidth: 8\n"
    "order:\n"
    "  - Draw Opaque Objects\n"
    "  - Draw Transparent Objects\n"
    "  - Outline\n"
    "  - Final Blit\n"
    "orderAtLeast: [Draw Opaque Objects, Final Blit]\n"
    "textures:\n"
    "  _CameraDepthAttachment: {size: 64x64, format: D32_SFloat, samples: 1}\n"
    "leftOut: []\n"
    "notLeftOut: [Outline]\n";
constexpr int k_GoodCount = 15; // expectations of k_Good

class CheckCommand : public testing::Test
{
protected:
    CheckCommand()
    {
        WriteScene(k_Scene);
        m_Folder.Write("p.profile.yaml", "ScreenSpaceOutline: {m_Enable: true, m_OutlineWidth: 4, "
                                         "m_OutlineColor: {r: 1, g: 0.5, b: 0}}\n");
        m_Folder.Write("q.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 8}\n");
    }

    void WriteScene(const std::string& text) const { m_Folder.Write("s.scene.yaml", text); }
    std::string Expect(const std::string& text) const
    {
        return m_Folder.Write("e.yaml", text).string();
    }

    CommandRun Check(const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> args{"check", (m_Folder / "s.scene.yaml").string(),
                                      (m_Folder / "e.yaml").string()};
        args.insert(args.end(), more.begin(), more.end());
        return RunCommand(args);
    }

    /// What is printed of these expectations, the folder's path taken out.
    std::string Printed(const std::string& expectations, int exitCode,
                        const std::vector<std::string>& more = {}) const
    {
        Expect(expectations);
        const CommandRun run = Check(more);
        EXPECT_EQ(exitCode, run.exitCode) << run.out << run.err;
        std::string text = run.out + run.err;
        const std::string path = (m_Folder / "").string();
        for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path))
        {
            text.erase(at, path.size());
        }
        return text;
    }

    TemporaryFolder m_Folder;
};

std::string Replace(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t at = text.find(what);
    EXPECT_NE(std::string::npos, at) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

} // namespace

TEST_F(CheckCommand, SaysThatAllHolds)
{
    EXPECT_EQ(std::to_string(k_GoodCount) + " expectations, 0 failed\n", Printed(k_Good, 0));
}

TEST_F(CheckCommand, OpensNoDevice)
{
    Expect(k_Good);
    const std::string command =
        "VK_ICD_FILENAMES=/nonexistent VK_DRIVER_FILES=/nonexistent '" + LimnExecutable() + "' ";
    const std::string scene = "'" + (m_Folder / "s.scene.yaml").string() + "' ";
    EXPECT_THAT(RunInPipe(command + "render " + scene + "-o " + (m_Folder / "a.png").string() +
                          " 2>&1; echo $?"),
                testing::EndsWith("\n3\n"));
    EXPECT_EQ(std::to_string(k_GoodCount) + " expectations, 0 failed\n0\n",
              RunInPipe(command + "check " + scene + "'" + (m_Folder / "e.yaml").string() +
                        "' 2>&1; echo $?"));
}

TEST_F(CheckCommand, ShowsWhoIsMissingAndWhoIsTooMuch)
{
    EXPECT_EQ("e.yaml:1:22: features.Outline.drawn\n"
              "  - Rug  expected, but left out: rendering layer mask\n"
              "  - Off  expected, but left out: inactive\n"
              "  + Sofa (4 of 5 renderers)  drawn, but not expected\n"
              "1 expectation, 1 failed\n",
              Printed("features: {Outline: {drawn: [Lamp, Rug, Off]}}\n", 1));
    EXPECT_EQ("e.yaml:1:22: features.Outline.drawnAtLeast\n"
              "  - Shadow  expected, but left out: render queue\n"
              "1 expectation, 1 failed\n",
              Printed("features: {Outline: {drawnAtLeast: [Sofa]}}\n", 1));
    EXPECT_EQ("e.yaml:1:22: features.Outline.notDrawn\n"
              "  + Lamp  drawn, but not expected\n"
              "1 expectation, 1 failed\n",
              Printed("features: {Outline: {notDrawn: [Lamp, Rug]}}\n", 1));
    EXPECT_EQ("e.yaml:1:41: features.Outline.passes.Outline.drawn\n"
              "  + Sofa (4 of 5 renderers)  drawn, but not expected\n"
              "1 expectation, 1 failed\n",
              Printed("features: {Outline: {passes: {Outline: {drawn: [Lamp]}}}}\n", 1));
    EXPECT_THAT(Printed("passes: {Draw Transparent Objects: {drawn: []}}\n", 1),
                HasSubstr("+ Shadow  drawn, but not expected"));
}

TEST_F(CheckCommand, TellsSeveralOfOnePathApart)
{
    WriteScene(Replace(k_Scene, "{name: Leg, mesh: cube}",
                       "{name: Leg, mesh: cube, renderingLayerMask: Default}"));
    EXPECT_THAT(Printed("features: {Outline: {drawn: [Seat, Back, Leg, Lamp]}}\n", 1),
                HasSubstr("  - Leg/#1  expected, but left out: rendering layer mask\n"));
    EXPECT_EQ("1 expectation, 0 failed\n",
              Printed("features: {Outline: {drawn: [Seat, Back, Leg/#2, Lamp]}}\n", 0));
}

TEST_F(CheckCommand, SaysWhyAFeatureThatIsOffDrawsNothing)
{
    EXPECT_THAT(Printed("features: {Outline: {drawn: [Lamp]}}\n", 1,
                        {"--set", "ScreenSpaceOutline.m_Enable=false"}),
                HasSubstr("- Lamp  expected, but left out: it is not drawn; "));
}

TEST_F(CheckCommand, TakesProfilesValuesAndASelection)
{
    EXPECT_EQ("1 expectation, 0 failed\n",
              Printed("features: {Outline: {drawn: [Rug]}}\n", 0, {"--select", "Rug"}));
    const std::string wide = "values: [{at: camera, ScreenSpaceOutline.m_OutlineWidth: 8}]\n";
    Printed(wide, 1);
    Printed(wide, 0, {"--profile", (m_Folder / "q.profile.yaml").string()});
    Printed(wide, 0, {"--set", "ScreenSpaceOutline.m_OutlineWidth=8"});
}

TEST_F(CheckCommand, ComparesBlendedValues)
{
    EXPECT_EQ(
        "e.yaml:1:35: values[0].ScreenSpaceOutline.m_OutlineWidth\n"
        "  - 5  expected\n"
        "  + 8  found, by Placement, Corner\n"
        "1 expectation, 1 failed\n",
        Printed("values: [{at: {x: 0, y: 0, z: 5}, ScreenSpaceOutline.m_OutlineWidth: 5}]\n", 1));
    EXPECT_THAT(Printed("values:\n- at: camera\n  ScreenSpaceOutline.m_OutlineWidth: 5\n", 1),
                HasSubstr("e.yaml:3:3: values[0].ScreenSpaceOutline.m_OutlineWidth\n"));
    EXPECT_THAT(
        Printed("values: [{at: camera, ScreenSpaceOutline.m_OutlineColor: [1, 0.5, 1]}]\n", 1),
        HasSubstr("  + {r: 1, g: 0.5, b: 0, a: 1}  found, by Placement\n"));
}

TEST_F(CheckCommand, ComparesNumbersWithinAMillionthOrTheTolerance)
{
    const auto expect = [](const std::string& width, const std::string& more = "")
    {
        return "values: [{at: camera, " + more + "ScreenSpaceOutline.m_OutlineWidth: " + width +
               "}]\n";
    };
    Printed(expect("4.000002"), 0); // half a millionth
    Printed(expect("4.00001"), 1);
    Printed(expect("4.25", "tolerance: 0.25, "), 0);
    Printed(expect("4.3", "tolerance: 0.25, "), 1);
}

TEST_F(CheckCommand, ShowsPassesThatRunElsewhere)
{
    EXPECT_EQ("e.yaml:1:1: order\n"
              "  - Final Blitt  expected here, but it does not run here; did you mean "
              "'Final Blit'?\n"
              "  + Outline  runs here, but is not expected here\n"
              "  + Final Blit  runs here, but is not expected here\n"
              "1 expectation, 1 failed\n",
              Printed("order: [Draw Opaque Objects, Draw Transparent Objects, Final Blitt]\n", 1));
    EXPECT_THAT(Printed("orderAtLeast: [Final Blit, Outline]\n", 1),
                HasSubstr("does not run behind those before it"));
}

TEST_F(CheckCommand, ComparesTextures)
{
    EXPECT_EQ("e.yaml:1:37: textures._CameraDepthAttachment.size\n"
              "  - 32x32  expected\n"
              "  + 64x64  found\n"
              "1 expectation, 1 failed\n",
              Printed("textures: {_CameraDepthAttachment: {size: 32x32}}\n", 1));
    EXPECT_THAT(Printed("textures: {_CameraDepthAttachment: {format: R8_UNorm}}\n", 1),
                HasSubstr("  - R8_UNorm  expected\n  + D32_SFloat  found\n"));
    EXPECT_THAT(Printed("textures: {_CameraDepthAttachment: {samples: 4}}\n", 1),
                HasSubstr("  - 4  expected\n  + 1  found\n"));
}

TEST_F(CheckCommand, ComparesWhatIsLeftOut)
{
    WriteScene("size: [64, 64]\ncamera: {position: [0, 0, -10]}\n"
               "objects: [{name: Box, mesh: cube}]\n"); // whose output is drawn into at once
    EXPECT_EQ("1 expectation, 0 failed\n", Printed("leftOut: [Final Blit]\n", 0));
    EXPECT_THAT(Printed("leftOut: []\n", 1), HasSubstr("  + Final Blit: 'limn_Output' is drawn"));
    EXPECT_THAT(Printed("notLeftOut: [Final Blit]\n", 1),
                HasSubstr("  + Final Blit  left out, but not expected: "));
    EXPECT_THAT(Printed("leftOutAtLeast: [Final Blot]\n", 1),
                HasSubstr("  - Final Blot  expected to be left out, but it is not; did you mean "
                          "'Final Blit'?\n"));
}

TEST_F(CheckCommand, NamesEveryProblemOfTheFileAtOnce)
{
    EXPECT_THAT(
        LinesOf(Printed("features:\n"
                        "  Outlin: {drawn: [Sofa]}\n"
                        "  Outline:\n"
                        "    drawn: [Lampp, not Sofa/Seatt]\n"
                        "    notdrawn: [Rug]\n"
                        "    drawnAtLeast: Sofa\n"
                        "    passes: {Outlines: {}}\n"
                        "values:\n"
                        "  - at: camera\n"
                        "    ScreenSpaceOutline.m_OutlineWidht: 4\n"
                        "    ScreenSpaceOutlin.m_OutlineWidth: 4\n"
                        "    ScreenSpaceOutline.m_OutlineWidth: 400\n"
                        "    tolerence: 3\n"
                        "  - at: kamera\n"
                        "textures: {limn_Output: {sise: 1x1}}\n"
                        "ordr: []\n",
                        1)),
        testing::ElementsAre(
            Mentions("e.yaml:2:3:", "unknown feature", "'Outlin'", "'Outline'"),
            Mentions("e.yaml:4:13:", "features.Outline.drawn", "unknown object", "'Lampp'",
                     "'Lamp'"),
            Mentions("e.yaml:4:20:", "features.Outline.drawn", "unknown object", "'Sofa/Seatt'",
                     "'Sofa/Seat'"),
            Mentions("e.yaml:5:5:", "features.Outline", "unknown key", "'notdrawn'", "'notDrawn'"),
            Mentions("e.yaml:6:19:", "features.Outline.drawnAtLeast", "'Sofa'", "list",
                     "[Sofa, Lamp]"),
            Mentions("e.yaml:10:5:", "values[0]", "unknown parameter", "'m_OutlineWidht'",
                     "'m_OutlineWidth'"),
            Mentions("e.yaml:11:5:", "values[0]", "unknown volume component", "'ScreenSpaceOutlin'",
                     "'ScreenSpaceOutline'"),
            Mentions("e.yaml:12:40:", "values[0].ScreenSpaceOutline.m_OutlineWidth", "400",
                     "outside", "[1, 10]"),
            Mentions("e.yaml:13:5:", "values[0]", "unknown key", "'tolerence'", "'tolerance'",
                     "'Component.parameter: value'"),
            Mentions("e.yaml:14:9:", "values[1].at", "'kamera'", "camera or {x: 0, y: 1, z: 0}"),
            Mentions("e.yaml:15:26:", "textures.limn_Output", "unknown key", "'sise'", "'size'"),
            Mentions("e.yaml:16:1:", "unknown key", "'ordr'", "'order'")));
}

TEST_F(CheckCommand, FailsForPassesAndTexturesThatTheFrameDoesNotHave)
{
    const std::string text = "features: {Outline: {passes: {Outlines: {notDrawn: [Rug]}}}}\n"
                             "passes: {Blur: {drawn: []}}\n"
                             "textures: {limn_Outpt: {size: 1x1}}\n";
    EXPECT_EQ("e.yaml:1:42: features.Outline.passes.Outlines.notDrawn\n"
              "  - Outlines  no pass of this name runs; did you mean 'Outline'?\n"
              "e.yaml:2:17: passes.Blur.drawn\n"
              "  - Blur  no pass of this name runs\n"
              "e.yaml:3:25: textures.limn_Outpt.size\n"
              "  - limn_Outpt  the frame has no texture of this name; did you mean 'limn_Output'?\n"
              "3 expectations, 3 failed\n",
              Printed(text, 1));
    EXPECT_THAT(Printed(text, 1, {"--update"}), HasSubstr("e.yaml:3:25: error: "));
    EXPECT_EQ(text, ReadText(m_Folder / "e.yaml"));
    EXPECT_THAT(Printed("passes: {Blur: {drawn: []}}\n", 1, {"--update"}),
                Mentions("e.yaml:1:17:", "passes.Blur.drawn", "written"));
}

TEST_F(CheckCommand, RefusesFilesThatExpectNothingOrAreNone)
{
    EXPECT_THAT(Printed("features: {}\n", 1), Mentions("e.yaml:1:1:", "expects nothing"));
    EXPECT_THAT(Printed("", 1), HasSubstr("e.yaml: error: the file is empty"));
    EXPECT_THAT(Printed("features: [a\n", 1), HasSubstr("e.yaml:"));
    EXPECT_THAT(Printed("values: {at: camera}\n", 1),
                Mentions("e.yaml:1:9:", "values", "map", "list"));
    EXPECT_THAT(Printed("values: [{ScreenSpaceOutline.m_OutlineWidth: 4}]\n", 1),
                Mentions("e.yaml:1:10:", "values[0]", "'at'", "missing"));
    EXPECT_THAT(Printed("order: [a]\n---\norder: []\n", 1), HasSubstr("a second document"));
    std::filesystem::remove(m_Folder / "e.yaml");
    EXPECT_THAT(Check().err, HasSubstr("e.yaml: error: there is no such file\n"));
}

TEST_F(CheckCommand, UpdatesNothingButTheWrongValues)
{
    const std::string broken =
        Replace(Replace(Replace(Replace(k_Good, "[Sofa, not Shadow, Lamp]", "[Sofa, Rug, Gone]"),
                                "m_OutlineWidth: 8", "m_OutlineWidth: 5"),
                        "  - Outline\n", ""),
                "size: 64x64", "size: 1x1");
    EXPECT_THAT(
        Printed(broken, 0, {"--update"}),
        testing::AllOf(HasSubstr("  - Gone  no object has this name\n"),
                       HasSubstr(std::to_string(k_GoodCount) + " expectations, 4 written anew\n")));
    EXPECT_EQ(k_Good, ReadText(m_Folder / "e.yaml"));
    EXPECT_EQ(0, Check().exitCode);
    EXPECT_THAT(Check({"--update"}).out, HasSubstr(" 0 written anew\n"));
    EXPECT_EQ(k_Good, ReadText(m_Folder / "e.yaml"));
}

TEST_F(CheckCommand, UpdatesListsWithDashesAndMapsWithKeys)
{
    const std::string before = "passes:\n"
                               "  Draw Transparent Objects:\n"
                               "    drawn:   # a comment\n"
                               "    - Lamp\n"
                               "    # another\n"
                               "    - Rug\n"
                               "\n"
                               "    # what follows\n"
                               "    notDrawn: [Lamp]\n"
                               "values:\n"
                               "  - at: camera\n"
                               "    ScreenSpaceOutline.m_OutlineColor:\n"
                               "      r: 0\n"
                               "      g: 1\n"
                               "    ScreenSpaceOutline.m_OutlineWidth: 3   # wide\n"
                               "leftOut: [\"a, ]b\", 'it''s']\n";
    Printed(Replace(before, "      g: 1\n", "      g: 1\n      b: 0\n"), 0, {"--update"});
    EXPECT_EQ("passes:\n"
              "  Draw Transparent Objects:\n"
              "    drawn:   # a comment\n"
              "    - Shadow\n"
              "\n"
              "    # what follows\n"
              "    notDrawn: [Lamp]\n"
              "values:\n"
              "  - at: camera\n"
              "    ScreenSpaceOutline.m_OutlineColor:\n"
              "      {r: 1, g: 0.5, b: 0, a: 1}\n"
              "    ScreenSpaceOutline.m_OutlineWidth: 4   # wide\n"
              "leftOut: []\n",
              ReadText(m_Folder / "e.yaml"));
    EXPECT_EQ(0, Check().exitCode);
}

TEST_F(CheckCommand, UpdateLeavesAFileWithErrorsOrAliasesAlone)
{
    for (const std::string text : {"features: {Outlin: {drawn: []}}\n",
                                   "features: {Outline: {drawn: &a [Rug], drawnAtLeast: *a}}\n",
                                   "features: {Outline: {notDrawn: &a [Rug], drawnAtLeast: *a}}\n",
                                   "values: [{at: camera, ScreenSpaceOutline.m_OutlineWidth: &w "
                                   "4}, {at: [0, 0, 5], ScreenSpaceOutline.m_OutlineWidth: *w}]\n"})
    {
        EXPECT_THAT(Printed(text, 1, {"--update"}), HasSubstr("e.yaml:1:"));
        EXPECT_EQ(text, ReadText(m_Folder / "e.yaml"));
    }
}

TEST_F(CheckCommand, UpdateWritesAFileThatIsNotThereInFull)
{
    const CommandRun run = Check({"--update"});
    EXPECT_EQ(0, run.exitCode) << run.err;
    const std::string text = ReadText(m_Folder / "e.yaml");
    EXPECT_THAT(text, HasSubstr("features:\n"
                                "  Outline:\n"
                                "    drawn: [Sofa, not Shadow, Lamp]\n"
                                "values:\n"
                                "  - at: camera\n"
                                "    ScreenSpaceOutline.m_Enable: true\n"));
    EXPECT_THAT(text, HasSubstr("\norder: [Draw Opaque Objects, Draw Transparent Objects, Outline, "
                                "Final Blit]\n"));
    EXPECT_THAT(text, HasSubstr("  _CameraDepthAttachment: {size: 64x64, format: D32_SFloat, "
                                "samples: 1}\n"));
    EXPECT_THAT(text, testing::EndsWith("leftOut: []\n"));
    EXPECT_EQ(run.out, Check().out);
}

TEST_F(CheckCommand, WritesFullFilesOfUnityProjectsAndOfOddNames)
{
    const std::string file = (m_Folder / "y.yaml").string();
    const std::vector<std::string> yard{"check", SourcePath("tests/editor_stub/data/yard"), file};
    std::vector<std::string> update = yard;
    update.emplace_back("--update");
    EXPECT_EQ(0, RunCommand(update).exitCode);
    EXPECT_THAT(ReadText(file), HasSubstr("  Outline:\n    drawn: [Right/Upper]\n"));
    EXPECT_THAT(RunCommand(yard).out, HasSubstr(" expectations, 0 failed\n"));

    WriteScene(Replace(k_Scene, "name: Lamp", "name: \"La, mp\\t'\\\"]: #\""));
    EXPECT_EQ(0, Check({"--update"}).exitCode);
    EXPECT_EQ(0, Check().exitCode);
    EXPECT_THAT(ReadText(m_Folder / "e.yaml"), HasSubstr("\"La, mp\\x09'\\\"]: #\"]\n"));
}

TEST_F(CheckCommand, WritesNeitherOverTheSceneNorOverTheExpectations)
{
    Expect(k_Good);
    for (const char* file : {"s.scene.yaml", "e.yaml", "p.profile.yaml"})
    {
        const std::string before = ReadText(m_Folder / file);
        EXPECT_EQ(1, Check({"--junit", (m_Folder / file).string()}).exitCode);
        EXPECT_EQ(before, ReadText(m_Folder / file));
    }
    EXPECT_EQ(1, RunCommand({"check", (m_Folder / "s.scene.yaml").string(),
                             (m_Folder / "p.profile.yaml").string(), "--update"})
                     .exitCode);
}

TEST_F(CheckCommand, WritesJUnitThatAParserOfXmlReads)
{
    Expect("features:\n"
           "  Outline: {drawnAtLeast: ['A<&\"B', \"no\\uFFFFcharacter\"], notDrawn: [Rug]}\n");
    const std::string file = (m_Folder / "results.xml").string();
    EXPECT_EQ(1, Check({"--junit", file}).exitCode);
    const std::string script =
        "import sys, xml.etree.ElementTree as tree\n"
        "suite = tree.parse(sys.argv[1]).getroot().find(\"testsuite\")\n"
        "print(suite.get(\"tests\"), suite.get(\"failures\"))\n"
        "for case in suite.iter(\"testcase\"):\n"
        "    failure = case.find(\"failure\")\n"
        "    print(case.get(\"name\"), case.get(\"line\"), failure is not None)\n"
        "    print(failure.get(\"message\") if failure is not None else \"\")\n";
    m_Folder.Write("read.py", script);
    EXPECT_EQ("2 1\n"
              "features.Outline.drawnAtLeast 2 True\n"
              "- A<&\"B  expected, but left out: layer mask\n"
              "features.Outline.notDrawn 2 False\n"
              "\n",
              RunInPipe("python3 '" + (m_Folder / "read.py").string() + "' '" + file + "' 2>&1"));
}

TEST_F(CheckCommand, PrintsJson)
{
    Expect("features: {Outline: {drawn: [Lamp], notDrawn: [Rug]}}\n");
    const CommandRun run = Check({"--json"});
    EXPECT_EQ(1, run.exitCode);
    const nlohmann::json json = nlohmann::json::parse(run.out);
    EXPECT_EQ(1, json["failed"]);
    EXPECT_EQ("features.Outline.drawn", json["expectations"][0]["name"]);
    EXPECT_EQ(false, json["expectations"][0]["holds"]);
    EXPECT_EQ(1, json["expectations"][0]["line"]);
    EXPECT_EQ(22, json["expectations"][0]["column"]);
    EXPECT_EQ("+ Sofa (4 of 5 renderers)  drawn, but not expected",
              json["expectations"][0]["diff"][0]);
    EXPECT_EQ(true, json["expectations"][1]["holds"]);
}

TEST_F(CheckCommand, ExplainsItsUsage)
{
    EXPECT_EQ(2, RunCommand({"check", "s.scene.yaml"}).exitCode);
    EXPECT_EQ(2, RunCommand({"check", "a", "b", "--update", "--json"}).exitCode);
    EXPECT_THAT(RunCommand({"help", "check"}).out,
                HasSubstr("Replace the values that do not hold"));
}

TEST_F(CheckCommand, HoldsForTheSamples)
{
    for (const std::string sample : {"selection", "furniture"})
    {
        const std::string base = SourcePath("samples/" + sample + "/" + sample);
        std::vector<std::string> args{"check", base + ".scene.yaml", base + ".expect.yaml"};
        if (sample == "selection")
        {
            args.insert(args.end(),
                        {"--profile", SourcePath("samples/selection/strokes.profile.yaml")});
        }
        const CommandRun run = RunCommand(args);
        EXPECT_EQ(0, run.exitCode) << run.out << run.err;
        EXPECT_THAT(run.out, Not(HasSubstr("\n  ")));
    }
}

} // namespace limn::test

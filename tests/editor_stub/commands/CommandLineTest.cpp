#include "Mentions.h"
#include "Paths.h"
#include "commands/CommandRun.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <limn/editor_stub/AssetContext.h>

namespace limn::test
{

namespace
{

using testing::HasSubstr;

/// Runs `limn render` on files that are wrong.
class BadInput : public testing::Test
{
protected:
    std::string Path(const std::string& name) const { return (folder / name).generic_string(); }

    CommandRun Render(const std::string& scene, const std::vector<std::string>& more = {}) const
    {
        folder.Write("s.scene.yaml", scene);
        std::vector<std::string> args{"render", Path("s.scene.yaml"), "-o", Path("out.png")};
        args.insert(args.end(), more.begin(), more.end());
        return RunCommand(args);
    }

    /// The run failed with lines that mention these parts each, wrote nothing to stdout and left no
    /// file but `inputs`.
    void ExpectRefusal(const CommandRun& run, const std::vector<std::vector<std::string>>& lines,
                       int inputs) const
    {
        EXPECT_EQ(1, run.exitCode);
        const std::vector<std::string> written = LinesOf(run.err);
        ASSERT_EQ(lines.size(), written.size()) << run.err;
        for (std::size_t i = 0; i < lines.size(); ++i)
        {
            EXPECT_THAT(written[i], MentionsInOrder(lines[i]));
        }
        EXPECT_EQ("", run.out);
        EXPECT_EQ(inputs, folder.fileCount());
    }

    TemporaryFolder folder;
};

constexpr const char* k_Camera = "camera: {}\n";

} // namespace

TEST_F(BadInput, AMissingSceneIsNamed)
{
    ExpectRefusal(RunCommand({"render", Path("no.scene.yaml"), "-o", Path("out.png")}),
                  {{Path("no.scene.yaml") + ":", "no such file"}}, 0);
}

TEST_F(BadInput, AnUnknownKeyComesWithASuggestion)
{
    ExpectRefusal(Render("camera: {}\nambientLigth: red\n"),
                  {{Path("s.scene.yaml") + ":2:1:", "scene", "unknown key", "'ambientLigth'",
                    "'ambientLight'"}},
                  1);
}

TEST_F(BadInput, AWidthOf14IsOutsideItsRange)
{
    folder.Write("w.profile.yaml", "ScreenSpaceOutline:\n  m_OutlineWidth: 14\n");
    ExpectRefusal(Render(k_Camera, {"--profile", "w.profile.yaml"}),
                  {{Path("w.profile.yaml") + ":2:19:", "ScreenSpaceOutline.m_OutlineWidth", "14",
                    "outside", "[1, 10]"}},
                  2);
}

TEST_F(BadInput, NanIsNoNumber)
{
    ExpectRefusal(Render("camera: {fieldOfView: .nan}\n"),
                  {{Path("s.scene.yaml") + ":1:23:", "camera.fieldOfView", "'.nan'", "finite"}}, 1);
}

TEST_F(BadInput, ADuplicateKeyIsNamedWithItsFirstPlace)
{
    ExpectRefusal(Render("camera: {}\ncamera: {}\n"),
                  {{Path("s.scene.yaml") + ":2:1:", "duplicate", "'camera'", "1:1"}}, 1);
}

TEST_F(BadInput, AMissingShaderFileIsNamed)
{
    ExpectRefusal(
        Render("camera: {}\nmaterials: {a: {shader: no.shader}}\n"),
        {{Path("s.scene.yaml") + ":2:25:", "material 'a'.shader", "'no.shader'", "cannot be used"},
         {Path("no.shader") + ":", "no such file"}},
        1);
}

TEST_F(BadInput, AnHlslErrorIsReportedAtItsLineOfTheShaderFile)
{
    folder.Write("bad.shader", "Shader \"Bad\"\n"
                               "{\n"
                               "    SubShader\n"
                               "    {\n"
                               "        Pass\n"
                               "        {\n"
                               "            HLSLPROGRAM\n"
                               "            #pragma vertex V\n"
                               "            #pragma fragment F\n"
                               "            float4 V(float4 p : POSITION) : SV_POSITION\n"
                               "            {\n"
                               "                return p;\n"
                               "            }\n"
                               "            float4 F() : SV_Target\n"
                               "            {\n"
                               "                return missing;\n"
                               "            }\n"
                               "            ENDHLSL\n"
                               "        }\n"
                               "    }\n"
                               "}\n");
    ExpectRefusal(Render("camera: {}\n"
                         "materials: {a: {shader: bad.shader}}\n"
                         "objects: [{name: A, mesh: cube, material: a}]\n"),
                  {{Path("bad.shader") + ":16:24:", "'missing': unknown variable"}}, 2);
}

TEST_F(BadInput, AMissingMeshIsNamed)
{
    ExpectRefusal(
        Render("camera: {}\nobjects: [{name: A, mesh: no.glb}]\n"),
        {{Path("s.scene.yaml") + ":2:27:", "object 'A'.mesh", "'no.glb'", "cannot be used"},
         {Path("no.glb") + ":", "no such file"}},
        1);
}

TEST_F(BadInput, AnUnknownLayerComesWithTheKnownOnes)
{
    ExpectRefusal(Render("camera: {}\nlayers: {6: Furniture}\nobjects: [{name: A, layer: Sofa}]\n"),
                  {{Path("s.scene.yaml") + ":3:28:", "object 'A'.layer", "unknown layer", "'Sofa'",
                    "Default, Furniture"}},
                  1);
}

TEST_F(BadInput, AnEmptySceneSaysSo)
{
    ExpectRefusal(Render(""), {{Path("s.scene.yaml") + ":", "empty", "'name:'"}}, 1);
}

TEST_F(BadInput, ABinarySceneSaysSo)
{
    ExpectRefusal(Render(std::string("camera\0: {}", 11)),
                  {{Path("s.scene.yaml") + ":1:7:", "NUL", "binary", "UTF-16"}}, 1);
}

TEST_F(BadInput, ASetOutsideItsRangeNamesTheOption)
{
    ExpectRefusal(Render(k_Camera, {"--set", "ScreenSpaceOutline.m_OutlineWidth=14"}),
                  {{"--set ScreenSpaceOutline.m_OutlineWidth=14:",
                    "ScreenSpaceOutline.m_OutlineWidth", "14", "outside", "[1, 10]"}},
                  1);
}

TEST_F(BadInput, ACacheFolderThatCannotBeMadeIsNamed)
{
    folder.Write("file", "");
    ExpectRefusal(Render(k_Camera, {"--cache-dir", Path("file/cache")}),
                  {{Path("file/cache") + ":", "cache folder", "Not a directory"}}, 2);
}

// None of these files is one that render draws.

TEST_F(BadInput, AProfileInPlaceOfASceneIsToldApart)
{
    const std::string profile = Path("w.profile.yaml");
    const std::string renamed = Path("w.yaml");
    folder.Write("w.profile.yaml", "ScreenSpaceOutline:\n  m_OutlineWidth: 4\n");
    folder.Write("w.yaml", "ScreenSpaceOutline:\n  m_OutlineWidth: 4\n");
    for (const std::string& file : {profile, renamed})
    {
        ExpectRefusal(RunCommand({"render", file, "-o", Path("out.png")}),
                      {{file + ":", "'render'", "volume profile",
                        "'limn render SCENE -o out.png --profile " + file + "'",
                        "'limn inspect " + file + "'"}},
                      2);
    }
}

TEST_F(BadInput, AShaderIsNothingToInspect)
{
    folder.Write("a.shader", "Shader \"A\" {}");
    for (const std::string verb : {"inspect", "explain"})
    {
        ExpectRefusal(RunCommand({verb, Path("a.shader")}),
                      {{Path("a.shader") + ":", "'" + verb + "'", "a shader",
                        "'limn shader " + Path("a.shader") + "'"}},
                      1);
    }
}

TEST_F(BadInput, ASceneIsNothingToCompile)
{
    const std::string scene = folder.Write("s.scene.yaml", k_Camera).generic_string();
    ExpectRefusal(RunCommand({"shader", scene}),
                  {{scene + ":", "'shader'", "a scene", "'limn render " + scene + " -o out.png'"}},
                  1);
}

TEST_F(BadInput, ASceneIsNoProfile)
{
    const std::string scene = Path("s.scene.yaml");
    ExpectRefusal(
        Render(k_Camera, {"--profile", scene}),
        {{scene + ":", "'--profile'", "a scene", "'limn render " + scene + " -o out.png'"}}, 1);
}

TEST_F(BadInput, ASceneOfUnitysIsReadInItsProject)
{
    const std::string scene = folder.Write("Main.unity", "%YAML 1.1\n").generic_string();
    ExpectRefusal(RunCommand({"render", scene, "-o", Path("out.png")}),
                  {{scene + ":", ".unity", "project", "Assets folder"}}, 1);
    const std::string prefab = folder.Write("Box.prefab", "%YAML 1.1\n").generic_string();
    ExpectRefusal(RunCommand({"render", prefab, "-o", Path("out.png")}),
                  {{prefab + ":", "'render'", "Unity prefab", ".unity"}}, 2);
    ExpectRefusal(RunCommand({"render", folder.path().string(), "-o", Path("out.png")}),
                  {{folder.path().string() + ":", "no Unity project", "Assets"}}, 2);
}

TEST_F(BadInput, WhatIsNoFileOfLimnsIsToldAsSuch)
{
    folder.Write("README.md", "# A title: with a colon\n\n- a [list\n");
    folder.Write("notes", "");
    for (const char* name : {"README.md", "notes"})
    {
        const std::string file = Path(name);
        const auto expectNo = [&](const std::vector<std::string>& args, const std::string& kinds,
                                  const std::string& names)
        {
            ExpectRefusal(RunCommand(args),
                          {{file + ":", "'" + args[0] + "'", "no " + kinds, names}}, 2);
        };
        const std::string scene = "scene or Unity scene";
        const std::string names = "*.scene.yaml or *.unity";
        expectNo({"render", file, "-o", Path("out.png")}, scene, names);
        expectNo({"watch", file, "-o", Path("out.png")}, scene, names);
        expectNo({"explain", file}, scene, names);
        expectNo({"inspect", file}, "scene or volume profile or Unity scene",
                 "*.scene.yaml or *.profile.yaml or *.unity");
        expectNo({"set", file, "A.b=1"}, "scene or volume profile",
                 "*.scene.yaml or *.profile.yaml");
        expectNo({"shader", file}, "shader", "*.shader");
    }
    ExpectRefusal(Render(k_Camera, {"--profile", Path("notes")}),
                  {{Path("notes") + ":", "'--profile'", "no volume profile", "*.profile.yaml"}}, 3);
}

TEST_F(BadInput, ANameInAFileCannotForgeAMessage)
{
    folder.Write("w.profile.yaml", "\"x\\n/etc/passwd:1:1: error: \\e[31mhello\": {}\n");
    const AssetContext assets;
    std::string known;
    for (const std::string_view name : assets.volumeComponents().names())
    {
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    ExpectRefusal(RunCommand({"inspect", Path("w.profile.yaml")}),
                  {{Path("w.profile.yaml") + ":1:1:", "unknown volume component",
                    "'x\\n/etc/passwd:1:1: error: \\x1B[31mhello'", known}},
                  1);
}

TEST(Machine, WithoutAnyDriverEndsWith3AndSaysWhatToInstall)
{
    const TemporaryFolder folder;
    folder.Write("s.scene.yaml", k_Camera);
    const std::string prefix = "env -u VK_ICD_FILENAMES VK_DRIVER_FILES=/nowhere/driver.json '" +
                               test::LimnExecutable() + "' ";
    const std::string suffix =
        " > '" + (folder / "out").string() + "' 2> '" + (folder / "err").string() + "'";
    const int render =
        std::system((prefix + "render '" + (folder / "s.scene.yaml").string() +
                     "' --no-cache -o '" + (folder / "out.png").string() + "'" + suffix)
                        .c_str());
    EXPECT_EQ(3, WEXITSTATUS(render));
    EXPECT_THAT(LinesOf(ReadText(folder / "err")),
                testing::ElementsAre(Mentions("no Vulkan device", "VK_DRIVER_FILES",
                                              "'/nowhere/driver.json'", "mesa-vulkan-drivers")));
    EXPECT_EQ("", ReadText(folder / "out"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out.png"));

    const int doctor = std::system((prefix + "doctor" + suffix).c_str());
    EXPECT_EQ(3, WEXITSTATUS(doctor));
    EXPECT_THAT(ReadText(folder / "out"), HasSubstr("\nVulkan devices      0\n"));
}

} // namespace limn::test

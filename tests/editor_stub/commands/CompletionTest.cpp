#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"

#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A folder of WriteProject's with a profile of two components, a scene with a feature whose name
/// has blanks, and files of other kinds.
class Completion : public testing::Test
{
protected:
    Completion()
    {
        WriteProject(working.folder);
        working.folder.Write("two.profile.yaml", "Vignette: {intensity: 1}\n"
                                                 "StrokeOutline: {m_OutlineWidth: 4}\n");
        working.folder.Write("f.scene.yaml",
                             "camera: {}\n"
                             "renderer: {features: [{type: StrokeOutlineRendererFeature, "
                             "name: My Strokes}]}\n"
                             "objects:\n"
                             "  - {name: Sofa, mesh: cube}\n"
                             "  - {name: Big Lamp, mesh: cube}\n"
                             "  - {name: \"Lamp's shade\", mesh: cube}\n");
        working.folder.Write("notes.txt", "");
        std::filesystem::create_directories(working.folder / "sub/deeper");
    }

    /// Returns what `limn complete` prints, without its explanations.
    static std::string Complete(std::vector<std::string> words)
    {
        words.insert(words.begin(), {"complete", "--"});
        std::istringstream lines(RunCommand(words).out);
        std::string text;
        for (std::string line; std::getline(lines, line);)
        {
            text += (text.empty() ? "" : "|") + line.substr(0, line.find('\t'));
        }
        return text;
    }

    /// Returns what bash offers for a word.
    /// @param line  the words behind the program, as they are typed and as bash splits them
    /// @param last  the position of the word in the line, from 1
    static std::string InBash(const std::string& line, int last)
    {
        return RunInPipe("bash -c 'source <(\"$0\" completion bash); COMP_WORDS=(\"$0\" " + line +
                         "); COMP_CWORD=" + std::to_string(last) +
                         "; _limn; IFS=\"|\"; echo \"${COMPREPLY[*]}\"' '" + LimnExecutable() +
                         "' 2>&1");
    }

    WorkingFolder working;
};

} // namespace

TEST_F(Completion, OffersVerbsFlagsAndWords)
{
    EXPECT_EQ("render|report", Complete({"re"}));
    EXPECT_EQ("set|schema|shader", Complete({"s"}));
    EXPECT_EQ("--set|--select", Complete({"render", "--se"}));
    EXPECT_EQ("glsl|glsles", Complete({"shader", "--emit", "gl"}));
    EXPECT_EQ("--emit=glsl|--emit=glsles", Complete({"shader", "--emit=gl"}));
    EXPECT_EQ("always", Complete({"shader", "--color", "al"}));
    EXPECT_EQ("profile", Complete({"schema", "p"}));
    EXPECT_EQ("explain", Complete({"help", "ex"}));
    EXPECT_EQ("--version", Complete({"--vers"}));
    EXPECT_EQ("", Complete({"frobnicate", "x"}));
    EXPECT_THAT(RunCommand({"complete", "re"}).out,
                StartsWith("render\tDraw a scene into a PNG file\n"));
}

TEST_F(Completion, OffersFilesByTheirKind)
{
    EXPECT_EQ("f.scene.yaml|s.scene.yaml|sub/", Complete({"render", ""}));
    EXPECT_EQ("s.scene.yaml|sub/", Complete({"render", "s"}));
    EXPECT_EQ("sub/deeper/", Complete({"render", "sub/"}));
    EXPECT_EQ("p.profile.yaml", Complete({"render", "s.scene.yaml", "--profile", "p"}));
    EXPECT_EQ("p.profile.yaml", Complete({"set", "p"}));
    EXPECT_EQ("a.shader|b.shader|sub/", Complete({"shader", ""}));
    EXPECT_EQ("e.yaml", Complete({"check", "s.scene.yaml", "e"}));
    EXPECT_EQ("", Complete({"render", "s.scene.yaml", "-o", ""})) << "left to the shell";
    EXPECT_EQ("", Complete({"render", "~/"}));
    EXPECT_EQ("", Complete({"render", "no/such/folder"}));
    EXPECT_THAT(Complete({"inspect", "Stroke"}), HasSubstr("StrokeOutline"));
    EXPECT_THAT(Complete({"inspect", "Universal Render Pipeline/L"}),
                HasSubstr("Universal Render Pipeline/Lit"));
}

TEST_F(Completion, OffersComponentsOfTheProfileAndTheirParameters)
{
    EXPECT_EQ("Vignette.|StrokeOutline.", Complete({"set", "two.profile.yaml", ""}));
    EXPECT_EQ("StrokeOutline.m_OutlineColor=|StrokeOutline.m_OutlineWidth=",
              Complete({"set", "two.profile.yaml", "StrokeOutline.m_Outline"}));
    EXPECT_EQ("Bloom.", Complete({"set", "two.profile.yaml", "Bl"})) << "the file lacks it";
    EXPECT_THAT(Complete({"set", "two.profile.yaml", "Bloom.int"}), HasSubstr("Bloom.intensity="));
    EXPECT_EQ("StrokeOutline.m_Enable=",
              Complete({"set", "two.profile.yaml", "Vignette.intensity=1", "StrokeOutline.m_E"}));
    EXPECT_EQ("", Complete({"set", "two.profile.yaml", "StrokeOutline.m_OutlineWidth="}));
    EXPECT_EQ("Bloom.", Complete({"set", "no.profile.yaml", "Bl"}));
}

TEST_F(Completion, OffersFeaturesOfTheSceneAndTheirSettings)
{
    EXPECT_THAT(Complete({"render", "f.scene.yaml", "--set", "My"}), "My Strokes.");
    EXPECT_THAT(Complete({"explain", "f.scene.yaml", "--set", "My Strokes.m_Occ"}),
                "My Strokes.m_Occlusion=");
    EXPECT_THAT(Complete({"set", "f.scene.yaml", "StrokeOutlineR"}),
                "StrokeOutlineRendererFeature.");
    EXPECT_THAT(Complete({"render", "s.scene.yaml", "--set", "ScreenSpaceOutline.m_OutlineW"}),
                "ScreenSpaceOutline.m_OutlineWidth=");
}

TEST_F(Completion, OffersObjectsAndTechniques)
{
    EXPECT_EQ("Big Lamp|Lamp's shade|Sofa", Complete({"explain", "f.scene.yaml", "--object", ""}));
    EXPECT_EQ("Sofa", Complete({"explain", "f.scene.yaml", "--object", "S"}));
    EXPECT_EQ("Big Lamp", Complete({"render", "f.scene.yaml", "--select", "B"}));
    EXPECT_EQ("", Complete({"explain", "no.scene.yaml", "--object", ""}));
    EXPECT_THAT("|" + Complete({"report", "f.scene.yaml", "--technique", "S"}) + "|",
                testing::AllOf(HasSubstr("|Strokes|"), HasSubstr("|Screen space|")));
}

TEST_F(Completion, HasNothingToSayAboutMistakes)
{
    working.folder.Write("bad.scene.yaml", "camera: [}\n");
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"set", "no.profile.yaml", "--frob", ""},
          {"explain", "bad.scene.yaml", "--object", ""},
          {"set", "bad.scene.yaml", "x"},
          {"report", "s.scene.yaml", "--plugin", "no.so", "--technique", ""},
          {"render", "--size", "x", "--set", ""},
          {"--"},
          {"\xff\xfe"}})
    {
        std::vector<std::string> args{"complete", "--"};
        args.insert(args.end(), words.begin(), words.end());
        const CommandRun run = RunCommand(args);
        EXPECT_EQ(0, run.exitCode) << testing::PrintToString(words);
        EXPECT_EQ("", run.err);
    }
}

TEST_F(Completion, WorksInBash)
{
    EXPECT_EQ("render|report\n", InBash("re", 1));
    EXPECT_EQ("f.scene.yaml|s.scene.yaml|sub/\n", InBash("render \"\"", 2));
    EXPECT_EQ("StrokeOutline.m_OutlineWidth=\n",
              InBash("set two.profile.yaml StrokeOutline.m_OutlineW", 3));
    EXPECT_EQ("Big\\ Lamp\n", InBash("explain f.scene.yaml --object B", 4));
    EXPECT_EQ("Big\\ Lamp\n", InBash("explain f.scene.yaml --object \"Big\\ L\"", 4));
    EXPECT_EQ("Big Lamp\n", InBash("explain f.scene.yaml --object \"\\\"Big L\"", 4));
    EXPECT_EQ("glsl|glsles\n", InBash("shader --emit = gl", 4)) << "bash splits --emit=gl";
    EXPECT_EQ("spirv|glsl|glsles|msl|hlsl\n", InBash("shader --emit =", 3));
    EXPECT_EQ("\n", InBash("render s.scene.yaml -o x", 4)) << "left to the names of files";
}

TEST_F(Completion, HasScriptsOfThreeShells)
{
    EXPECT_THAT(RunCommand({"completion", "bash"}).out,
                HasSubstr("\ncomplete -o default -F _limn limn\n"));
    EXPECT_THAT(RunCommand({"completion", "zsh"}).out, StartsWith("#compdef limn\n"));
    EXPECT_THAT(RunCommand({"completion", "fish"}).out, HasSubstr("\ncomplete -c limn -f -a "));
}

TEST_F(Completion, WorksInFish)
{
    if (RunInPipe("command -v fish").empty())
    {
        GTEST_SKIP() << "fish is not installed";
    }
    const auto complete = [](const std::string& line)
    {
        return RunInPipe("PATH=\"$(dirname '" + LimnExecutable() +
                         "'):$PATH\" fish -c 'limn completion fish | source; complete -C \"" +
                         line + "\"' 2>&1 | cut -f 1");
    };
    EXPECT_EQ("render\nreport\n", complete("limn re"));
    EXPECT_EQ("Sofa\n", complete("limn explain f.scene.yaml --object S"));
    EXPECT_EQ("Bloom.\n", complete("limn set two.profile.yaml Bl"));
    EXPECT_THAT(complete("limn render s.scene.yaml -o n"), HasSubstr("notes.txt"));
}

} // namespace limn::test

#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <sstream>

namespace limn::test
{

namespace
{

const std::string k_Red = "\033[31merror\033[0m";

/// Returns what `limn rendr` prints where no terminal is, behind its "error".
std::string Rest()
{
    return RunCommand({"rendr"}).err.substr(5);
}

} // namespace

TEST(ATerminal, HasHelpWrappedToItsWidth)
{
    EXPECT_EQ("Change values of a volume profile, or of the features of a\n"
              "scene or a Unity renderer, in place; no other character\n"
              "changes\n"
              "\n"
              "usage: limn set FILE NAME.path=VALUE ... [OPTIONS]\n"
              "\n"
              "arguments:\n"
              "  FILE\n"
              "        A *.profile.yaml, a *.scene.yaml, or a Unity\n"
              "        VolumeProfile or renderer .asset\n"
              "  NAME.path=VALUE ...\n"
              "        For example ScreenSpaceOutline.m_OutlineWidth=4;\n"
              "        m_OutlineColor.r=1 changes one number, and += -= *=\n"
              "        start from the one that there is\n"
              "\n"
              "options:\n"
              "      --undo\n"
              "        Bring back the text from before the last change by\n"
              "        'limn set'; once more brings the change again\n"
              "      --json\n"
              "        Print the changes as JSON\n"
              "      --plugin FILE.so ...\n"
              "        Load features, volume components and shaders from a\n"
              "        module, whose code runs\n"
              "\n"
              "options of every verb:\n"
              "  -V, --version\n"
              "        Print the version\n"
              "  -h, --help\n"
              "        Print this help\n"
              "  -q, --quiet\n"
              "        Print errors only, besides results\n"
              "  -v, --verbose\n"
              "        Print more: the device that draws, all that\n"
              "        `explain` knows\n"
              "      --color auto|always|never\n"
              "        Colours on stderr; 'auto': on a terminal, unless\n"
              "        NO_COLOR is set\n"
              "      --no-pager\n"
              "        Print long results at once; by itself LIMN_PAGER,\n"
              "        PAGER or `less` shows them on a terminal\n",
              Terminal(60).Run({"help", "set"}));
}

TEST(ATerminal, ShowsErrorsInColour)
{
    EXPECT_EQ(k_Red + Rest(), Terminal(80).Run({"rendr"}));
}

TEST(ATerminal, ShowsNoColourToWhomeverWantsNone)
{
    EXPECT_EQ("error" + Rest(), Terminal(80).With("NO_COLOR", "1").Run({"rendr"}));
    EXPECT_EQ("error" + Rest(), Terminal(80).With("TERM", "dumb").Run({"rendr"}));
    EXPECT_EQ(k_Red + Rest(), Terminal(80).With("NO_COLOR", "").Run({"rendr"}));
    EXPECT_EQ("set: error: there is no such file\n",
              Terminal(80).Run({"explain", "set", "--color", "never"}));
    EXPECT_EQ("set: " + k_Red + ": there is no such file\n",
              Terminal(80).With("NO_COLOR", "1").Run({"explain", "set", "--color", "always"}));
}

TEST(ATerminal, IsNotCommandedByNamesInFiles)
{
    const TemporaryFolder folder;
    const std::string file =
        folder.Write("s.scene.yaml", "camera: {}\n\"\\e[2J\\a\": 1\n").generic_string();
    const std::string text = Terminal(200).Run({"inspect", file, "--color", "never"});
    EXPECT_THAT(text, testing::StartsWith(
                          file + ":2:1: error: scene: unknown key '\\x1B[2J\\x07' (known: size, "));
    EXPECT_EQ(std::string::npos, text.find('\033'));
}

TEST(ATerminal, IsNotCommandedByAShaderThatIsPrinted)
{
    const TemporaryFolder folder;
    const std::string file =
        folder.Write("a.shader", "Shader \"\x1B[2J\" { SubShader { Pass { } } }").string();
    EXPECT_THAT(Terminal(80).Run({"shader", "--print", file}),
                testing::StartsWith("Shader \"\\x1B[2J\"\n"));
    EXPECT_THAT(RunInPipe("'" + LimnExecutable() + "' shader --print '" + file + "'"),
                testing::StartsWith("Shader \"\x1B[2J\"\n"))
        << "a file stays what it is";
}

TEST(ATerminal, ShowsTheLineOfAFileThatIsWrong)
{
    const TemporaryFolder folder;
    const std::string file =
        folder.Write("a.profile.yaml", "Bloom:\n  intensty: 1 # glow\n").generic_string();
    const std::vector<std::string> words{"inspect", file, "--color", "never"};
    EXPECT_THAT(Terminal(200).Run(words), testing::EndsWith("\n  intensty: 1 # glow\n  ^\n"));
    EXPECT_THAT(RunCommand(words).err, testing::EndsWith("did you mean 'intensity'?\n"));
}

TEST(ATerminal, HasTheMessageOfAWrongFileInItsWidthAndTheLineOfTheFileWhole)
{
    const TemporaryFolder folder;
    const std::string line = "  intensty: 1 # " + std::string(60, 'x') + " " + std::string(40, 'y');
    const std::string file = folder.Write("a.profile.yaml", "Bloom:\n" + line + "\n").string();
    const std::string text = Terminal(40).Run({"inspect", file, "--color", "never"});
    EXPECT_THAT(text, testing::HasSubstr("\n  'intensty'; did you mean 'intensity'?\n"));
    EXPECT_THAT(text, testing::EndsWith("\n" + line + "\n  ^\n"));
}

TEST(ATerminal, HasProgressInOneLine)
{
    const TemporaryFolder folder;
    const std::string file =
        folder.Write("with_a_name_that_is_long.shader", "Shader \"A\" { SubShader { Pass { } } }")
            .string();
    const std::string clear = "\033[K";
    const std::string text = Terminal(30).Run({"shader", file});
    ASSERT_THAT(text, testing::StartsWith(clear));
    const std::string line = text.substr(clear.size(), text.find(clear, 1) - clear.size());
    EXPECT_EQ("1 of 1: " + file.substr(0, 20) + "…", line) << "29 columns: it can be replaced";
}

TEST(ATerminal, IsAsWideAsThePersonSays)
{
    EXPECT_THAT(Terminal(200).With("COLUMNS", "20").Run({"rendr"}),
                testing::HasSubstr(": unknown verb\n  'rendr'; did you\n  mean 'render'?\n"));
    EXPECT_EQ(k_Red + Rest(), Terminal(200).With("COLUMNS", "wide").Run({"rendr"}));
    EXPECT_EQ(k_Red + Rest(), Terminal(0).Run({"rendr"})) << "80 where it does not tell";
}

TEST(APipe, HasPlainTextEightyColumnsWide)
{
    const std::string limn = "'" + LimnExecutable() + "' ";
    EXPECT_EQ("error" + Rest(), RunInPipe(limn + "rendr 2>&1"));
    EXPECT_EQ(RunCommand({"help", "shader"}).out, RunInPipe(limn + "help shader"));
    EXPECT_EQ("set: " + k_Red + ": there is no such file\n",
              RunInPipe(limn + "--color always explain set 2>&1"));
}

TEST(ManPage, HasEveryVerbWithItsFlags)
{
    const std::string page = RunCommand({"help", "--man"}).out;
    EXPECT_THAT(page, testing::StartsWith(".TH LIMN 1 "));
    EXPECT_THAT(page, testing::HasSubstr("\n.SH NAME\nlimn \\- "));
    for (const char* verb :
         {"render", "watch", "inspect", "explain", "report", "set", "schema", "shader", "new",
          "port", "doctor", "completion", "complete", "help", "version"})
    {
        EXPECT_THAT(page, testing::HasSubstr("\n.SS limn " + std::string(verb) + " "));
    }
    EXPECT_THAT(page, testing::HasSubstr("\n.TP\n.B \\-o, \\-\\-output FILE\nThe PNG file to "
                                         "write; \\- is stdout\n"));
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);)
    {
        EXPECT_FALSE(line.starts_with('\'')) << "a request to troff: " << line;
        EXPECT_TRUE(!line.starts_with('.') || line.starts_with(".TH ") ||
                    line.starts_with(".SH ") || line.starts_with(".SS ") || line == ".TP" ||
                    line.starts_with(".B "))
            << line;
    }
}

} // namespace limn::test

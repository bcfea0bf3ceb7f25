#include "commands/CommandRun.h"

#include <gmock/gmock.h>
#include <sstream>

namespace limn::test
{

namespace
{

const std::string k_Red = "\033[31merror\033[0m";
const std::string k_Rest = ": unknown verb 'rendr'; did you mean 'render'?\n"
                           "usage: limn VERB [OPTIONS]; see 'limn help'\n";

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
              "        NO_COLOR is set\n",
              Terminal(60).Run({"help", "set"}));
}

TEST(ATerminal, ShowsErrorsInColour)
{
    EXPECT_EQ(k_Red + k_Rest, Terminal(80).Run({"rendr"}));
}

TEST(ATerminal, ShowsNoColourToWhomeverWantsNone)
{
    EXPECT_EQ("error" + k_Rest, Terminal(80).With("NO_COLOR", "1").Run({"rendr"}));
    EXPECT_EQ("error" + k_Rest, Terminal(80).With("TERM", "dumb").Run({"rendr"}));
    EXPECT_EQ(k_Red + k_Rest, Terminal(80).With("NO_COLOR", "").Run({"rendr"}));
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

TEST(APipe, HasPlainTextEightyColumnsWide)
{
    const std::string limn = "'" + LimnExecutable() + "' ";
    EXPECT_EQ("error" + k_Rest, RunInPipe(limn + "rendr 2>&1"));
    EXPECT_EQ(RunCommand({"help", "shader"}).out, RunInPipe(limn + "help shader"));
    EXPECT_EQ("set: " + k_Red + ": there is no such file\n",
              RunInPipe(limn + "--color always explain set 2>&1"));
}

TEST(Completion, GivesBashVerbsOptionsAndValues)
{
    const auto complete = [](const std::string& words, int word)
    {
        return RunInPipe("bash -c 'source <(\"$0\" completion bash); COMP_WORDS=(" + words +
                         "); COMP_CWORD=" + std::to_string(word) +
                         "; _limn; echo ${COMPREPLY[@]}' '" + LimnExecutable() + "' 2>&1");
    };
    EXPECT_EQ("render report\n", complete("limn re", 1));
    EXPECT_EQ("set schema shader\n", complete("limn s", 1));
    EXPECT_EQ("--scene --size --set --select --stats\n", complete("limn render --s", 2));
    EXPECT_EQ("glsl glsles\n", complete("limn shader --emit gl", 3));
    EXPECT_EQ("always\n", complete("limn shader --color al", 3));
    EXPECT_EQ("profile\n", complete("limn schema p", 2));
    EXPECT_EQ("explain\n", complete("limn help ex", 2));
    EXPECT_EQ("\n", complete("limn render s.scene", 2)) << "left to the names of files";
}

TEST(ManPage, HasEveryVerbWithItsFlags)
{
    const std::string page = RunCommand({"help", "--man"}).out;
    EXPECT_THAT(page, testing::StartsWith(".TH LIMN 1 "));
    EXPECT_THAT(page, testing::HasSubstr("\n.SH NAME\nlimn \\- "));
    for (const char* verb : {"render", "watch", "inspect", "explain", "report", "set", "schema",
                             "shader", "new", "port", "doctor", "completion", "help", "version"})
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

TEST(Completion, GivesZshAndFishEveryVerbAndOption)
{
    const std::string zsh = RunCommand({"completion", "zsh"}).out;
    EXPECT_THAT(zsh, testing::StartsWith("#compdef limn\n"));
    EXPECT_THAT(zsh, testing::HasSubstr("        'render:Draw a scene into a PNG file'\n"));
    EXPECT_THAT(zsh, testing::HasSubstr("'*--json[Print JSON]'"));
    EXPECT_THAT(zsh, testing::HasSubstr("'*:word:(scene profile material)'"));
    const std::string fish = RunCommand({"completion", "fish"}).out;
    EXPECT_THAT(fish,
                testing::HasSubstr("complete -c limn -n __fish_use_subcommand -f -a render -d "
                                   "'Draw a scene into a PNG file'\n"));
    EXPECT_THAT(fish,
                testing::HasSubstr("complete -c limn -n '__fish_seen_subcommand_from inspect' "
                                   "-l json -d 'Print JSON'\n"));
    EXPECT_THAT(fish, testing::HasSubstr("-l color -r -f -a 'auto always never' -d "));
}

} // namespace limn::test

#include "Paths.h"
#include "commands/CommandRun.h"

#include <cstdio>
#include <gmock/gmock.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn::test
{

namespace
{

/// All that `limn`, a process of its own, writes to a terminal, in lines that end with '\n'.
class Terminal
{
public:
    explicit Terminal(unsigned short columns) : m_Columns(columns) {}

    Terminal With(const std::string& variable, const std::string& value) const
    {
        Terminal changed = *this;
        changed.m_Variables.emplace_back(variable, value);
        return changed;
    }

    std::string Run(std::vector<std::string> args) const
    {
        args.insert(args.begin(), "limn");
        std::vector<char*> words;
        for (std::string& arg : args)
        {
            words.push_back(arg.data());
        }
        words.push_back(nullptr);
        const std::string program = LimnExecutable();
        winsize size{24, m_Columns, 0, 0};
        int terminal = -1;
        const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
        if (child == 0)
        {
            setenv("TERM", "xterm", 1);
            unsetenv("NO_COLOR");
            for (const auto& [name, value] : m_Variables)
            {
                setenv(name.c_str(), value.c_str(), 1);
            }
            execv(program.c_str(), words.data());
            _exit(127);
        }
        std::string text;
        char bytes[4096];
        for (ssize_t count = read(terminal, bytes, sizeof(bytes)); count > 0;
             count = read(terminal, bytes, sizeof(bytes)))
        {
            text.append(bytes, static_cast<std::size_t>(count));
        }
        waitpid(child, nullptr, 0);
        close(terminal);
        std::erase(text, '\r'); // a terminal's line ends with both
        return text;
    }

private:
    unsigned short m_Columns;
    std::vector<std::pair<std::string, std::string>> m_Variables;
};

/// What a shell command writes to a pipe.
std::string RunInPipe(const std::string& command)
{
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    char bytes[4096];
    for (std::size_t count = fread(bytes, 1, sizeof(bytes), pipe); count > 0;
         count = fread(bytes, 1, sizeof(bytes), pipe))
    {
        text.append(bytes, count);
    }
    pclose(pipe);
    return text;
}

const std::string k_Red = "\033[31merror\033[0m";
const std::string k_Rest = ": unknown verb 'rendr'; did you mean 'render'?\n"
                           "usage: limn VERB [OPTIONS]; see 'limn help'\n";

} // namespace

TEST(ATerminal, HasHelpWrappedToItsWidth)
{
    EXPECT_EQ("Change values of a volume profile in place, and not a\n"
              "character besides\n"
              "\n"
              "usage: limn set FILE Component.param=VALUE ... [OPTIONS]\n"
              "\n"
              "arguments:\n"
              "  FILE\n"
              "        A *.profile.yaml or a Unity VolumeProfile .asset\n"
              "  Component.param=VALUE ...\n"
              "        Such as ScreenSpaceOutline.m_OutlineWidth=4\n"
              "\n"
              "options of every verb:\n"
              "  -V, --version\n"
              "        Print the version\n"
              "  -h, --help\n"
              "        Print this\n"
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

TEST(ATerminal, HasNoLineOfHelpThatIsWider)
{
    for (const char* verb : {"render", "watch", "shader", "explain"})
    {
        std::istringstream help(Terminal(60).Run({"help", verb}));
        for (std::string line; std::getline(help, line);)
        {
            EXPECT_LE(line.size(), 60u) << line;
        }
        EXPECT_GT(RunCommand({"help", verb}).out.size(), 500u);
    }
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
              Terminal(80).Run({"inspect", "set", "--color", "never"}));
    EXPECT_EQ("set: " + k_Red + ": there is no such file\n",
              Terminal(80).With("NO_COLOR", "1").Run({"inspect", "set", "--color", "always"}));
}

TEST(ATerminal, IsSentNoPicture)
{
    EXPECT_EQ(k_Red + ": -o -: stdout is a terminal, which shows no PNG; lead it elsewhere: "
                      "'limn render SCENE -o - > out.png'\n",
              Terminal(80).Run({"render", "s.scene.yaml", "-o", "-"}));
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

TEST(APipe, HasPlainTextEightyColumnsWide)
{
    const std::string limn = "'" + LimnExecutable() + "' ";
    EXPECT_EQ("error" + k_Rest, RunInPipe(limn + "rendr 2>&1"));
    EXPECT_EQ(RunCommand({"help", "shader"}).out, RunInPipe(limn + "help shader"));
    EXPECT_EQ("set: " + k_Red + ": there is no such file\n",
              RunInPipe(limn + "--color always inspect set 2>&1"));
}

TEST(Completion, GivesBashVerbsOptionsAndValues)
{
    const auto complete = [](const std::string& words, int word)
    {
        return RunInPipe("bash -c 'source <(\"$0\" completion bash); COMP_WORDS=(" + words +
                         "); COMP_CWORD=" + std::to_string(word) +
                         "; _limn; echo ${COMPREPLY[@]}' '" + LimnExecutable() + "' 2>&1");
    };
    EXPECT_EQ("render\n", complete("limn re", 1));
    EXPECT_EQ("set schema shader\n", complete("limn s", 1));
    EXPECT_EQ("--size --set --stats\n", complete("limn render --s", 2));
    EXPECT_EQ("glsl glsles\n", complete("limn shader --emit gl", 3));
    EXPECT_EQ("always\n", complete("limn shader --color al", 3));
    EXPECT_EQ("profile\n", complete("limn schema p", 2));
    EXPECT_EQ("explain\n", complete("limn help ex", 2));
    EXPECT_EQ("\n", complete("limn render s.scene", 2)) << "left to the names of files";
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

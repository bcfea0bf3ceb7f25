#include "Mentions.h"
#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"

#include <gmock/gmock.h>
#include <limn/core/DrawError.h>
#include <new>

namespace limn::test
{

namespace
{

using testing::HasSubstr;
using Arguments = std::vector<std::string>;

/// The usage line, which follows every complaint about the arguments, has these parts.
const Arguments k_LimnUsage{"usage: limn VERB", "'limn help'"};
const Arguments k_RenderUsage{"usage: limn render SCENE -o FILE", "'limn help render'"};
const Arguments k_ExplainUsage{"usage: limn explain SCENE", "'limn help explain'"};
const Arguments k_ShaderUsage{"usage: limn shader FILE|DIR ...", "'limn help shader'"};

/// `limn` ends with 2, an error on stderr that mentions these parts, then its usage, and nothing on
/// stdout.
void ExpectWrongUsage(const Arguments& args, const Arguments& usage, Arguments parts)
{
    parts.insert(parts.begin(), "error:");
    const CommandRun run = RunCommand(args);
    EXPECT_EQ(2, run.exitCode) << run.err;
    EXPECT_THAT(LinesOf(run.err),
                testing::ElementsAre(MentionsInOrder(parts), MentionsInOrder(usage)));
    EXPECT_EQ("", run.out);
}

/// render s -o o and these.
Arguments Render(const Arguments& more)
{
    Arguments args{"render", "s", "-o", "o"};
    args.insert(args.end(), more.begin(), more.end());
    return args;
}

/// Throws as soon as something is written to it.
template <typename Error>
class ThrowingBuffer : public std::streambuf
{
public:
    explicit ThrowingBuffer(Error error) : m_Error(std::move(error)) {}

protected:
    int_type overflow(int_type) override { throw m_Error; }
    std::streamsize xsputn(const char*, std::streamsize) override { throw m_Error; }

private:
    Error m_Error;
};

/// A run of a verb in which this happens.
template <typename Error>
CommandRun RunInto(Error error)
{
    ThrowingBuffer<Error> buffer(std::move(error));
    std::ostream out(&buffer);
    out.exceptions(std::ios::badbit);
    std::ostringstream err;
    const Arguments args{"version"};
    const int exitCode = RunLimn(args, out, err);
    return {exitCode, "", err.str()};
}

} // namespace

TEST(Usage, VersionGoesToStdout)
{
    const CommandRun run = RunCommand({"--version"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_THAT(run.out, testing::MatchesRegex("limn [0-9.]+\n"));
    EXPECT_EQ("", run.err);
    EXPECT_EQ(run.out, RunCommand({"version"}).out);
    EXPECT_EQ(run.out, RunCommand({"-V"}).out);
}

TEST(Usage, HelpNamesEveryVerbAndTheExitCodes)
{
    const CommandRun run = RunCommand({"help"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_EQ("", run.err);
    for (const char* verb : {"render", "watch", "inspect", "explain", "check", "set", "schema",
                             "shader", "new", "port", "doctor", "completion", "help", "version"})
    {
        EXPECT_THAT(run.out, HasSubstr("\n  " + std::string(verb) + " "));
    }
    EXPECT_THAT(run.out,
                testing::EndsWith(
                    "\nResults go to stdout, everything else to stderr. Exit codes: 0 done, 1 the "
                    "input\nis bad, 2 wrong usage, 3 the machine lacks something, 70 a bug in "
                    "limn.\n"));
    EXPECT_EQ(run.out, RunCommand({"--help"}).out);
    EXPECT_EQ(run.out, RunCommand({"-h"}).out);
    EXPECT_EQ(run.out, RunCommand({}).out) << "bare limn";
    EXPECT_EQ(0, RunCommand({}).exitCode);
}

TEST(Usage, HelpOfAVerbTellsItsArgumentsAndOptions)
{
    const CommandRun run = RunCommand({"help", "schema"});
    EXPECT_EQ(0, run.exitCode);
    EXPECT_EQ("Print a JSON Schema, from which an editor completes keys and shows ranges\n"
              "\n"
              "usage: limn schema scene|profile|material [OPTIONS]\n"
              "\n"
              "arguments:\n"
              "  scene|profile|material    The kind of file: scene, profile or material\n"
              "\n"
              "options:\n"
              "      --plugin FILE.so ...  Load features, volume components and shaders from a\n"
              "                            module, whose code runs\n"
              "\n"
              "options of every verb:\n"
              "  -V, --version             Print the version\n"
              "  -h, --help                Print this help\n"
              "  -q, --quiet               Print errors only, besides results\n"
              "  -v, --verbose             Print more: the device that draws, all that\n"
              "                            `explain` knows\n"
              "      --color auto|always|never\n"
              "                            Colours on stderr; 'auto': on a terminal, unless\n"
              "                            NO_COLOR is set\n"
              "      --no-pager            Print long results at once; by itself LIMN_PAGER,\n"
              "                            PAGER or `less` shows them on a terminal\n",
              run.out);
    EXPECT_EQ(run.out, RunCommand({"schema", "--help"}).out);
}

TEST(Usage, AWrongOptionIsNamedWithTheNearest)
{
    ExpectWrongUsage({"--frob"}, k_LimnUsage, {"unknown option", "'--frob'"});
    ExpectWrongUsage({"--versoin"}, k_LimnUsage, {"unknown option", "'--versoin'", "'--version'"});
    ExpectWrongUsage(Render({"--sise", "3x3"}), k_RenderUsage,
                     {"unknown option", "'--sise'", "'--size'"});
    ExpectWrongUsage({"render", "--frob=1"}, k_RenderUsage, {"unknown option", "'--frob'"});
    ExpectWrongUsage(Render({"--verbos"}), k_RenderUsage,
                     {"unknown option", "'--verbos'", "'--verbose'"});
    ExpectWrongUsage(Render({"--" + std::string(100, 'x') + "\n\x1B[2J"}), k_RenderUsage,
                     {"unknown option",
                      "'--" + std::string(46, 'x') + "…" + std::string(11, 'x') + "\\n\\x1B[2J'"});
}

TEST(Usage, AWrongVerbIsNamedWithTheNearest)
{
    const std::string verbs = "render, watch, inspect, explain, check, report, set, schema, "
                              "shader, new, port, doctor, completion, complete, help, version";
    ExpectWrongUsage({"rendr", "s"}, k_LimnUsage, {"unknown verb", "'rendr'", "'render'"});
    ExpectWrongUsage({"-v", "frobnicate"}, k_LimnUsage, {"unknown verb", "'frobnicate'", verbs});
    ExpectWrongUsage({"no.scene.yaml"}, k_LimnUsage, {"unknown verb", "'no.scene.yaml'", verbs});
    ExpectWrongUsage({"help", "rendr"}, {"usage: limn help [VERB]", "'limn help help'"},
                     {"unknown verb", "'rendr'", "'render'"});
    ExpectWrongUsage({"-v"}, k_LimnUsage, {"a verb", "missing"});
}

TEST(Usage, AFileInThePlaceOfTheVerbIsOfferedTheVerbThatTakesIt)
{
    const WorkingFolder working;
    WriteProject(working.folder);
    ExpectWrongUsage({"s.scene.yaml"}, k_LimnUsage,
                     {"'s.scene.yaml'", "a scene", "'limn render s.scene.yaml -o out.png'"});
    ExpectWrongUsage({"a.shader", "-v"}, k_LimnUsage,
                     {"'a.shader'", "a shader", "'limn shader a.shader'"});
}

TEST(Usage, WhatIsMissingOrTooMuchIsNamed)
{
    ExpectWrongUsage({"render"}, k_RenderUsage, {"SCENE and -o FILE", "missing"});
    ExpectWrongUsage({"render", "s"}, k_RenderUsage, {"-o FILE is", "missing"});
    ExpectWrongUsage({"shader"}, k_ShaderUsage, {"FILE|DIR", "missing"});
    ExpectWrongUsage(Render({"t"}), k_RenderUsage, {"unexpected argument", "'t'"});
    ExpectWrongUsage(Render({"--size"}), k_RenderUsage, {"--size", "needs a value", "WxH"});
    ExpectWrongUsage({"render", "s", "-o", "--validate"}, k_RenderUsage,
                     {"--output", "needs a value", "FILE", "'--validate'", "an option"});
    ExpectWrongUsage(Render({"--size", "1x1", "--size", "2x2"}), k_RenderUsage,
                     {"--size", "2 times", "one value"});
    ExpectWrongUsage(Render({"--validate=yes"}), k_RenderUsage, {"--validate", "no value"});
}

TEST(Usage, OptionsThatDoNotGoTogetherAreNamed)
{
    ExpectWrongUsage({"shader", "s", "--emit", "glsl"}, k_ShaderUsage, {"--emit needs --output"});
    ExpectWrongUsage({"shader", "s", "--emit", "glsl", "-o", "o", "--variants"}, k_ShaderUsage,
                     {"--emit and --variants", "exclude"});
    ExpectWrongUsage(Render({"-q", "-v"}), k_RenderUsage, {"--quiet and --verbose", "exclude"});
    ExpectWrongUsage({"explain", "s", "--pixel", "1,1", "--object", "A"}, k_ExplainUsage,
                     {"--object and --pixel", "exclude"});
    ExpectWrongUsage({"explain", "s", "--pixel", "1,1", "--graph", "a.svg"}, k_ExplainUsage,
                     {"--pixel and --graph", "exclude"});
}

TEST(Usage, FlagsAreWrittenAsGnuHasThem)
{
    for (const Arguments& args : {Arguments{"render", "no", "-o", "o"},
                                  {"render", "no", "-oo"},
                                  {"render", "no", "--output", "o"},
                                  {"render", "no", "--output=o"},
                                  {"render", "-qo", "o", "--quiet", "no"},
                                  {"-q", "render", "-qoo", "no"},
                                  {"render", "--output=o", "--select=", "--", "no"},
                                  {"render", "-o", "o", "--stats", "--", "no"}})
    {
        const CommandRun run = RunCommand(args);
        EXPECT_EQ(1, run.exitCode) << testing::PrintToString(args);
        EXPECT_EQ("no: error: there is no such file\n", run.err);
    }
    EXPECT_THAT(RunCommand({"inspect", "--", "--json"}).err,
                testing::StartsWith("--json: error: there is no such file"));
    ExpectWrongUsage(Render({"-qv"}), k_RenderUsage, {"--quiet and --verbose", "exclude"});
    ExpectWrongUsage(Render({"-qz"}), k_RenderUsage, {"unknown option", "'-z'"});
    ExpectWrongUsage({"shader", "-qj0", "s"}, k_ShaderUsage, {"--jobs:", "'0'", "1 to 256"});
}

TEST(Usage, HelpIsGivenWhateverElseIsWrong)
{
    const std::string help = RunCommand({"help", "render"}).out;
    EXPECT_EQ(help, RunCommand({"-h", "render"}).out);
    EXPECT_EQ(help, RunCommand({"render", "--frob", "--size", "x", "-qh"}).out);
    ExpectWrongUsage({"render", "--help=1"}, k_RenderUsage, {"--help", "no value"});
}

TEST(Usage, APixelIsTwoWholeNumbers)
{
    for (const char* text : {"", "3", "3,", ",3", "3,4,5", "3x4", "a,b", "1.5,2", "3,4@1", "3, 4"})
    {
        ExpectWrongUsage({"explain", "s", "--pixel", text}, k_ExplainUsage,
                         {"--pixel:", "'" + std::string(text) + "'", "no pixel", "X,Y"});
    }
}

TEST(Usage, AValueThatCannotBeIsNamedWithWhatCan)
{
    const std::pair<Arguments, Arguments> cases[] = {
        {{"--size", "3"}, {"--size:", "'3'", "WxH", "1...16384"}},
        {{"--size", "0x4"}, {"--size:", "'0x4'", "WxH", "1...16384"}},
        {{"--time", "nan"}, {"--time:", "'nan'", "seconds"}},
        {{"--frames", "0"}, {"--frames:", "'0'", "1 to 100000"}},
        {{"--frames", "3x"}, {"--frames:", "'3x'", "1 to 100000"}},
        {{"--package", "core"}, {"--package:", "'core'", "package.json", "NAME=DIR"}},
        {{"--set", "foo"},
         {"--set:", "'foo'", "NAME.path=value", "ScreenSpaceOutline.m_OutlineWidth=4"}},
        {{"--color", "alway"}, {"--color:", "unknown word", "'alway'", "'always'"}},
    };
    for (const auto& [more, parts] : cases)
    {
        ExpectWrongUsage(Render(more), k_RenderUsage, parts);
    }
    ExpectWrongUsage({"shader", "s", "-o", "o", "--emit", "gls"}, k_ShaderUsage,
                     {"--emit:", "unknown word", "'gls'", "'glsl'"});
    ExpectWrongUsage({"render", "s", "-o", ""}, k_RenderUsage, {"--output:", "''", "no name"});
    ExpectWrongUsage({"schema", "shader"},
                     {"usage: limn schema scene|profile|material", "'limn help schema'"},
                     {"unknown word", "'shader'", "scene, profile, material"});
    ExpectWrongUsage({"set", "f", "foo"},
                     {"usage: limn set FILE NAME.path=VALUE ...", "'limn help set'"},
                     {"'foo'", "NAME.path=value", "ScreenSpaceOutline.m_OutlineWidth=4"});
}

TEST(Usage, APictureIsAPngByItsName)
{
    ExpectWrongUsage({"render", "s", "-o", "x.jpg"}, k_RenderUsage,
                     {"--output:", "'x.jpg'", "PNG only", "stdout"});
    ExpectWrongUsage({"watch", "s", "-o", "-"},
                     {"usage: limn watch SCENE -o FILE", "'limn help watch'"},
                     {"--output:", "stdout", "one picture"});
    for (const char* name : {"x.PNG", "/dev/null", "-", "folder.d/x"})
    {
        EXPECT_EQ(1, RunCommand({"render", "nosuch.scene.yaml", "-o", name}).exitCode) << name;
    }
}

TEST(Usage, AFileMayHaveAVerbsName)
{
    const CommandRun run = RunCommand({"inspect", "set"});
    EXPECT_EQ(1, run.exitCode);
    EXPECT_THAT(run.err, testing::StartsWith("set: error: there is no such file"));
}

TEST(Usage, ColourIsUsedWhereItIsAskedFor)
{
    EXPECT_THAT(LinesOf(RunCommand({"render", "--color", "always", "--frob"}).err),
                testing::ElementsAre(Mentions("\033[31merror\033[0m:", "'--frob'"),
                                     MentionsInOrder(k_RenderUsage)));
    EXPECT_THAT(RunCommand({"--color=always", "inspect", "set"}).err,
                testing::StartsWith("set: \033[31merror\033[0m: there is no such file"));
    EXPECT_THAT(RunCommand({"--color=never", "inspect", "set"}).err,
                testing::StartsWith("set: error: there is no such file"));
}

TEST(ExitCode, IsThatOfABugForAnythingButBadInputAndBadMachines)
{
    const CommandRun contract = RunInto(ContractError("DrawMesh needs a mesh"));
    EXPECT_EQ(70, contract.exitCode);
    EXPECT_THAT(contract.err, Mentions("error:", "bug in limn", "DrawMesh needs a mesh", "report"));
    EXPECT_EQ(70, RunInto(std::runtime_error("json.exception")).exitCode);
    const CommandRun other = RunInto(7);
    EXPECT_EQ(70, other.exitCode);
    EXPECT_THAT(other.err, Mentions("error:", "bug in limn", "without a name", "report"));
}

TEST(ExitCode, IsThatOfBadInputForWhatCannotBeDrawn)
{
    const CommandRun run = RunInto(DrawError("material 'a': no"));
    EXPECT_EQ(1, run.exitCode);
    EXPECT_EQ("error: material 'a': no\n", run.err);
    const CommandRun file = RunInto(std::filesystem::filesystem_error(
        "status", "/a/b", std::make_error_code(std::errc::permission_denied)));
    EXPECT_EQ(1, file.exitCode);
    EXPECT_EQ("/a/b: error: Permission denied\n", file.err);
}

TEST(ExitCode, IsThatOfTheMachineWhereMemoryIsShort)
{
    const CommandRun run = RunInto(std::bad_alloc());
    EXPECT_EQ(3, run.exitCode);
    EXPECT_EQ("error: there is not enough memory\n", run.err);
}

} // namespace limn::test

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

/// The second line of every complaint about the arguments.
const std::string k_LimnUsage = "usage: limn VERB [OPTIONS]; see 'limn help'\n";
const std::string k_RenderUsage =
    "usage: limn render SCENE -o FILE [OPTIONS]; see 'limn help render'\n";
const std::string k_ExplainUsage = "usage: limn explain SCENE [OPTIONS]; see 'limn help explain'\n";
const std::string k_ShaderUsage =
    "usage: limn shader FILE|DIR ... [OPTIONS]; see 'limn help shader'\n";

/// `limn` ends with 2, this on stderr and nothing on stdout.
void ExpectWrongUsage(const Arguments& args, const std::string& text)
{
    const CommandRun run = RunCommand(args);
    EXPECT_EQ(2, run.exitCode) << text;
    EXPECT_EQ(text, run.err);
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
    ExpectWrongUsage({"--frob"}, "error: unknown option '--frob'\n" + k_LimnUsage);
    ExpectWrongUsage({"--versoin"},
                     "error: unknown option '--versoin'; did you mean '--version'?\n" +
                         k_LimnUsage);
    ExpectWrongUsage(Render({"--sise", "3x3"}),
                     "error: unknown option '--sise'; did you mean '--size'?\n" + k_RenderUsage);
    ExpectWrongUsage({"render", "--frob=1"}, "error: unknown option '--frob'\n" + k_RenderUsage);
    ExpectWrongUsage(Render({"--verbos"}),
                     "error: unknown option '--verbos'; did you mean '--verbose'?\n" +
                         k_RenderUsage);
    ExpectWrongUsage(Render({"--" + std::string(100, 'x') + "\n\x1B[2J"}),
                     "error: unknown option '--" + std::string(46, 'x') + "…" +
                         std::string(11, 'x') + "\\n\\x1B[2J'\n" + k_RenderUsage);
}

TEST(Usage, AWrongVerbIsNamedWithTheNearest)
{
    ExpectWrongUsage({"rendr", "s"},
                     "error: unknown verb 'rendr'; did you mean 'render'?\n" + k_LimnUsage);
    ExpectWrongUsage(
        {"-v", "frobnicate"},
        "error: unknown verb 'frobnicate' (known: render, watch, inspect, explain, check, "
        "report, set, schema, shader, new, port, doctor, completion, complete, help, version)\n" +
            k_LimnUsage);
    ExpectWrongUsage({"help", "rendr"},
                     "error: unknown verb 'rendr'; did you mean 'render'?\n"
                     "usage: limn help [VERB] [OPTIONS]; see 'limn help help'\n");
    ExpectWrongUsage({"-v"}, "error: a verb is missing\n" + k_LimnUsage);
}

TEST(Usage, AFileInThePlaceOfTheVerbIsOfferedTheVerbThatTakesIt)
{
    const WorkingFolder working;
    WriteProject(working.folder);
    ExpectWrongUsage({"s.scene.yaml"},
                     "error: 's.scene.yaml' is no verb but a scene; 'limn render s.scene.yaml -o "
                     "out.png' draws it\n" +
                         k_LimnUsage);
    ExpectWrongUsage({"a.shader", "-v"},
                     "error: 'a.shader' is no verb but a shader; 'limn shader a.shader' describes "
                     "it\n" +
                         k_LimnUsage);
    ExpectWrongUsage({"no.scene.yaml"},
                     "error: unknown verb 'no.scene.yaml' (known: render, watch, inspect, explain, "
                     "check, report, set, schema, shader, new, port, doctor, completion, complete, "
                     "help, version)\n" +
                         k_LimnUsage);
}

TEST(Usage, WhatIsMissingOrTooMuchIsNamed)
{
    ExpectWrongUsage({"render"}, "error: SCENE and -o FILE are missing\n" + k_RenderUsage);
    ExpectWrongUsage({"render", "s"}, "error: -o FILE is missing\n" + k_RenderUsage);
    ExpectWrongUsage({"shader"}, "error: FILE|DIR is missing\n" + k_ShaderUsage);
    ExpectWrongUsage(Render({"t"}), "error: unexpected argument 't'\n" + k_RenderUsage);
    ExpectWrongUsage(Render({"--size"}), "error: --size needs a value: WxH\n" + k_RenderUsage);
    ExpectWrongUsage({"render", "s", "-o", "--validate"},
                     "error: --output needs a value: FILE; '--validate' is an option\n" +
                         k_RenderUsage);
    ExpectWrongUsage(Render({"--size", "1x1", "--size", "2x2"}),
                     "error: --size is given 2 times, and takes one value\n" + k_RenderUsage);
    ExpectWrongUsage(Render({"--validate=yes"}),
                     "error: --validate takes no value\n" + k_RenderUsage);
}

TEST(Usage, OptionsThatDoNotGoTogetherAreNamed)
{
    ExpectWrongUsage({"shader", "s", "--emit", "glsl"},
                     "error: --emit needs --output beside it\n" + k_ShaderUsage);
    ExpectWrongUsage({"shader", "s", "--emit", "glsl", "-o", "o", "--variants"},
                     "error: --emit and --variants exclude each other\n" + k_ShaderUsage);
    ExpectWrongUsage(Render({"-q", "-v"}),
                     "error: --quiet and --verbose exclude each other\n" + k_RenderUsage);
    ExpectWrongUsage({"explain", "s", "--pixel", "1,1", "--object", "A"},
                     "error: --object and --pixel exclude each other\n" + k_ExplainUsage);
    ExpectWrongUsage({"explain", "s", "--pixel", "1,1", "--graph", "a.svg"},
                     "error: --pixel and --graph exclude each other\n" + k_ExplainUsage);
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
    ExpectWrongUsage(Render({"-qv"}),
                     "error: --quiet and --verbose exclude each other\n" + k_RenderUsage);
    ExpectWrongUsage(Render({"-qz"}), "error: unknown option '-z'\n" + k_RenderUsage);
    ExpectWrongUsage({"shader", "-qj0", "s"},
                     "error: --jobs: '0' is no number from 1 to 256\n" + k_ShaderUsage);
}

TEST(Usage, HelpIsGivenWhateverElseIsWrong)
{
    const std::string help = RunCommand({"help", "render"}).out;
    EXPECT_EQ(help, RunCommand({"-h", "render"}).out);
    EXPECT_EQ(help, RunCommand({"render", "--frob", "--size", "x", "-qh"}).out);
    ExpectWrongUsage({"render", "--help=1"}, "error: --help takes no value\n" + k_RenderUsage);
}

TEST(Usage, APixelIsTwoWholeNumbers)
{
    for (const char* text : {"", "3", "3,", ",3", "3,4,5", "3x4", "a,b", "1.5,2", "3,4@1", "3, 4"})
    {
        ExpectWrongUsage({"explain", "s", "--pixel", text},
                         "error: --pixel: '" + std::string(text) +
                             "' is no pixel; X,Y from the top left is expected: 640,360\n" +
                             k_ExplainUsage);
    }
}

TEST(Usage, AValueThatCannotBeIsNamedWithWhatCan)
{
    const std::vector<std::pair<Arguments, std::string>> cases{
        {{"--size", "3"}, "--size: '3' is no size; WxH is expected, 1...16384 each: 1280x720"},
        {{"--size", "0x4"}, "--size: '0x4' is no size; WxH is expected, 1...16384 each: 1280x720"},
        {{"--time", "nan"}, "--time: 'nan' is no time; seconds are expected: 1.5"},
        {{"--frames", "0"}, "--frames: '0' is no number from 1 to 100000"},
        {{"--frames", "3x"}, "--frames: '3x' is no number from 1 to 100000"},
        {{"--package", "core"},
         "--package: 'core' is no package; a folder with a package.json is expected, or NAME=DIR: "
         "com.unity.render-pipelines.core=DIR"},
        {{"--set", "foo"},
         "--set: 'foo': NAME.path=value is expected, ScreenSpaceOutline.m_OutlineWidth=4"},
        {{"--color", "alway"}, "--color: unknown word 'alway'; did you mean 'always'?"},
    };
    for (const auto& [more, message] : cases)
    {
        ExpectWrongUsage(Render(more), "error: " + message + "\n" + k_RenderUsage);
    }
    ExpectWrongUsage({"shader", "s", "-o", "o", "--emit", "gls"},
                     "error: --emit: unknown word 'gls'; did you mean 'glsl'?\n" + k_ShaderUsage);
    ExpectWrongUsage({"render", "s", "-o", ""},
                     "error: --output: '' is no name of a file or folder\n" + k_RenderUsage);
    ExpectWrongUsage({"schema", "shader"},
                     "error: unknown word 'shader' (known: scene, profile, material)\n"
                     "usage: limn schema scene|profile|material [OPTIONS]; see 'limn help "
                     "schema'\n");
    ExpectWrongUsage({"set", "f", "foo"},
                     "error: 'foo': NAME.path=value is expected, "
                     "ScreenSpaceOutline.m_OutlineWidth=4\n"
                     "usage: limn set FILE NAME.path=VALUE ... [OPTIONS]; see 'limn help "
                     "set'\n");
}

TEST(Usage, APictureIsAPngByItsName)
{
    ExpectWrongUsage({"render", "s", "-o", "x.jpg"},
                     "error: --output: 'x.jpg' is no name of a PNG, and limn writes PNG only: "
                     "a.png, or - for stdout\n" +
                         k_RenderUsage);
    ExpectWrongUsage({"watch", "s", "-o", "-"},
                     "error: --output: stdout holds one picture only; name a file\n"
                     "usage: limn watch SCENE -o FILE [OPTIONS]; see 'limn help watch'\n");
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
    EXPECT_EQ("\033[31merror\033[0m: unknown option '--frob'\n" + k_RenderUsage,
              RunCommand({"render", "--color", "always", "--frob"}).err);
    EXPECT_THAT(RunCommand({"--color=always", "inspect", "set"}).err,
                testing::StartsWith("set: \033[31merror\033[0m: there is no such file"));
    EXPECT_THAT(RunCommand({"--color=never", "inspect", "set"}).err,
                testing::StartsWith("set: error: there is no such file"));
}

TEST(ExitCode, IsThatOfABugForAnythingButBadInputAndBadMachines)
{
    const std::string report = "; please report it with the command line and the files\n";
    const CommandRun contract = RunInto(ContractError("DrawMesh needs a mesh"));
    EXPECT_EQ(70, contract.exitCode);
    EXPECT_EQ("error: this is a bug in limn: DrawMesh needs a mesh" + report, contract.err);
    EXPECT_EQ(70, RunInto(std::runtime_error("json.exception")).exitCode);
    const CommandRun other = RunInto(7);
    EXPECT_EQ(70, other.exitCode);
    EXPECT_EQ("error: this is a bug in limn: an exception without a name" + report, other.err);
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

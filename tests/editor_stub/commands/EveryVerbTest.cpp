#include "Mentions.h"
#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"
#include "console/FitLines.h"

#include <gmock/gmock.h>

// What holds for every verb, each in turn: wrong words, wrong files, terminals, pipes.

namespace limn::test
{

namespace
{

using Words = std::vector<std::string>;

struct Verb
{
    std::string name;
    std::string usage;   ///< behind "usage: limn "
    std::string without; ///< what is missing from the verb alone; "" for nothing
    Words good;          ///< arguments that need no device, in a folder of WriteProject's
    Words tooMuch;       ///< what it takes, and one word more
};

const Verb k_Verbs[] = {
    {"render", "render SCENE -o FILE", "SCENE and -o FILE", {}, {"s", "-o", "o", "x"}},
    {"watch", "watch SCENE -o FILE", "SCENE and -o FILE", {}, {"s", "-o", "o", "x"}},
    {"inspect", "inspect FILE|NAME", "FILE|NAME", {"s.scene.yaml"}, {"s", "x"}},
    {"explain", "explain SCENE", "SCENE", {"s.scene.yaml"}, {"s", "x"}},
    {"check",
     "check SCENE EXPECT.yaml",
     "SCENE and EXPECT.yaml",
     {"s.scene.yaml", "e.yaml"},
     {"s", "e", "x"}},
    {"report", "report SCENE|DIR ... -o DIR", "SCENE|DIR and -o DIR", {}, {}},
    {"set",
     "set FILE NAME.path=VALUE ...",
     "FILE and NAME.path=VALUE",
     {"p.profile.yaml", "ScreenSpaceOutline.m_OutlineWidth=4"},
     {}},
    {"schema",
     "schema scene|profile|material",
     "scene|profile|material",
     {"scene"},
     {"scene", "x"}},
    {"shader", "shader FILE|DIR ...", "FILE|DIR", {"a.shader"}, {}},
    {"new",
     "new scene|profile|material|feature NAME [CONTENT ...]",
     "scene|profile|material|feature and NAME",
     {},
     {}},
    {"port", "port FILE.cs ... -o DIR", "FILE.cs and -o DIR", {}, {}},
    {"doctor", "doctor", "", {}, {"x"}},
    {"completion", "completion bash|zsh|fish", "bash|zsh|fish", {"bash"}, {"bash", "x"}},
    {"complete", "complete WORD ...", "WORD", {"re"}, {}},
    {"help", "help [VERB]", "", {"set"}, {"set", "x"}},
    {"version", "version", "", {}, {"x"}}};

Words With(const Verb& verb, const Words& more)
{
    Words words{verb.name};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::string Quoted(const Words& words)
{
    std::string text = "'" + LimnExecutable() + "'";
    for (const std::string& word : words)
    {
        text += " '" + word + "'";
    }
    return text;
}

/// Matches the lines that a verb says of wrong usage; they mention these parts.
auto Complaint(const Verb& verb, const std::vector<std::string>& parts)
{
    return testing::ElementsAre(MentionsInOrder(parts), Mentions("usage: limn " + verb.usage + " ",
                                                                 "'limn help " + verb.name + "'"));
}

class EveryVerb : public testing::Test
{
protected:
    EveryVerb()
    {
        WriteProject(working.folder);
        working.folder.Write("wrong.yaml",
                             "order: [Draw Opaque Objects, Draw Transparent Objects, Final Blit, "
                             "A Pass That No Renderer Has And That Is Long]\n");
    }

    static void ExpectWrongUsage(const Verb& verb, const Words& more,
                                 const std::vector<std::string>& parts)
    {
        const CommandRun run = RunCommand(With(verb, more));
        EXPECT_EQ(2, run.exitCode) << verb.name;
        EXPECT_THAT(LinesOf(run.err), Complaint(verb, parts));
        EXPECT_EQ("", run.out) << verb.name;
    }

    WorkingFolder working;
};

const std::string k_Colored = "\033[31merror\033[0m";

} // namespace

TEST_F(EveryVerb, IsInThisTable)
{
    std::string names;
    for (const Verb& verb : k_Verbs)
    {
        names += (names.empty() ? "" : ", ") + verb.name;
    }
    EXPECT_THAT(LinesOf(RunCommand({"frobnicate"}).err),
                testing::ElementsAre(Mentions("error:", "unknown verb", "'frobnicate'", names),
                                     Mentions("usage: limn VERB", "'limn help'")));
}

TEST_F(EveryVerb, NamesAWrongOptionAndWhatIsMissingOrTooMuch)
{
    for (const Verb& verb : k_Verbs)
    {
        ExpectWrongUsage(verb, {"--frob"}, {"error:", "unknown option", "'--frob'"});
        ExpectWrongUsage(verb, {"--colour=always"},
                         {"error:", "unknown option", "'--colour'", "'--color'"});
        ExpectWrongUsage(verb, {"--quiet=1"}, {"error:", "--quiet", "no value"});
        if (!verb.without.empty())
        {
            ExpectWrongUsage(verb, {}, {"error:", verb.without, "missing"});
        }
        if (!verb.tooMuch.empty())
        {
            ExpectWrongUsage(verb, verb.tooMuch, {"error:", "unexpected argument", "'x'"});
        }
    }
}

TEST_F(EveryVerb, HasHelpThatFitsATerminal)
{
    for (const Verb& verb : k_Verbs)
    {
        const std::string help = Terminal(60).Run({verb.name, "--help"});
        EXPECT_EQ(help, Terminal(60).Run({"help", verb.name}));
        std::string usage = help.substr(0, help.find("\n\noptions"));
        for (std::size_t at; (at = usage.find("\n        ")) != std::string::npos;)
        {
            usage.replace(at, 9, " "); // a long usage goes on in the next line
        }
        EXPECT_THAT(usage, testing::HasSubstr("\nusage: limn " + verb.usage + " [OPTIONS]"));
        std::istringstream lines(help);
        for (std::string line; std::getline(lines, line);)
        {
            EXPECT_LE(line.size(), 60u) << line;
        }
    }
}

TEST_F(EveryVerb, HasColourOnATerminalThatWantsIt)
{
    for (const Verb& verb : k_Verbs)
    {
        const Words wrong = With(verb, {"--frob"});
        const std::string plain = RunCommand(wrong).err;
        ASSERT_TRUE(plain.starts_with("error: ")) << plain;
        const std::string colored = k_Colored + plain.substr(5);
        EXPECT_EQ(colored, Terminal(200).Run(wrong));
        EXPECT_EQ(plain, Terminal(200).With("NO_COLOR", "1").Run(wrong));
        EXPECT_EQ(plain, Terminal(200).Run(With(verb, {"--color", "never", "--frob"})));
        EXPECT_EQ(plain, RunInPipe(Quoted(wrong) + " 2>&1"));
        EXPECT_EQ(colored,
                  RunInPipe(Quoted(With(verb, {"--color", "always", "--frob"})) + " 2>&1"));
    }
}

TEST_F(EveryVerb, GivesTheSameResultsToATerminalAndAPipe)
{
    for (const Verb& verb : k_Verbs)
    {
        if (verb.good.empty() && verb.name != "version")
        {
            continue; // it needs a device
        }
        const CommandRun run = RunCommand(With(verb, verb.good));
        EXPECT_EQ(0, run.exitCode) << verb.name;
        EXPECT_EQ("", run.err) << verb.name;
        EXPECT_NE("", run.out) << verb.name;
        EXPECT_EQ(run.out, RunInPipe(Quoted(With(verb, verb.good)) + " --color always 2>&1"))
            << verb.name;
        const bool isHelp = verb.name == "help"; // which is as wide as the terminal
        const std::string shown =
            Terminal(isHelp ? 80 : 9999).With("TERM", "dumb").Run(With(verb, verb.good));
        EXPECT_EQ(run.out, shown) << verb.name;
    }
}

TEST_F(EveryVerb, FitsATerminalButForWordsThatAreTooLong)
{
    constexpr unsigned short k_Columns = 80;
    int tooLong = 0;
    for (const Words& args : {Words{"inspect", "s.scene.yaml"},
                              {"inspect", "p.profile.yaml"},
                              {"inspect", "StrokeOutline"},
                              {"inspect", "Universal Render Pipeline/Lit"},
                              {"inspect", "no.scene.yaml"},
                              {"explain", "s.scene.yaml"},
                              {"explain", "-v", "s.scene.yaml"},
                              {"explain", "--object", "Piece", "s.scene.yaml"},
                              {"check", "s.scene.yaml", "wrong.yaml"},
                              {"schema", "scene"},
                              {"schema", "profile"},
                              {"shader", "a.shader"},
                              {"doctor"},
                              {"help", "report"},
                              {"frobnicate"}})
    {
        std::istringstream lines(Terminal(k_Columns).With("XDG_CACHE_HOME", "/c").Run(args));
        int count = 0;
        for (std::string line; std::getline(lines, line); ++count)
        {
            const std::size_t replaced = line.rfind("\033[K"); // a line of progress was before it
            line.erase(0, replaced == std::string::npos ? 0 : replaced + 3);
            const std::size_t begin = line.find_first_not_of(' ');
            const bool isOneWord = line.find(' ', begin) == std::string::npos;
            tooLong += ColumnsOf(line) > k_Columns && isOneWord ? 1 : 0;
            EXPECT_TRUE(ColumnsOf(line) <= k_Columns || isOneWord) << args[0] << ": " << line;
        }
        EXPECT_GT(count, 0) << args[0];
    }
    EXPECT_LE(tooLong, 30) << "the patterns of schemas and little else";
}

TEST_F(EveryVerb, NamesTheFileThatIsNotThere)
{
    for (const Words& args : {Words{"render", "no.scene.yaml", "-o", "o.png"},
                              {"watch", "no.scene.yaml", "-o", "o.png"},
                              {"inspect", "no.scene.yaml"},
                              {"explain", "no.scene.yaml"},
                              {"check", "no.scene.yaml", "e.yaml"},
                              {"set", "no.scene.yaml", "A.b=1"},
                              {"shader", "no.scene.yaml"},
                              {"port", "no.scene.yaml", "-o", "d"}})
    {
        const CommandRun run = RunCommand(args);
        EXPECT_EQ(1, run.exitCode) << args[0];
        EXPECT_EQ("no.scene.yaml: error: there is no such file\n", run.err) << args[0];
        EXPECT_EQ("", run.out) << args[0];
    }
}

TEST_F(EveryVerb, TellsAFileOfAnotherKindByWhatTakesIt)
{
    const Words shader{"a shader", "'limn shader a.shader'"};
    const Words scene{"a scene", "'limn render s.scene.yaml -o out.png'"};
    const Words profile{"a volume profile",
                        "'limn render SCENE -o out.png --profile p.profile.yaml'",
                        "'limn inspect p.profile.yaml'"};
    const std::tuple<std::string, Words, Words> cases[] = {
        {"render", {"-o", "o.png", "a.shader"}, shader},
        {"render", {"-o", "o.png", "p.profile.yaml"}, profile},
        {"watch", {"-o", "o.png", "a.shader"}, shader},
        {"watch", {"-o", "o.png", "p.profile.yaml"}, profile},
        {"inspect", {"a.shader"}, shader},
        {"explain", {"a.shader"}, shader},
        {"explain", {"p.profile.yaml"}, profile},
        {"check", {"e.yaml", "a.shader"}, shader},
        {"set", {"A.b=1", "a.shader"}, shader},
        {"shader", {"s.scene.yaml"}, scene},
        {"shader", {"p.profile.yaml"}, profile}};
    for (const auto& [verb, given, what] : cases)
    {
        Words args = given;
        const std::string file = args.back();
        if (verb == "set" || verb == "check")
        {
            std::swap(args[0], args[1]);
        }
        args.insert(args.begin(), verb);
        const CommandRun run = RunCommand(args);
        EXPECT_EQ(1, run.exitCode) << verb;
        Words parts{file + ":", "'" + verb + "'"};
        parts.insert(parts.end(), what.begin(), what.end());
        EXPECT_THAT(LinesOf(run.err), testing::ElementsAre(MentionsInOrder(parts)));
        EXPECT_EQ("", run.out) << verb;
    }
}

TEST_F(EveryVerb, WritesToStdoutWhereThatMakesSense)
{
    const auto complaint =
        [](const std::string& name, const std::string& only, const std::string& other)
    {
        return Complaint(*std::ranges::find(k_Verbs, name, &Verb::name),
                         {"--output:", "stdout", only, other});
    };
    const CommandRun watch = RunCommand({"watch", "s.scene.yaml", "-o", "-"});
    EXPECT_EQ(2, watch.exitCode);
    EXPECT_THAT(LinesOf(watch.err), complaint("watch", "one picture", "name a file"));
    const CommandRun shader = RunCommand({"shader", "a.shader", "--emit", "glsl", "-o", "-"});
    EXPECT_EQ(2, shader.exitCode);
    EXPECT_THAT(LinesOf(shader.err), complaint("shader", "one file", "name a folder"));
    EXPECT_FALSE(std::filesystem::exists("-"));
    EXPECT_THAT(
        Terminal(200).Run({"render", "s.scene.yaml", "-o", "-"}),
        Mentions(k_Colored + ":", "-o -", "terminal", "'limn render SCENE -o - > out.png'"));
}

} // namespace limn::test

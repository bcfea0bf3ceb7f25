#include "assets/FileKind.h"
#include "command_line/SharedFlags.h"
#include "console/Texts.h"

#include <filesystem>
#include <limn/base/TerminalText.h>
#include <limn/features/Version.h>
#include <utility>

namespace limn
{

namespace
{

using enum Times;

/// The values of all verbs' flags.
struct CommandLine
{
    ConsoleOptions console;
    bool wantsHelp = false;
    bool wantsVersion = false;
    bool hasNoPager = false;
    RenderOptions render; ///< of report as well
    ShaderOptions shader;
    ExplainOptions explain;
    CheckOptions check;
    InspectOptions inspect;
    SetOptions set;
    ReportCommandOptions report;
    NewOptions newFiles;
    PortOptions port;
    std::string kind; ///< of what is new, of a schema's files
    std::vector<std::string> schemaPlugins;
    std::string doctorDevice;
    bool wantsJson = false; ///< of doctor, version
    std::string helpVerb;   ///< "": of limn itself
    bool wantsManPage = false;
    std::string shell;
    std::vector<std::string> typedWords; ///< for completion
};

/// Returns the options with the scene that --scene names in the place of its project.
const RenderOptions& InProject(RenderOptions& options)
{
    if (!options.sceneInProject.empty())
    {
        std::error_code ignored;
        if (!std::filesystem::is_directory(options.scene, ignored))
        {
            throw AssetError(options.scene, {},
                             "is no folder of a Unity project, in which --scene could name a file");
        }
        options.scene = (std::filesystem::path(options.scene) / options.sceneInProject).string();
        options.sceneInProject.clear();
    }
    return options;
}

/// The flags that `render` and `watch` have in common.
std::vector<Flag> DrawingFlags(RenderOptions& options, const char* outputHelp, CheckText check)
{
    using Kind = SelectionStep::Kind;
    return {
        SceneArgument(options.scene),
        SceneFlag(options),
        WithLetter('o', {"output", "FILE", outputHelp, Into(options.output, check), Once}),
        SizeFlag(options),
        {"time", "SECONDS", "The value of _Time in the first frame, in seconds",
         IntoTime(options.time)},
        ProfileFlag(options.profile),
        SetFlag(options),
        SelectFlag(options),
        {"click", "X,Y[@SECONDS]",
         "Click on this pixel, counted from the top left: it selects the whole object that is seen "
         "there, or nothing, at time 0 or at SECONDS; selections count in the order of the flags",
         IntoSelection(options.selection, Kind::Click), Any},
        {"ctrl-click", "X,Y[@SECONDS]",
         "Add what is seen at this pixel, or take it away if it is selected",
         IntoSelection(options.selection, Kind::CtrlClick), Any},
        DeviceFlag(options.device),
        {"cache-dir", "DIR",
         "Keep compiled shaders, models and pictures here, not in the user's cache folder; "
         "LIMN_CACHE_LIMIT=SIZE (512M, 0 = no limit) limits their size",
         Into(options.cacheFolder)},
        Switch("no-cache", "Keep no compiled shaders, models and pictures", options.noCache),
        PluginFlag(options.plugins),
        PackageFlag(options.packages),
        RootFlag(options.roots)};
}

Verb RenderVerb(RenderOptions& options)
{
    std::vector<Flag> flags =
        DrawingFlags(options, "The PNG file to write; - is stdout", CheckPicture);
    flags.insert(
        flags.end(),
        {{"frames", "N", "Draw this number of frames, 1/60 s apart, and write the last",
          IntoNumber(options.frames, 100000)},
         {"stats", "FILE", "Write times and counts as JSON", Into(options.statsFile)},
         {"trace", "FILE", "Write a trace for chrome://tracing or Perfetto",
          Into(options.traceFile)},
         Switch("show-volumes",
                "Draw local volumes over the picture: their colliders, dashed where they have "
                "faded out, and the camera's volumeTrigger",
                options.showsVolumes),
         Switch("validate", "Run under the Vulkan validation layer; its errors give exit code 1",
                options.validate)});
    return {"render",
            "Draw a scene into a PNG file",
            [&options](Console& console) { return RunRender(InProject(options), console); },
            std::move(flags),
            {{"cache-dir", "no-cache"}}};
}

Verb WatchVerb(RenderOptions& options)
{
    return {"watch",
            "Draw a scene again whenever one of its files changes, until Ctrl-C",
            [&options](Console& console) { return RunWatch(InProject(options), console); },
            DrawingFlags(options, "The PNG file to write", CheckWatchedPicture),
            {{"cache-dir", "no-cache"}}};
}

Verb InspectVerb(InspectOptions& options)
{
    return {"inspect",
            "Show parameters and settings: value, default, range, whether it is set",
            [&options](Console& console) { return RunInspect(options, console); },
            {Argument("FILE|NAME",
                      "A scene as for 'limn render', a volume profile, a renderer asset or a "
                      "material; or the name of a volume component, of a feature's type or of a "
                      "shader, whose defaults are shown",
                      Into(options.file), Once,
                      FilesOr({".scene.yaml", ".profile.yaml", ".unity", ".asset", ".mat"},
                              NameCandidates)),
             Switch("json", "Print JSON", options.json), PluginFlag(options.plugins),
             RootFlag(options.roots)}};
}

Verb ExplainVerb(ExplainOptions& options)
{
    return {"explain",
            "Explain what a scene draws and why: counts and everything odd; -v prints all",
            [&options](Console& console)
            {
                InProject(options.rendering);
                return RunExplain(options, console);
            },
            {SceneArgument(options.rendering.scene),
             SceneFlag(options.rendering),
             {"object", "NAME", "Explain only the objects of this name and their children",
              Into(options.object), AtMostOnce, Objects(options.rendering)},
             {"pixel", "X,Y",
              "Show what is drawn at this pixel, counted from the top left, and which test rejects "
              "the rest; this draws the scene, so it needs a device",
              Into(options.pixel, CheckPixel)},
             Switch("json", "Print JSON", options.json),
             {"graph", "FILE",
              "Write the frame as a picture: its passes, the textures between them, what is left "
              "out; FILE is .svg, .png or .pdf, drawn by Graphviz, or .dot",
              Into(options.graph, CheckGraph)},
             ProfileFlag(options.rendering.profile),
             SetFlag(options.rendering),
             DeviceFlag(options.rendering.device),
             PluginFlag(options.rendering.plugins),
             PackageFlag(options.rendering.packages),
             RootFlag(options.rendering.roots)},
            {{"object", "pixel"}, {"pixel", "graph"}}};
}

Verb CheckVerb(CheckOptions& options)
{
    RenderOptions& rendering = options.rendering;
    return {"check",
            "Compare what a scene draws with what a file expects: objects of each feature, volume "
            "values, passes, textures, what is left out; for CI, without a device",
            [&options](Console& console)
            {
                InProject(options.rendering);
                return RunCheck(options, console);
            },
            {SceneArgument(rendering.scene),
             Argument("EXPECT.yaml",
                      "The expectations; samples/guide/testing.md explains them, --update writes "
                      "the first",
                      Into(options.expectations, CheckOutput), Once, Files({".yaml"})),
             SceneFlag(rendering),
             Switch("update",
                    "Replace the values that do not hold, and change nothing else; comments within "
                    "a replaced value are lost; a missing file is written in full",
                    options.isUpdate),
             {"junit", "FILE", "Write the results as JUnit XML, which CI shows as tests",
              Into(options.junit, CheckOutput)},
             Switch("json", "Print the results as JSON", options.json),
             SizeFlag(rendering),
             ProfileFlag(rendering.profile),
             SetFlag(rendering),
             SelectFlag(rendering),
             PluginFlag(rendering.plugins),
             PackageFlag(rendering.packages),
             RootFlag(rendering.roots)},
            {{"update", "junit"}, {"update", "json"}}};
}

Verb ReportVerb(RenderOptions& render, ReportCommandOptions& options)
{
    Flag output = WithLetter(
        'o', {"output", "DIR",
              "The folder for the report; what an interrupted run left there is taken over",
              Into(options.output, CheckOutput), Once});
    output.unless = "compare";
    return {
        "report",
        "Measure the error and the cost of every outline technique in a scene",
        [&](Console& console) { return RunReport(render, options, console); },
        {Argument("SCENE|DIR",
                  "A scene, as for 'limn render'; for --merge and --compare folders of reports",
                  Into(options.paths), AtLeastOnce, Files({".scene.yaml", ".unity"})),
         std::move(output),
         Switch("quick", "Fewer widths, shapes and sizes: within a minute", options.isQuick),
         Switch("stability",
                "Only test the techniques with extreme inputs, in all pairs, under the Vulkan "
                "validation layer",
                options.hasStability),
         Switch("all-combinations",
                "Test all combinations of extreme inputs in place of all pairs; this takes days",
                options.isFull),
         {"technique", "NAME", "Measure only this technique", Into(options.techniques), Any,
          [&render](const std::string&)
          {
              return TechniqueCandidates(render.plugins);
          }},
         {"budget", "MS",
          "Recommend a technique that adds at most this number of milliseconds of GPU time",
          IntoBudget(options.budget)},
         {"shard", "I/N", "Measure the I-th of N parts, which --merge puts together",
          IntoPart(options.shard, options.shards)},
         Switch("merge", "Make one report of the folders of all parts; nothing is drawn",
                options.isMerge),
         Switch("compare",
                "Print the cells in which two folders differ, except for times; exit code 1 if "
                "they do",
                options.isCompare),
         Switch("json",
                "Print what a report comes to as JSON: its files, the recommendation, what to know",
                options.json),
         SizeFlag(render),
         DeviceFlag(render.device),
         PluginFlag(render.plugins),
         PackageFlag(render.packages),
         RootFlag(render.roots)},
        {{"quick", "all-combinations"},
         {"all-combinations", "stability", true},
         {"shard", "merge"},
         {"shard", "compare"},
         {"merge", "compare"}}};
}

Verb SetVerb(SetOptions& options)
{
    Flag edits =
        Argument("NAME.path=VALUE",
                 "For example ScreenSpaceOutline.m_OutlineWidth=4; m_OutlineColor.r=1 changes "
                 "one number, and += -= *= start from the one that there is",
                 Into(options.edits, CheckAssignment), AtLeastOnce,
                 [&options](const std::string& word) {
                     return SettingCandidates(word, {options.file, false, options.plugins, {}});
                 });
    edits.unless = "undo";
    return {"set",
            "Change values of a volume profile, or of the features of a scene or a Unity renderer, "
            "in place; no other character changes",
            [&options](Console& console) { return RunSet(options, console); },
            {Argument("FILE",
                      "A *.profile.yaml, a *.scene.yaml, or a Unity VolumeProfile or renderer "
                      ".asset",
                      Into(options.file), Once, Files({".profile.yaml", ".scene.yaml", ".asset"})),
             std::move(edits),
             Switch("undo",
                    "Bring back the text from before the last change by 'limn set'; once more "
                    "brings the change again",
                    options.undo),
             Switch("json", "Print the changes as JSON", options.json),
             PluginFlag(options.plugins)}};
}

Verb SchemaVerb(CommandLine& line)
{
    return {"schema",
            "Print a JSON Schema, from which an editor completes keys and shows ranges",
            [&line](Console& console) { return RunSchema(line.kind, line.schemaPlugins, console); },
            {Argument("scene|profile|material", "The kind of file: scene, profile or material",
                      Into(line.kind)),
             PluginFlag(line.schemaPlugins)}};
}

Verb ShaderVerb(ShaderOptions& options)
{
    return {
        "shader",
        "Check ShaderLab files and shader graphs; of a single one show passes, states and layout",
        [&options](Console& console) { return RunShader(options, console); },
        {Argument("FILE|DIR", "Files, and folders with .shader files below them; or .compute files",
                  Into(options.paths), AtLeastOnce, Files({".shader", ".shadergraph", ".compute"})),
         WithLetter('o', {"output", "DIR", "Where --emit writes",
                          Into(options.outputFolder, CheckFolder)}),
         {"emit", "spirv|glsl|glsles|msl|hlsl", "Write the compiled programs", Into(options.emit)},
         Switch("print", "Print the files as canonical ShaderLab text; compile nothing",
                options.print),
         Switch("parse-only", "Do not compile the programs", options.parseOnly),
         Switch("variants", "Count variants; compile nothing", options.variants),
         {"keywords", "A,B", "Compile with these keywords, not with those of a new material",
          IntoWords(options.keywords), Any},
         WithLetter('j',
                    {"jobs", "N", "The number of files to check at a time; without it one per core",
                     IntoNumber(options.jobs, 256)}),
         Switch("json", "Print {files: [...], summary: {...}}: what was parsed, compiled, refused",
                options.json),
         PackageFlag(options.packages),
         RootFlag(options.roots)},
        {{"output", "emit", true},
         {"emit", "output", true},
         {"emit", "print"},
         {"emit", "parse-only"},
         {"emit", "variants"},
         {"print", "variants"},
         {"print", "json"}}};
}

Verb NewVerb(NewOptions& options)
{
    Flag folder = NewFolderFlag(options.folder);
    folder.times = AtMostOnce;
    folder.help = "For a feature: a new or empty folder";
    return {
        "new",
        "Write a scene, a volume profile or a material to start from, or the folder of a "
        "render feature that builds and draws at once",
        [&options](Console& console) { return RunNew(options, console); },
        {Argument("scene|profile|material|feature",
                  "The kind of file: scene, profile, material or feature", Into(options.kind)),
         Argument("NAME",
                  "The name of the file, hero for hero.scene.yaml; for a feature the name of its "
                  "classes, such as DepthFog",
                  Into(options.name)),
         Argument("CONTENT",
                  "For a profile its volume components, by default StrokeOutline; for a material "
                  "its shader, by default \"Universal Render Pipeline/Lit\"",
                  Into(options.contents), Any,
                  [&options](const std::string&)
                  { return options.kind == "profile" ? ComponentCandidates() : Candidates(); }),
         std::move(folder),
         {"style", "urp14|unity6",
          "The style of a feature's code: urp14, as in Unity 2022 (default), or unity6: a render "
          "graph",
          Into(options.style)}}};
}

Verb PortVerb(PortOptions& options)
{
    return {"port",
            "Start a C++ port of a Unity render feature, and report which of the members that it "
            "uses limn has",
            [&options](Console& console) { return RunPort(options, console); },
            {Argument("FILE.cs",
                      "The C# file of the feature; files of its Unity project, or else of its "
                      "folder, that declare what it uses are read, too",
                      Into(options.files), AtLeastOnce, Files({".cs"})),
             NewFolderFlag(options.folder)}};
}

Verb DoctorVerb(CommandLine& line)
{
    return {"doctor",
            "Show devices, drivers, the cache folder and versions on this machine",
            [&line](Console& console)
            { return RunDoctor(line.doctorDevice, line.wantsJson, console); },
            {DeviceFlag(line.doctorDevice), Switch("json", "Print JSON", line.wantsJson)}};
}

ExitCode Print(const std::string& text, Console& console)
{
    console.out() << text;
    return ExitCode::Done;
}

Verb CompletionVerb(std::string& shell)
{
    return {"completion",
            "Print a script for a shell's completion",
            [&](Console& console) { return Print(CompletionScript(shell), console); },
            {Argument("bash|zsh|fish", "For bash: source <(limn completion bash)", Into(shell))}};
}

Verb CompleteVerb(const FlagTable& table, std::vector<std::string>& typed)
{
    const auto print = [&](Console& console)
    {
        const std::vector<std::string> words = std::exchange(typed, {});
        return Print(CompletionText(table, words), console);
    };
    return {"complete",
            "Print what may stand in place of the last word, for the scripts of 'limn completion'",
            print,
            {Argument("WORD", "The words behind 'limn', with -- in front of the first", Into(typed),
                      AtLeastOnce)}};
}

Verb HelpVerb(const FlagTable& table, std::string& name, bool& wantsManPage)
{
    const auto store = [&](const std::string& text)
    {
        name = text;
        return CheckWord("verb", text, table.VerbNames());
    };
    const auto print = [&](Console& console)
    {
        if (wantsManPage)
        {
            return Print(ManPage(table), console);
        }
        const Verb& verb = name.empty() ? table.limn : *table.Find(name);
        return Print(HelpText(table, verb, console.outWidth()), console);
    };
    return {"help",
            "Print this help, or the arguments of a verb",
            print,
            {Argument("VERB", "The verb to explain", store, AtMostOnce,
                      [&table](const std::string&) { return SplitText(table.VerbNames(), ' '); }),
             Switch("man", "Print the man page, which has all verbs, in troff", wantsManPage)}};
}

Verb VersionVerb(bool& wantsJson)
{
    return {"version",
            "Print the version, as -V does",
            [&wantsJson](Console& console) { return RunVersion(wantsJson, console); },
            {Switch("json", "Print JSON, with the versions of libraries", wantsJson)}};
}

std::vector<Flag> CommonFlags(CommandLine& line)
{
    const auto storeColor = [&line](const std::string& text)
    {
        line.console.color = text == "always"  ? ColorMode::Always
                             : text == "never" ? ColorMode::Never
                                               : ColorMode::Auto;
        return std::string();
    };
    return {Switch("version", "Print the version", line.wantsVersion, 'V'),
            Switch("help", "Print this help", line.wantsHelp, 'h'),
            Switch("quiet", "Print errors only, besides results", line.console.isQuiet, 'q'),
            Switch("verbose", "Print more: the device that draws, all that `explain` knows",
                   line.console.isVerbose, 'v'),
            {"color", "auto|always|never",
             "Colours on stderr; 'auto': on a terminal, unless NO_COLOR is set", storeColor},
            Switch("no-pager",
                   "Print long results at once; by itself LIMN_PAGER, PAGER or `less` shows them "
                   "on a terminal",
                   line.hasNoPager)};
}

/// Fills the table with limn's verbs, which store values in `line`. Both must outlive what is
/// called of the table.
void FillTable(FlagTable& table, CommandLine& line)
{
    table.limn = {"limn",
                  "limn renders scenes as Unity's URP 14 does, without Unity.",
                  {},
                  CommonFlags(line),
                  {{"quiet", "verbose"}}};
    table.verbs = {RenderVerb(line.render),
                   WatchVerb(line.render),
                   InspectVerb(line.inspect),
                   ExplainVerb(line.explain),
                   CheckVerb(line.check),
                   ReportVerb(line.render, line.report),
                   SetVerb(line.set),
                   SchemaVerb(line),
                   ShaderVerb(line.shader),
                   NewVerb(line.newFiles),
                   PortVerb(line.port),
                   DoctorVerb(line),
                   CompletionVerb(line.shell),
                   CompleteVerb(table, line.typedWords),
                   HelpVerb(table, line.helpVerb, line.wantsManPage),
                   VersionVerb(line.wantsJson)};
    for (Verb& verb : table.verbs)
    {
        verb.isRead =
            IsIn(verb.name, {"inspect", "explain", "check", "schema", "shader", "doctor", "help"});
    }
}

/// Returns a sentence about the first wrong word. If a file stands in the place of the verb, the
/// sentence names the verbs that take it.
std::string ProblemText(const ParsedFlags& parsed)
{
    std::error_code ignored;
    const std::string& word = parsed.unknownVerb;
    const std::string use =
        !word.empty() && std::filesystem::exists(word, ignored) ? UseOfFile(word) : "";
    return use.empty() ? parsed.problem : "'" + word + "' is no verb but " + use;
}

ExitCode WrongUsage(const FlagTable& table, const ParsedFlags& parsed, Console& console)
{
    console.Error(Sentence(ProblemText(parsed)));
    const std::string verb = parsed.verb == &table.limn ? "" : " " + parsed.verb->name;
    console.Line("usage: " + UsageText(table, *parsed.verb) + "; see 'limn help" + verb + "'");
    return ExitCode::WrongUsage;
}

/// Returns whether there is a working directory, without which no file can be found.
bool HasWorkingDirectory(Console& console)
{
    std::error_code error;
    if (!std::filesystem::current_path(error).empty())
    {
        return true;
    }
    if (error != std::errc::no_such_file_or_directory)
    {
        throw std::system_error(error, "the working directory");
    }
    console.Error("the working directory is not there any more; change into one that is");
    return false;
}

} // namespace

ExitCode RunCommandLine(std::span<const std::string> args, Console& console)
{
    CommandLine line;
    FlagTable table;
    FillTable(table, line);
    const ParsedFlags parsed = ParseFlags(args, table);
    console.Configure(line.console);
    if (!line.hasNoPager && (line.wantsHelp || args.empty() || parsed.verb->isRead))
    {
        console.CollectResults();
    }
    if (line.wantsHelp || args.empty())
    {
        line.helpVerb = parsed.verb == &table.limn ? "" : parsed.verb->name;
        return table.Find("help")->run(console);
    }
    if (line.wantsVersion)
    {
        return table.Find("version")->run(console);
    }
    if (!parsed.problem.empty())
    {
        return WrongUsage(table, parsed, console);
    }
    return HasWorkingDirectory(console) ? parsed.verb->run(console) : ExitCode::MachineLacksIt;
}

} // namespace limn

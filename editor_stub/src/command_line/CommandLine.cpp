#include "command_line/CommandLine.h"

#include "command_line/Checks.h"
#include "command_line/Completion.h"
#include "command_line/Help.h"
#include "command_line/OptionText.h"
#include "command_line/ReportOptions.h"
#include "command_line/SelectionOptions.h"
#include "command_line/UsageProblem.h"
#include "commands/DoctorCommand.h"
#include "commands/SchemaCommand.h"
#include "commands/WatchCommand.h"
#include "explain/FrameGraph.h"
#include "settings/Keys.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <limn/base/Case.h>
#include <limn/editor_stub/Overrides.h>
#include <limn/editor_stub/RunLimn.h>
#include <limn/volume/ProfileEdit.h>
#include <limn/volume/YamlRead.h>
#include <optional>

namespace limn
{

namespace
{

/// Width and height of "640x360"; nothing if the text is no size.
std::optional<std::pair<int, int>> ParseSize(const std::string& text)
{
    const std::size_t x = text.find('x');
    int numbers[2] = {0, 0};
    const std::string parts[2] = {text.substr(0, x),
                                  x == std::string::npos ? "" : text.substr(x + 1)};
    for (std::size_t i = 0; i < 2; ++i)
    {
        const char* end = parts[i].data() + parts[i].size();
        const auto [rest, error] = std::from_chars(parts[i].data(), end, numbers[i]);
        if (error != std::errc{} || rest != end || numbers[i] < k_PictureSizes.min ||
            numbers[i] > k_PictureSizes.max)
        {
            return std::nullopt;
        }
    }
    return std::pair(numbers[0], numbers[1]);
}

std::string CheckSize(const std::string& text)
{
    return ParseSize(text) ? std::string()
                           : "'" + text + "' is no size; WxH is expected, 1..." +
                                 NumberText(k_PictureSizes.max) + " each: 1280x720";
}

std::map<std::string, std::string> ToPackages(const std::vector<std::string>& texts)
{
    std::map<std::string, std::string> packages;
    for (const std::string& text : texts)
    {
        packages.merge(ReadPackages(text));
    }
    return packages;
}

void AddRootOption(CLI::App& verb, CommandLine& line)
{
    verb.add_option("--root", line.roots,
                    "Let references and includes lead into this folder too, not only into the "
                    "file's own and the Unity project around it")
        ->type_name("DIR")
        ->allow_extra_args(false);
}

void AddPackageOption(CLI::App& verb, CommandLine& line)
{
    verb.add_option("--package", line.packages,
                    "Take a package's shader includes from a folder of your own; without NAME, "
                    "what its package.json says")
        ->type_name("[NAME=]DIR")
        ->allow_extra_args(false)
        ->check(CheckPackage);
}

void AddPluginOption(CLI::App& verb, CommandLine& line)
{
    verb.add_option("--plugin", line.plugins,
                    "Load features, volume components and shaders from a module, whose code runs")
        ->type_name("FILE.so")
        ->allow_extra_args(false);
}

void AddSizeOption(CLI::App& verb, std::string& size)
{
    verb.add_option("--size", size, "Picture size in pixels; without it the scene's")
        ->type_name("WxH")
        ->check(CheckSize);
}

void AddDeviceOption(CLI::App& verb, std::string& device)
{
    verb.add_option("--device", device,
                    "'software', a position in `limn doctor`'s list, or a part of a name; without "
                    "it what LIMN_DEVICE says, else the first real GPU, else the software device")
        ->type_name("NAME")
        ->envname("LIMN_DEVICE");
}

/// Makes `run` what limn does if the arguments name this verb.
void OnceParsed(CLI::App* verb, CommandLine& line, std::function<int(Console&)> run)
{
    verb->final_callback([&line, run = std::move(run)] { line.run = run; });
}

std::string CheckPixel(const std::string& text)
{
    const bool isPixel = ParseClick(text) && text.find('@') == std::string::npos;
    return isPixel ? std::string()
                   : "'" + text + "' is no pixel; X,Y from the top left is expected: 640,360";
}

std::string CheckAssignment(const std::string& text)
{
    const std::string problem = ValueAssignment::FormProblem(text);
    return problem.empty() ? problem : "'" + text + "': " + problem;
}

/// Other values than the scene's.
void AddValueOptions(CLI::App& verb, std::string& profile, std::vector<std::string>& overrides)
{
    verb.add_option("--profile", profile,
                    "Put this volume profile in place of that of every global volume")
        ->type_name("FILE");
    verb.add_option("--set", overrides,
                    "Change one value; NAME is a volume component's type, a feature's name or a "
                    "feature's type")
        ->type_name("NAME.path=VALUE")
        ->allow_extra_args(false)
        ->check(CheckAssignment);
}

/// What `render` and `watch` have in common.
CLI::App* AddDrawingVerb(CLI::App& app, CommandLine& line, const char* name,
                         const char* description)
{
    RenderOptions& options = line.render;
    CLI::App* verb = app.add_subcommand(name, description);
    verb->add_option("scene", options.scene, "A scene file, *.scene.yaml")
        ->type_name("SCENE")
        ->required();
    verb->add_option("-o,--output", options.output, "The PNG file to write; - is stdout")
        ->type_name("FILE")
        ->required()
        ->check(CheckPicture);
    AddSizeOption(*verb, line.size);
    verb->add_option("--time", options.time, "What _Time shows in the first frame, seconds")
        ->type_name("SECONDS")
        ->check(CheckTime);
    AddValueOptions(*verb, options.profile, options.overrides);
    AddSelectionOptions(*verb, line.selection);
    AddDeviceOption(*verb, options.device);
    auto* cache = verb->add_option("--cache-dir", options.cacheFolder,
                                   "Keep compiled shaders here, not in the user's cache folder; "
                                   "LIMN_CACHE_LIMIT=SIZE (512M, 0 = no limit) says how many")
                      ->type_name("DIR");
    verb->add_flag("--no-cache", options.noCache, "Keep no compiled shaders")->excludes(cache);
    AddPluginOption(*verb, line);
    AddPackageOption(*verb, line);
    AddRootOption(*verb, line);
    return verb;
}

void AddRender(CLI::App& app, CommandLine& line)
{
    RenderOptions& options = line.render;
    CLI::App* verb = AddDrawingVerb(app, line, "render", "Draw a scene into a PNG file");
    verb->add_option("--frames", options.frames,
                     "Draw so many frames, 1/60 s apart, and write the last")
        ->type_name("N")
        ->check(CheckCount(100000));
    verb->add_option("--stats", options.statsFile, "Write times and counts as JSON")
        ->type_name("FILE");
    verb->add_option("--trace", options.traceFile, "Write a trace for chrome://tracing or Perfetto")
        ->type_name("FILE");
    verb->add_flag("--validate", options.validate,
                   "Run under the Vulkan validation layer; its errors give exit code 1");
    OnceParsed(verb, line,
               [verb, &line](Console& console)
               {
                   line.render.selection = SelectionStepsOf(*verb);
                   return RunRender(line.render, console);
               });
}

/// Refuses `-o ""` wherever there is an -o.
void RequireOutputNames(CLI::App& app)
{
    for (CLI::App* verb : app.get_subcommands({}))
    {
        if (CLI::Option* output = verb->get_option_no_throw("--output"))
        {
            output->check([](const std::string& text)
                          { return text.empty() ? "'' is no name of a file or folder" : ""; });
        }
        RequireOutputNames(*verb);
    }
}

void AddWatch(CLI::App& app, CommandLine& line)
{
    CLI::App* verb = AddDrawingVerb(
        app, line, "watch", "Draw a scene again whenever one of its files changes, until Ctrl-C");
    CLI::Option* output = verb->get_option("--output")->description("The PNG file to write");
    output->check([](const std::string& text)
                  { return text == "-" ? "stdout holds one picture only; name a file" : ""; });
    OnceParsed(verb, line,
               [verb, &line](Console& console)
               {
                   line.render.selection = SelectionStepsOf(*verb);
                   return RunWatch(line.render, console);
               });
}

void AddInspect(CLI::App& app, CommandLine& line)
{
    CLI::App* verb = app.add_subcommand(
        "inspect", "Show parameters and settings: value, default, range, whether it is set");
    verb->add_option("file", line.inspect.file, "A scene, a volume profile or a renderer asset")
        ->type_name("SCENE|PROFILE")
        ->required();
    verb->add_flag("--json", line.inspect.json, "Print JSON");
    AddPluginOption(*verb, line);
    AddRootOption(*verb, line);
    OnceParsed(verb, line, [&line](Console& console) { return RunInspect(line.inspect, console); });
}

void AddShader(CLI::App& app, CommandLine& line)
{
    ShaderOptions& options = line.shader;
    CLI::App* verb = app.add_subcommand(
        "shader", "Check ShaderLab files; of a single one show passes, states and layout");
    verb->add_option("paths", options.paths,
                     "Files, and folders with .shader files below them; or .compute files")
        ->type_name("FILE|DIR")
        ->required();
    auto* folder = verb->add_option("-o,--output", options.outputFolder, "Where --emit writes")
                       ->type_name("DIR");
    folder->check([](const std::string& text)
                  { return text == "-" ? "stdout holds one file only; name a folder" : ""; });
    auto* emit = verb->add_option("--emit", options.emit, "Write the compiled programs")
                     ->type_name("spirv|glsl|glsles|msl|hlsl")
                     ->check(CheckChoice("spirv|glsl|glsles|msl|hlsl"))
                     ->needs(folder);
    folder->needs(emit);
    auto* print = verb->add_flag("--print", options.print,
                                 "Print the files as canonical ShaderLab text; compile nothing")
                      ->excludes(emit);
    verb->add_flag("--parse-only", options.parseOnly, "Do not compile the programs")
        ->excludes(emit);
    verb->add_flag("--variants", options.variants, "Count variants; compile nothing")
        ->excludes(emit)
        ->excludes(print);
    verb->add_option("--keywords", options.keywords,
                     "Compile with these keywords, not with those of a new material")
        ->type_name("A,B")
        ->delimiter(',');
    verb->add_option("-j,--jobs", options.jobs, "Files to check at a time; one a core by itself")
        ->type_name("N")
        ->check(CheckCount(256));
    verb->add_flag("--json", options.json,
                   "Print {files: [...], summary: {...}}: what was parsed, compiled, refused")
        ->excludes(print);
    AddPackageOption(*verb, line);
    AddRootOption(*verb, line);
    OnceParsed(verb, line, [&line](Console& console) { return RunShader(line.shader, console); });
}

void AddReport(CLI::App& app, CommandLine& line)
{
    CLI::App* verb = app.add_subcommand(
        "report", "Measure the error and the cost of every outline technique in a scene");
    AddReportOptions(*verb, line.report);
    AddSizeOption(*verb, line.size);
    AddDeviceOption(*verb, line.render.device);
    AddPluginOption(*verb, line);
    AddPackageOption(*verb, line);
    AddRootOption(*verb, line);
    OnceParsed(verb, line,
               [&line](Console& console) { return RunReport(line.render, line.report, console); });
}

void AddExplain(CLI::App& app, CommandLine& line)
{
    ExplainOptions& options = line.explain;
    CLI::App* verb = app.add_subcommand(
        "explain", "Say what a scene draws and why: counts and what is odd; -v says all");
    verb->add_option("scene", options.scene, "A scene file, *.scene.yaml")
        ->type_name("SCENE")
        ->required();
    CLI::Option* object = verb->add_option("--object", options.object,
                                           "Only objects of this name and what hangs below them")
                              ->type_name("NAME");
    CLI::Option* pixel =
        verb->add_option("--pixel", options.pixel,
                         "Say what is drawn at this pixel of the picture, counted from the top "
                         "left, and what is rejected there, by which test; this draws, on a device")
            ->type_name("X,Y")
            ->check(CheckPixel)
            ->excludes(object);
    verb->add_flag("--json", options.json, "As JSON");
    verb->add_option("--graph", options.graph,
                     "Write the frame as a picture: its passes, the textures between them, what is "
                     "left out; FILE is .svg, .png or .pdf, drawn by Graphviz, or .dot")
        ->type_name("FILE")
        ->check(CheckGraph)
        ->excludes(pixel);
    AddValueOptions(*verb, options.profile, options.overrides);
    AddDeviceOption(*verb, options.device);
    AddPluginOption(*verb, line);
    AddPackageOption(*verb, line);
    AddRootOption(*verb, line);
    OnceParsed(verb, line, [&line](Console& console) { return RunExplain(line.explain, console); });
}

void AddSet(CLI::App& app, CommandLine& line)
{
    CLI::App* verb = app.add_subcommand(
        "set", "Change values of a volume profile, or of the features of a scene or a Unity "
               "renderer, in place, and not a character besides");
    verb->add_option(
            "file", line.set.file,
            "A *.profile.yaml, a *.scene.yaml, or a Unity VolumeProfile or renderer .asset")
        ->type_name("FILE")
        ->required();
    verb->add_option("edits", line.set.edits, "Such as ScreenSpaceOutline.m_OutlineWidth=4")
        ->type_name("NAME.path=VALUE")
        ->required()
        ->check(CheckAssignment);
    AddPluginOption(*verb, line);
    OnceParsed(verb, line, [&line](Console& console) { return RunSet(line.set, console); });
}

void AddSchema(CLI::App& app, CommandLine& line)
{
    CLI::App* verb = app.add_subcommand(
        "schema", "Print a JSON Schema, from which an editor completes keys and shows ranges");
    verb->add_option("kind", line.schemaKind, "The kind of file: scene, profile or material")
        ->type_name("scene|profile|material")
        ->required()
        ->check(CheckChoice("scene|profile|material"));
    AddPluginOption(*verb, line);
    OnceParsed(verb, line,
               [&line](Console& console)
               { return RunSchema(line.schemaKind, line.plugins, console); });
}

void AddNew(CLI::App& app, CommandLine& line)
{
    CLI::App* verb = app.add_subcommand(
        "new", "Write the folder of a render feature that builds and draws at once");
    verb->add_option("kind", line.newKind, "What to write: feature")
        ->type_name("feature")
        ->required()
        ->check(CheckChoice("feature"));
    verb->add_option("name", line.newFeature.name, "Of its classes, such as DepthFog")
        ->type_name("NAME")
        ->required();
    verb->add_option("-o,--output", line.newFeature.folder, "A new or empty folder")
        ->type_name("DIR")
        ->required()
        ->check([](const std::string& text)
                { return text == "-" ? "stdout holds one file only; name a folder" : ""; });
    verb->add_option("--style", line.newFeature.style,
                     "Of the code: urp14, as in Unity 2022 (default), or unity6: a render graph")
        ->type_name("urp14|unity6")
        ->check(CheckChoice("urp14|unity6"));
    OnceParsed(verb, line, [&line](Console& console) { return RunNew(line.newFeature, console); });
}

void AddPort(CLI::App& app, CommandLine& line)
{
    CLI::App* verb = app.add_subcommand(
        "port", "Begin the C++ of a render feature of Unity's, and say what limn has of what it "
                "uses");
    verb->add_option("files", line.port.files, "Its C#: feature, passes, volume component")
        ->type_name("FILE.cs")
        ->required();
    verb->add_option("-o,--output", line.port.folder, "A new or empty folder")
        ->type_name("DIR")
        ->required()
        ->check([](const std::string& text)
                { return text == "-" ? "stdout holds one file only; name a folder" : ""; });
    OnceParsed(verb, line, [&line](Console& console) { return RunPort(line.port, console); });
}

void AddDoctor(CLI::App& app, CommandLine& line)
{
    CLI::App* verb = app.add_subcommand(
        "doctor", "Show devices, drivers, the cache folder and versions on this machine");
    AddDeviceOption(*verb, line.doctorDevice);
    OnceParsed(verb, line,
               [&line](Console& console) { return RunDoctor(line.doctorDevice, console); });
}

void AddCompletion(CLI::App& app, CommandLine& line)
{
    CLI::App* verb = app.add_subcommand("completion", "Print a script for a shell's completion");
    verb->add_option("shell", line.completionShell, "For bash: source <(limn completion bash)")
        ->type_name("bash|zsh|fish")
        ->required()
        ->check(CheckChoice("bash|zsh|fish"));
    OnceParsed(verb, line,
               [&app, &line](Console& console)
               {
                   console.out() << CompletionScript(app, line.completionShell);
                   return static_cast<int>(ExitCode::Done);
               });
}

void AddHelp(CLI::App& app, CommandLine& line)
{
    CLI::App* verb = app.add_subcommand("help", "Print this, or what a verb takes");
    verb->add_option("verb", line.helpVerb, "What to explain")
        ->type_name("VERB")
        ->check(
            [&app](const std::string& name)
            {
                const std::vector<std::string> names = VerbNames(app);
                const bool isVerb = std::find(names.begin(), names.end(), name) != names.end();
                return isVerb ? std::string() : UnknownVerb(name, app);
            });
    OnceParsed(verb, line,
               [&app, &line](Console& console)
               {
                   const CLI::App& wanted =
                       line.helpVerb.empty() ? app : *app.get_subcommand(line.helpVerb);
                   console.out() << HelpText(wanted, TerminalWidth(console.out()));
                   return static_cast<int>(ExitCode::Done);
               });
}

void AddVersion(CLI::App& app, CommandLine& line)
{
    const auto print = [&app](Console& console)
    {
        console.out() << app.version() << '\n';
        return static_cast<int>(ExitCode::Done);
    };
    OnceParsed(app.add_subcommand("version", "Print the version, as -V does"), line, print);
}

} // namespace

void AddEverything(CLI::App& app, CommandLine& line)
{
    app.set_help_flag("-h,--help", "Print this");
    app.add_flag("-q,--quiet", line.isQuiet, "Print errors only, besides results")
        ->disable_flag_override();
    app.add_flag("-v,--verbose", line.isVerbose,
                 "Print more: the device that draws, all that `explain` knows")
        ->disable_flag_override()
        ->excludes("--quiet");
    app.add_option("--color", line.color,
                   "Colours on stderr; 'auto': on a terminal, unless NO_COLOR is set")
        ->type_name("auto|always|never")
        ->check(CheckChoice("auto|always|never"));
    app.option_defaults()->disable_flag_override();
    AddRender(app, line);
    AddWatch(app, line);
    AddInspect(app, line);
    AddExplain(app, line);
    AddReport(app, line);
    AddSet(app, line);
    AddSchema(app, line);
    AddShader(app, line);
    AddNew(app, line);
    AddPort(app, line);
    AddDoctor(app, line);
    AddCompletion(app, line);
    AddHelp(app, line);
    AddVersion(app, line);
    RequireOutputNames(app);
}

ConsoleOptions ConsoleOptionsOf(const CLI::App& app)
{
    // Not `line`, which CLI11 does not fill where another option is wrong.
    const CLI::results_t& colors = app.get_option("--color")->results();
    const std::string color = colors.empty() ? "auto" : colors.front();
    return {color == "always"  ? ColorMode::Always
            : color == "never" ? ColorMode::Never
                               : ColorMode::Auto,
            app.count("--quiet") > 0, app.count("--verbose") > 0};
}

void FinishOptions(CommandLine& line)
{
    if (const auto size = ParseSize(line.size))
    {
        line.render.width = size->first;
        line.render.height = size->second;
    }
    line.render.packages = ToPackages(line.packages);
    line.shader.packages = line.render.packages;
    line.explain.packages = line.render.packages;
    line.render.plugins = line.plugins;
    line.explain.plugins = line.plugins;
    line.inspect.plugins = line.plugins;
    line.set.plugins = line.plugins;
    line.render.roots = line.roots;
    line.shader.roots = line.roots;
    line.explain.roots = line.roots;
    line.inspect.roots = line.roots;
}

} // namespace limn

#include "commands/CommandLine.h"
#include "commands/DoctorCommand.h"
#include "commands/SchemaCommand.h"
#include "commands/WatchCommand.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limn/editor_stub/RunLimn.h>
#include <limn/vulkan/VulkanError.h>
#include <new>

namespace limn
{

namespace
{

constexpr const char* k_ExitCodes =
    "Results go to stdout, everything else to stderr.\n"
    "Exit codes: 0 done, 1 the input is bad, 2 wrong usage, 3 the machine lacks something.";

/// CLI11 alone would only say that a verb is missing.
std::string UnknownVerb(std::span<const std::string> args, const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* verb : app.get_subcommands({}))
    {
        names.push_back(verb->get_name());
    }
    const bool isVerb = args.empty() || args[0].starts_with('-') ||
                        std::find(names.begin(), names.end(), args[0]) != names.end();
    return isVerb ? std::string()
                  : "unknown verb " + UnknownName(args[0], {names.begin(), names.end()});
}

/// Parses the arguments and runs the verb; errors come as exceptions.
int ParseAndRun(std::span<const std::string> args, Console& console, std::ostream& err)
{
    CommandLine line;
    CLI::App app("limn renders scenes as Unity's URP 14 does, without Unity.", "limn");
    app.footer(k_ExitCodes);
    app.set_version_flag("--version", "limn " LIMN_VERSION);
    app.require_subcommand(1);
    const CLI::App* render = AddRender(app, line);
    const CLI::App* watch = AddWatch(app, line);
    const CLI::App* inspect = AddInspect(app, line);
    const CLI::App* explain = AddExplain(app, line);
    const CLI::App* set = AddSet(app, line);
    const CLI::App* schema = AddSchema(app, line);
    const CLI::App* shader = AddShader(app, line);
    AddDoctor(app, line);
    if (const std::string problem = UnknownVerb(args, app); !problem.empty())
    {
        console.Error(problem);
        return static_cast<int>(ExitCode::WrongUsage);
    }
    try
    {
        app.parse(std::vector<std::string>(args.rbegin(), args.rend()));
    }
    catch (const CLI::ParseError& error)
    {
        return app.exit(error, console.out(), err) == 0 ? static_cast<int>(ExitCode::Done)
                                                        : static_cast<int>(ExitCode::WrongUsage);
    }
    FinishOptions(line);
    return render->parsed()    ? RunRender(line.render, console)
           : watch->parsed()   ? RunWatch(line.render, console)
           : inspect->parsed() ? RunInspect(line.inspect, console)
           : explain->parsed() ? RunExplain(line.explain, console)
           : set->parsed()     ? RunSet(line.set)
           : schema->parsed()  ? RunSchema(line.schemaKind, console)
           : shader->parsed()  ? RunShader(line.shader, console)
                               : RunDoctor(line.doctorDevice, console);
}

/// Results that did not all go out are as good as none.
int CheckResults(int exitCode, Console& console)
{
    if (console.out().flush())
    {
        return exitCode;
    }
    console.Error("the results cannot be written to standard output: its disk is full, or nobody "
                  "reads it");
    return static_cast<int>(ExitCode::MachineLacksIt);
}

} // namespace

int RunLimn(std::span<const std::string> args, std::ostream& out, std::ostream& err)
{
    Console console(out, err);
    try
    {
        return CheckResults(ParseAndRun(args, console, err), console);
    }
    catch (const std::bad_alloc&)
    {
        console.Error("there is not enough memory");
        return static_cast<int>(ExitCode::MachineLacksIt);
    }
    catch (const AssetError& error)
    {
        console.Print(error.diagnostics());
        return static_cast<int>(ExitCode::BadInput);
    }
    catch (const VulkanError& error)
    {
        console.Error(error.what());
        return static_cast<int>(ExitCode::MachineLacksIt);
    }
    catch (const std::exception& error)
    {
        console.Error(error.what());
        return static_cast<int>(ExitCode::BadInput);
    }
}

} // namespace limn

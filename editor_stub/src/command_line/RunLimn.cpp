#include "command_line/Checks.h"
#include "command_line/CommandLine.h"
#include "command_line/Help.h"
#include "command_line/OptionText.h"
#include "command_line/UsageProblem.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <limn/base/TerminalText.h>
#include <limn/core/Debug.h>
#include <limn/core/DrawError.h>
#include <limn/editor_stub/RunLimn.h>
#include <limn/features/Version.h>
#include <limn/vulkan/VulkanError.h>
#include <new>

namespace limn
{

namespace
{

/// Prints what features say by Debug::Log outside of a frame. What they say within one is among its
/// notes.
class FeatureLog
{
public:
    explicit FeatureLog(Console& console)
    {
        s_Console = &console;
        SetLogSink(&Print);
    }
    ~FeatureLog()
    {
        SetLogSink(nullptr);
        s_Console = nullptr;
    }
    FeatureLog(const FeatureLog&) = delete;
    FeatureLog& operator=(const FeatureLog&) = delete;

private:
    static void Print(const LogMessage& message)
    {
        if (message.isNoted)
        {
            return;
        }
        message.type == LogType::Log ? s_Console->Note(message.text)
                                     : s_Console->Warning(message.text);
    }

    static inline Console* s_Console = nullptr;
};

int WrongUsage(const std::string& problem, const CLI::App& app, Console& console)
{
    console.Error(Sentence(problem));
    const CLI::App& verb = ParsedVerb(app);
    const std::string name = &verb == &app ? "" : " " + verb.get_name();
    console.Line("usage: " + UsageText(verb) + "; see 'limn help" + name + "'");
    return static_cast<int>(ExitCode::WrongUsage);
}

/// Returns whether the text names a file or a folder that exists.
bool isThere(const std::string& text)
{
    std::error_code ignored;
    return std::filesystem::exists(text, ignored);
}

/// Gives each of several packages behind one --package a flag of its own. CLI11 would take files
/// for packages as well: a folder counts as one only behind a file.
std::vector<std::string> SplitPackages(std::span<const std::string> args)
{
    std::vector<std::string> split;
    bool isPackages = false; // the words before are a flag and its packages
    bool hasFile = false;
    for (const std::string& arg : args)
    {
        const bool isMore = isPackages && split.back() != "--package" &&
                            (arg.find('=') != arg.npos || (hasFile && isThere(arg))) &&
                            !arg.starts_with("-") && !ReadPackages(arg).empty();
        if (isMore)
        {
            split.emplace_back("--package");
        }
        isPackages = arg == "--package" || isMore ||
                     (isPackages && !split.empty() && split.back() == "--package");
        hasFile = hasFile || (!isPackages && isThere(arg));
        split.push_back(arg);
    }
    return split;
}

/// Reads the arguments into the command line that was made with the app.
/// @return what is wrong with them; "" if nothing is
/// @throws CLI::Success where only help or the version is asked for
std::string ParseArguments(std::span<const std::string> args, CLI::App& app)
{
    const std::string problem = ProblemBeforeVerb(args, app);
    if (!problem.empty())
    {
        return problem;
    }
    try
    {
        std::vector<std::string> split = SplitPackages(args);
        std::ranges::reverse(split); // as CLI11 has it
        app.parse(std::move(split));
    }
    catch (const CLI::Success&)
    {
        throw;
    }
    catch (const CLI::ParseError& error)
    {
        return ProblemOf(app, &error);
    }
    return ProblemOf(app, nullptr);
}

/// Parses the arguments and runs the verb; errors come as exceptions.
int ParseAndRun(std::span<const std::string> args, Console& console)
{
    const auto print = [&console](const std::string& text)
    {
        console.out() << text;
        return static_cast<int>(ExitCode::Done);
    };
    CommandLine line;
    CLI::App app("limn renders scenes as Unity's URP 14 does, without Unity.", "limn");
    app.set_version_flag("-V,--version", "limn " LIMN_VERSION_TEXT, "Print the version");
    app.require_subcommand(1);
    app.fallthrough();
    app.allow_extras(); // ProblemOf names them
    AddEverything(app, line);
    try
    {
        if (args.empty())
        {
            throw CLI::CallForHelp();
        }
        const std::string problem = ParseArguments(args, app);
        console.Configure(ConsoleOptionsOf(app));
        if (!problem.empty())
        {
            return WrongUsage(problem, app, console);
        }
    }
    catch (const CLI::CallForHelp&)
    {
        return print(HelpText(ParsedVerb(app), TerminalWidth(console.out())));
    }
    catch (const CLI::CallForVersion&)
    {
        return print(app.version() + "\n");
    }
    std::error_code error;
    if (std::filesystem::current_path(error).empty())
    {
        if (error != std::errc::no_such_file_or_directory)
        {
            throw std::system_error(error, "the working directory");
        }
        console.Error("the working directory is not there any more; change into one that is");
        return static_cast<int>(ExitCode::MachineLacksIt);
    }
    FinishOptions(line);
    return line.run(console);
}

ExitCode NoMemory(Console& console)
{
    console.Error("there is not enough memory");
    return ExitCode::MachineLacksIt;
}

/// Says what the exception that is being handled means.
ExitCode ExitCodeOf(Console& console)
{
    try
    {
        throw;
    }
    catch (const MachineError& error)
    {
        console.Print(error.diagnostics());
        return ExitCode::MachineLacksIt;
    }
    catch (const AssetError& error)
    {
        console.Print(error.diagnostics());
        return ExitCode::BadInput;
    }
    catch (const DrawError& error)
    {
        console.Error(error.what());
        return ExitCode::BadInput;
    }
    catch (const std::filesystem::filesystem_error& error)
    {
        if (error.code() == std::errc::not_enough_memory)
        {
            return NoMemory(console);
        }
        console.Print({Severity::Error, error.path1().string(), {}, error.code().message()});
        return ExitCode::BadInput;
    }
    catch (const VulkanError& error)
    {
        console.Error(error.what());
        return ExitCode::MachineLacksIt;
    }
    catch (const std::bad_alloc&)
    {
        return NoMemory(console);
    }
    catch (const std::system_error& error)
    {
        if (error.code() == std::errc::not_enough_memory)
        {
            return NoMemory(console);
        }
        console.Error(error.what());
        return ExitCode::MachineLacksIt;
    }
    catch (const std::exception& error)
    {
        console.Bug(error.what());
    }
    catch (...)
    {
        console.Bug("an exception without a name");
    }
    return ExitCode::Bug;
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
    const FeatureLog log(console);
    try
    {
        return CheckResults(ParseAndRun(args, console), console);
    }
    catch (...)
    {
        return static_cast<int>(ExitCodeOf(console));
    }
}

} // namespace limn

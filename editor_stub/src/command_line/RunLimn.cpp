#include "command_line/FlagTable.h"

#include <filesystem>
#include <limn/core/Debug.h>
#include <limn/core/DrawError.h>
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
        SetLogSink(
            [](const LogMessage& message)
            {
                if (!message.isNoted)
                {
                    message.type == LogType::Log ? s_Console->Note(message.text)
                                                 : s_Console->Warning(message.text);
                }
            });
    }
    ~FeatureLog() { SetLogSink(nullptr); }
    FeatureLog(const FeatureLog&) = delete;
    FeatureLog& operator=(const FeatureLog&) = delete;

private:
    static inline Console* s_Console = nullptr;
};

ExitCode NoMemory(Console& console)
{
    console.Error("there is not enough memory");
    return ExitCode::MachineLacksIt;
}

/// Prints the message of the exception that is being handled, and returns its exit code.
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
        // Tools that read the messages get a line each.
        console.isOnTerminal() ? console.PrintWithSource(error.diagnostics())
                               : console.Print(error.diagnostics());
        return ExitCode::BadInput;
    }
    catch (const DrawError& error)
    {
        console.Error(error.what());
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
        if (const auto* ofFile = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
        {
            console.Print({Severity::Error, ofFile->path1().string(), {}, error.code().message()});
            return ExitCode::BadInput;
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
ExitCode CheckResults(ExitCode exitCode, Console& console)
{
    console.ShowCollected();
    if (console.out().flush())
    {
        return exitCode;
    }
    console.Error("the results cannot be written to standard output: its disk is full, or nobody "
                  "reads it");
    return ExitCode::MachineLacksIt;
}

} // namespace

int RunLimn(std::span<const std::string> args, std::ostream& out, std::ostream& err)
{
    Console console(out, err);
    const FeatureLog log(console);
    try
    {
        return static_cast<int>(CheckResults(RunCommandLine(args, console), console));
    }
    catch (...)
    {
        console.ShowCollected(); // what was found before goes in front of the error
        return static_cast<int>(ExitCodeOf(console));
    }
}

} // namespace limn

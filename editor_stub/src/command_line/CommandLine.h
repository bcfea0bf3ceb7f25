#pragma once

#include "command_line/SelectionOptions.h"
#include "commands/ExplainCommand.h"
#include "commands/InspectCommand.h"
#include "commands/NewCommand.h"
#include "commands/PortCommand.h"
#include "commands/RenderCommand.h"
#include "commands/ReportCommand.h"
#include "commands/SetCommand.h"
#include "commands/ShaderCommand.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace limn
{

/// What the verbs' options are read into.
struct CommandLine
{
    RenderOptions render;
    ShaderOptions shader;
    ExplainOptions explain;
    InspectOptions inspect;
    SetOptions set;
    ReportCommandOptions report;
    NewOptions newFeature;
    PortOptions port;
    std::string newKind;
    std::string schemaKind;
    std::string doctorDevice;
    std::string helpVerb; ///< "": of limn itself
    std::string completionShell;
    std::string size;
    std::string color;
    SelectionTexts selection;
    bool isQuiet = false;
    bool isVerbose = false;
    std::vector<std::string> packages;
    std::vector<std::string> plugins;
    std::vector<std::string> roots;
    std::function<int(Console&)> run; ///< the verb that was chosen, once it was parsed
};

/// Adds the verbs and the options of every verb, which are read into `line`; that must outlive
/// `app`.
void AddEverything(CLI::App& app, CommandLine& line);

/// What the options of every verb say, also where parsing failed.
ConsoleOptions ConsoleOptionsOf(const CLI::App& app);

/// Makes of the texts that were read what the verbs take.
void FinishOptions(CommandLine& line);

} // namespace limn

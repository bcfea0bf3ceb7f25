#pragma once

#include "commands/ExplainCommand.h"
#include "commands/InspectCommand.h"
#include "commands/RenderCommand.h"
#include "commands/SetCommand.h"
#include "commands/ShaderCommand.h"

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
    std::string schemaKind;
    std::string doctorDevice;
    std::string size;
    std::vector<std::string> packages;
    std::vector<std::string> roots;
};

// Each adds a verb with its options, which are read into `line`; that must outlive `app`.

CLI::App* AddRender(CLI::App& app, CommandLine& line);
CLI::App* AddWatch(CLI::App& app, CommandLine& line);
CLI::App* AddInspect(CLI::App& app, CommandLine& line);
CLI::App* AddExplain(CLI::App& app, CommandLine& line);
CLI::App* AddSet(CLI::App& app, CommandLine& line);
CLI::App* AddSchema(CLI::App& app, CommandLine& line);
CLI::App* AddShader(CLI::App& app, CommandLine& line);
CLI::App* AddDoctor(CLI::App& app, CommandLine& line);

/// Makes of the texts that were read what the verbs take.
void FinishOptions(CommandLine& line);

} // namespace limn

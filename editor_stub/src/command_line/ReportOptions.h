#pragma once

#include "commands/ReportCommand.h"

namespace CLI
{
class App;
}

namespace limn
{

/// Adds what only `limn report` takes.
/// @param options  must outlive `verb`
void AddReportOptions(CLI::App& verb, ReportCommandOptions& options);

} // namespace limn

#pragma once

#include "commands/ReportCommand.h"

namespace CLI
{
class App;
}

namespace limn
{

/// Adds what only `limn report` takes.
/// @param scene, options  must outlive `verb`
void AddReportOptions(CLI::App& verb, std::string& scene, ReportCommandOptions& options);

/// What is missing on a parsed command line, "" if nothing is.
std::string ReportUsageProblem(const CLI::App& verb);

} // namespace limn

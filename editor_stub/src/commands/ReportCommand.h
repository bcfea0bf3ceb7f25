#pragma once

#include "commands/Commands.h"

namespace limn
{

/// `limn report`, as the command line has it.
struct ReportCommandOptions
{
    std::vector<std::string> paths; ///< the scene, or folders of studies
    std::string output;             ///< the study's folder
    bool isQuick = false;
    bool isFull = false; ///< every combination of extreme inputs
    bool hasStability = false;
    std::vector<std::string> techniques;
    double budget = 0.0; ///< milliseconds; 0 = none
    int shard = 1;       ///< 1...shards
    int shards = 1;
    bool isMerge = false;
    bool isCompare = false;
};

/// Measures the error and the cost of outline techniques in a scene, and writes a report.
/// @param render  the picture's size, the device, caches, packages and roots
/// @return an ExitCode: BadInput if merged parts lack cells, or compared ones differ
/// @throws AssetError, VulkanError; what was measured until then stays in the folder
int RunReport(RenderOptions render, const ReportCommandOptions& options, Console& console);

} // namespace limn

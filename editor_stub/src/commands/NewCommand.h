#pragma once

#include "console/Console.h"

#include <string>

namespace limn
{

/// `limn new feature`, as the command line has it.
struct NewOptions
{
    std::string name;
    std::string folder; ///< made, if it is not there
    std::string style;  ///< urp14 ("" as well): Execute; unity6: RecordRenderGraph
};

/// Writes the folder of a render feature that builds and draws at once: component, feature, pass,
/// shader, scene, test.
/// @return an ExitCode: WrongUsage for a name that cannot be a class
/// @throws AssetError if a file cannot be written, or the folder is not empty
int RunNew(const NewOptions& options, Console& console);

} // namespace limn

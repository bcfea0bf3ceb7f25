#pragma once

#include <string>

namespace CLI
{
class App;
}

namespace limn
{

/// What `limn help` or `limn help VERB` prints.
/// @param width  columns that a line may have
std::string HelpText(const CLI::App& app, std::size_t width);

} // namespace limn

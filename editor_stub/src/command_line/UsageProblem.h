#pragma once

#include <span>
#include <string>

namespace CLI
{
class App;
class ParseError;
} // namespace CLI

namespace limn
{

// What is wrong with a command line, in a sentence that names the wrong word; "" if nothing is.

/// Before it is parsed: an option of limn's own or a verb that there is not.
std::string ProblemBeforeVerb(std::span<const std::string> args, const CLI::App& app);

/// After it was parsed, which gave `error` or, if that is null, went well.
std::string ProblemOf(const CLI::App& app, const CLI::ParseError* error);

/// "unknown verb 'rendr'; did you mean 'render'?"
std::string UnknownVerb(const std::string& name, const CLI::App& app);

/// The verb that was parsed; `app` itself without one.
const CLI::App& ParsedVerb(const CLI::App& app);

} // namespace limn

#pragma once

#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace limn
{

// How the definition of the command line is told to people, in help, messages and completions.

/// "SCENE", "-o, --output FILE", "    --set NAME.path=VALUE ...".
std::string FullText(const CLI::Option& option);

/// "SCENE", "--output": what messages call it.
std::string OptionName(const CLI::Option& option);

/// "limn render SCENE -o FILE [OPTIONS]".
std::string UsageText(const CLI::App& app);

bool isRepeatable(const CLI::Option& option);
bool isFlag(const CLI::Option& option);

/// The words that may stand there, where its type lists them ("bash|zsh|fish"); else none.
std::vector<std::string> ChoicesOf(const CLI::Option& option);

/// "--output", "-o", ... of the app itself.
std::vector<std::string> SpellingsOf(const CLI::App& app);

/// The verbs' names.
std::vector<std::string> VerbNames(const CLI::App& app);

} // namespace limn

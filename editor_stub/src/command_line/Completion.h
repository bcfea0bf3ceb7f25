#pragma once

#include <string>

namespace CLI
{
class App;
}

namespace limn
{

/// A script that makes a shell complete verbs, options, and values where there are only a few;
/// other words are completed as file names.
/// @param shell  "bash", "zsh" or "fish"
std::string CompletionScript(const CLI::App& app, const std::string& shell);

} // namespace limn

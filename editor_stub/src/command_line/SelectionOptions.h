#pragma once

#include "selection/SceneSelection.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace limn
{

/// What the options are read into that change what is selected.
struct SelectionTexts
{
    std::vector<std::string> selects;
    std::vector<std::string> clicks;
    std::vector<std::string> ctrlClicks;
};

/// @param texts  must outlive the verb
void AddSelectionOptions(CLI::App& verb, SelectionTexts& texts);

/// What was given, in the order in which it was; once the verb is parsed.
std::vector<SelectionStep> SelectionStepsOf(const CLI::App& verb);

} // namespace limn

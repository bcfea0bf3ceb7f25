#include "command_line/SelectionOptions.h"

#include <CLI/CLI.hpp>
#include <map>

namespace limn
{

namespace
{

std::string CheckClick(const std::string& text)
{
    return ParseClick(text) ? std::string()
                            : "'" + text +
                                  "' is no pixel; X,Y from the top left is expected, or "
                                  "X,Y@SECONDS: 640,360";
}

} // namespace

void AddSelectionOptions(CLI::App& verb, SelectionTexts& texts)
{
    verb.add_option("--select", texts.selects,
                    "Select the objects of these names, each with what hangs below it, and no "
                    "others: they get the rendering layer that outline features look for; \"\" "
                    "selects nothing")
        ->type_name("NAME,...")
        ->allow_extra_args(false);
    verb.add_option("--click", texts.clicks,
                    "Select what is seen at this pixel, counted from the top left, as a whole, or "
                    "nothing; at time 0 or at SECONDS; after what stands before it")
        ->type_name("X,Y[@SECONDS]")
        ->allow_extra_args(false)
        ->check(CheckClick);
    verb.add_option("--ctrl-click", texts.ctrlClicks,
                    "Add what is seen at this pixel, or take it away if it is selected")
        ->type_name("X,Y[@SECONDS]")
        ->allow_extra_args(false)
        ->check(CheckClick);
}

std::vector<SelectionStep> SelectionStepsOf(const CLI::App& verb)
{
    using Kind = SelectionStep::Kind;
    const std::map<std::string, Kind> kinds{
        {"select", Kind::Select}, {"click", Kind::Click}, {"ctrl-click", Kind::CtrlClick}};
    std::map<Kind, std::size_t> counts;
    std::vector<SelectionStep> steps;
    for (const CLI::Option* option : verb.parse_order())
    {
        const std::string name = option->get_lnames().empty() ? "" : option->get_lnames().front();
        const auto kind = kinds.find(name);
        if (kind != kinds.end())
        {
            steps.push_back({kind->second, option->results().at(counts[kind->second]++)});
        }
    }
    return steps;
}

} // namespace limn

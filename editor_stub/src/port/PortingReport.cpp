#include "console/Texts.h"
#include "port/PortFolder.h"
#include "port/PortedCode.h"

#include <algorithm>
#include <filesystem>

namespace limn
{

namespace
{

constexpr std::size_t k_MostPlaces = 8;

/// Returns the text for a cell of a Markdown table.
std::string Cell(std::string_view text)
{
    std::string cell = Replaced(std::string(text), "|", "\\|");
    std::ranges::replace_if(
        cell, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return cell;
}

std::string Code(std::string_view text)
{
    return text.empty() ? "" : "`" + Cell(text) + "`";
}

/// Returns how much work a use asks of the porter.
int Weight(const UsedMember& use)
{
    return use.entry ? 3 - static_cast<int>(use.entry->verdict) : -1;
}

std::string UseRow(const UsedMember& use)
{
    return "| " + Code(use.key) + " | " + PlacesText(use.places, k_MostPlaces) + " | " +
           (use.entry ? ToString(use.entry->verdict) : "**unknown**") + " | " +
           (use.entry ? use.entry->words : use.problem) + " |\n";
}

} // namespace

std::string PlacesText(const std::vector<CSharpPlace>& places, std::size_t most)
{
    std::string text;
    const CSharpFile* file = nullptr;
    for (std::size_t i = 0; i < std::min(places.size(), most); ++i)
    {
        text += i == 0 ? "" : ", ";
        if (places[i].file != file)
        {
            file = places[i].file;
            text += std::filesystem::path(file->path).filename().string() + ":";
        }
        text += std::to_string(places[i].location.line) + ":" +
                std::to_string(places[i].location.column);
    }
    return places.size() > most ? text + " and " + std::to_string(places.size() - most) + " more"
                                : text;
}

std::string PortingReport(const PortModel& model, const std::vector<PortedThing>& things,
                          const std::vector<UsedMember>& uses)
{
    std::string text =
        "# Porting " + model.name() +
        "\n\nBodies stand as comments in the C++, each "
        "below a TODO. A row that says TODO is a comment there, too.\n\n"
        "## What the C# says of itself\n\n| | C# | | at | |\n| --- | --- | --- | --- "
        "| --- |\n";
    for (const PortedThing& thing : things)
    {
        text += "| " + thing.what + " | " + Code(thing.name) + " | " + Code(thing.text) + " | " +
                thing.place + " | " + (thing.isDone ? "done" : "TODO") + " |\n";
    }
    for (const auto& file : model.files())
    {
        for (const CSharpCondition& condition : file->tokens.conditions)
        {
            text += "| condition | " + Code("#if " + condition.text) + " | " +
                    (condition.isTrue ? "read" : "left out") + " | " +
                    PlacesText({{file.get(), condition.location}}, 1) + " | |\n";
        }
    }
    text +=
        "\n## What it uses\n\nEvery type, member and attribute, by what there is to do.\n\n| Unity "
        "| at | here | |\n| --- | --- | --- | --- |\n";
    std::vector<const UsedMember*> sorted;
    for (const UsedMember& use : uses)
    {
        sorted.push_back(&use);
    }
    std::ranges::stable_sort(sorted, {}, [](const UsedMember* use) { return Weight(*use); });
    for (const UsedMember* use : sorted)
    {
        text += UseRow(*use);
    }
    return text;
}

} // namespace limn

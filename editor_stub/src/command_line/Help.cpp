#include "command_line/Help.h"

#include "command_line/OptionText.h"

#include <CLI/CLI.hpp>

namespace limn
{

namespace
{

constexpr const char* k_ExitCodes =
    "Results go to stdout, everything else to stderr. Exit codes: 0 done, 1 the input is bad, 2 "
    "wrong usage, 3 the machine lacks something, 70 a bug in limn.";

/// Appends the words in lines of `width`, all but the first behind `indent` blanks. Help is ASCII.
void AppendWrapped(std::string& help, const std::string& words, std::size_t column,
                   std::size_t indent, std::size_t width)
{
    bool isFirst = true;
    for (const std::string& word : CLI::detail::split(words, ' '))
    {
        if (!isFirst && column + 1 + word.size() > width)
        {
            help += "\n" + std::string(indent, ' ') + word;
            column = indent + word.size();
            continue;
        }
        help += (isFirst ? "" : " ") + word;
        column += word.size() + (isFirst ? 0 : 1);
        isFirst = false;
    }
    help += "\n";
}

/// A table of two columns. What is too long for the left one has a line of its own.
class HelpTable
{
public:
    explicit HelpTable(std::size_t width) : m_Width(width) {}

    void Add(std::string left, std::string right)
    {
        m_Rows.emplace_back(std::move(left), std::move(right));
    }

    void AppendTo(std::string& help, const std::string& title) const
    {
        const std::size_t indent = m_Width < 70 ? 8 : 28;
        help += m_Rows.empty() ? "" : "\n" + title + ":\n";
        for (const auto& [left, right] : m_Rows)
        {
            help += "  " + left;
            const std::size_t end = 2 + left.size();
            const bool fits = m_Width >= 70 && end + 2 <= indent;
            help += fits ? std::string(indent - end, ' ') : "\n" + std::string(indent, ' ');
            AppendWrapped(help, right, indent, indent, m_Width);
        }
    }

private:
    std::size_t m_Width;
    std::vector<std::pair<std::string, std::string>> m_Rows;
};

void AppendOptions(std::string& help, const CLI::App& app, bool arePositional, std::size_t width,
                   const std::string& title)
{
    HelpTable table(width);
    for (const CLI::Option* option : app.get_options())
    {
        // A verb's own --help is listed with what every verb has.
        const bool isRepeated = app.get_parent() && option == app.get_help_ptr();
        if (option->get_positional() == arePositional && !isRepeated)
        {
            table.Add(FullText(*option), option->get_description());
        }
    }
    table.AppendTo(help, title);
}

} // namespace

std::string HelpText(const CLI::App& app, std::size_t width)
{
    std::string help;
    AppendWrapped(help, app.get_description(), 0, 0, width);
    help += "\n";
    AppendWrapped(help, "usage: " + UsageText(app), 0, 8, width);
    AppendOptions(help, app, true, width, "arguments");
    HelpTable verbs(width);
    for (const CLI::App* verb : app.get_subcommands({}))
    {
        verbs.Add(verb->get_name(), verb->get_description());
    }
    verbs.AppendTo(help, "verbs");
    AppendOptions(help, app, false, width, "options");
    if (app.get_parent())
    {
        AppendOptions(help, *app.get_parent(), false, width, "options of every verb");
    }
    else
    {
        help += "\n";
        AppendWrapped(help, k_ExitCodes, 0, 0, width);
    }
    return help;
}

} // namespace limn

#include "command_line/OptionText.h"

#include <CLI/CLI.hpp>

namespace limn
{

std::string FullText(const CLI::Option& option)
{
    std::string text = option.get_type_name();
    if (!option.get_positional())
    {
        const bool hasShort = !option.get_snames().empty();
        text = (hasShort ? "-" + option.get_snames().front() + ", " : std::string(4, ' ')) + "--" +
               option.get_lnames().front() + (isFlag(option) ? "" : " " + text);
    }
    return text + (isRepeatable(option) ? " ..." : "");
}

std::string OptionName(const CLI::Option& option)
{
    return option.get_positional() ? option.get_type_name() : option.get_name();
}

std::string UsageText(const CLI::App& app)
{
    if (!app.get_parent())
    {
        return app.get_name() + " VERB [OPTIONS]";
    }
    std::string text = app.get_parent()->get_name() + " " + app.get_name();
    for (const CLI::Option* option : app.get_options())
    {
        if (option->get_positional())
        {
            text +=
                " " + (option->get_required() ? FullText(*option) : "[" + FullText(*option) + "]");
        }
    }
    for (const CLI::Option* option : app.get_options())
    {
        if (!option->get_positional() && option->get_required())
        {
            text += " -" + option->get_snames().front() + " " + option->get_type_name();
        }
    }
    return text + " [OPTIONS]";
}

bool isRepeatable(const CLI::Option& option)
{
    return option.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

bool isFlag(const CLI::Option& option)
{
    return option.get_items_expected_max() == 0;
}

std::vector<std::string> ChoicesOf(const CLI::Option& option)
{
    const std::string type = option.get_type_name();
    const bool isList =
        type.find('|') != std::string::npos &&
        std::none_of(type.begin(), type.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    return isList ? CLI::detail::split(type, '|') : std::vector<std::string>();
}

std::vector<std::string> SpellingsOf(const CLI::App& app)
{
    std::vector<std::string> spellings;
    for (const CLI::Option* option : app.get_options())
    {
        for (const std::string& name : option->get_lnames())
        {
            spellings.push_back("--" + name);
        }
        for (const std::string& name : option->get_snames())
        {
            spellings.push_back("-" + name);
        }
    }
    return spellings;
}

std::vector<std::string> VerbNames(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* verb : app.get_subcommands({}))
    {
        names.push_back(verb->get_name());
    }
    return names;
}

} // namespace limn

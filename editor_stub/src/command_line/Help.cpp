#include "command_line/FlagTable.h"

namespace limn
{

namespace
{

using Rows = std::vector<std::pair<std::string, std::string>>;

constexpr const char* k_ExitCodes =
    "Results go to stdout, everything else to stderr. Exit codes: 0 done, 1 the input is bad, 2 "
    "wrong usage, 3 the machine lacks something, 70 a bug in limn.";

/// The words in lines of `width`, all but the first behind `indent` blanks. Help is ASCII.
/// @param column  where the first line begins
std::string Wrapped(const std::string& words, std::size_t column, std::size_t indent,
                    std::size_t width)
{
    std::string text;
    for (const std::string& word : SplitText(words, ' '))
    {
        const bool fits = text.empty() || column + 1 + word.size() <= width;
        text += !fits ? "\n" + std::string(indent, ' ') : text.empty() ? "" : " ";
        column = !fits ? indent : column + (text.empty() ? 0 : 1);
        text += word;
        column += word.size();
    }
    return text + "\n";
}

/// Two columns. What is too long for the left one has a line of its own.
std::string TableText(const std::string& title, const Rows& rows, std::size_t width)
{
    const std::size_t indent = width < 70 ? 8 : 28;
    std::string text = rows.empty() ? "" : "\n" + title + ":\n";
    for (const auto& [left, right] : rows)
    {
        const std::size_t end = 2 + left.size();
        const bool fits = width >= 70 && end + 2 <= indent;
        text += "  " + left + (fits ? "" : "\n") + std::string(fits ? indent - end : indent, ' ') +
                Wrapped(right, indent, indent, width);
    }
    return text;
}

Rows RowsOf(const Verb& verb, bool areArguments)
{
    Rows rows;
    for (const Flag& flag : verb.flags)
    {
        if (flag.isArgument() == areArguments)
        {
            rows.emplace_back(flag.FullText(), flag.help);
        }
    }
    return rows;
}

} // namespace

std::string UsageText(const FlagTable& table, const Verb& verb)
{
    std::string text = &verb == &table.limn ? "limn VERB" : "limn " + verb.name;
    for (const Flag& flag : verb.flags)
    {
        const std::string place = flag.isArgument() ? flag.FullText() : flag.ShortText();
        text += flag.isRequired() ? " " + place : flag.isArgument() ? " [" + place + "]" : "";
    }
    return text + " [OPTIONS]";
}

std::string HelpText(const FlagTable& table, const Verb& verb, std::size_t width)
{
    const std::string text = Wrapped(verb.help, 0, 0, width) + "\n" +
                             Wrapped("usage: " + UsageText(table, verb), 0, 8, width) +
                             TableText("arguments", RowsOf(verb, true), width);
    const std::string options = TableText("options", RowsOf(verb, false), width);
    if (&verb != &table.limn)
    {
        return text + options +
               TableText("options of every verb", RowsOf(table.limn, false), width);
    }
    Rows verbs;
    for (const Verb& each : table.verbs)
    {
        verbs.emplace_back(each.name, each.help);
    }
    return text + TableText("verbs", verbs, width) + options + "\n" +
           Wrapped(k_ExitCodes, 0, 0, width);
}

} // namespace limn

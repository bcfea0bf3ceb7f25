#include "command_line/FlagTable.h"

#include "console/FitLines.h"
#include "console/Texts.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/features/Version.h>

namespace limn
{

namespace
{

using Rows = std::vector<std::pair<std::string, std::string>>;

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

/// A line of text as troff takes it: with its backslashes and hyphens, and not as a request.
std::string TroffLine(const std::string& text)
{
    std::string line = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
    for (const char c : text)
    {
        line += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return line + "\n";
}

std::string TroffFlags(const std::vector<Flag>& flags)
{
    std::string text;
    for (const Flag& flag : flags)
    {
        const std::string name = flag.FullText();
        text +=
            ".TP\n.B " + TroffLine(name.substr(name.find_first_not_of(' '))) + TroffLine(flag.help);
    }
    return text;
}

} // namespace

std::string Flag::Words() const
{
    const bool areWords = std::ranges::none_of(value, [](char c) { return c >= 'A' && c <= 'Z'; });
    std::string words = areWords ? value : "";
    std::ranges::replace(words, '|', ' ');
    return words;
}

std::vector<std::string> Flag::Spellings() const
{
    return letter == '\0' ? std::vector{Name()} : std::vector{Name(), std::string("-") + letter};
}

std::string Flag::Name() const
{
    return isArgument() ? value : "--" + name;
}

std::string Flag::ShortText() const
{
    return isArgument() ? value : Spellings().back() + " " + value;
}

std::string Flag::FullText() const
{
    const std::string start = letter == '\0' ? "    " : Spellings().back() + ", ";
    return (isArgument() ? value : start + Name() + (value.empty() ? "" : " " + value)) +
           (isRepeatable() ? " ..." : "");
}

const Verb* FlagTable::Find(const std::string& verb) const
{
    const auto found = std::ranges::find(verbs, verb, &Verb::name);
    return found == verbs.end() ? nullptr : &*found;
}

std::string FlagTable::VerbNames() const
{
    return Joined(verbs, " ", &Verb::name);
}

std::vector<const Flag*> FlagTable::FlagsOf(const Verb& verb) const
{
    std::vector<const Flag*> flags;
    for (const Verb* each : {&verb, &limn})
    {
        for (const Flag& flag : each->flags)
        {
            if (!flag.isArgument() && std::ranges::find(flags, &flag) == flags.end())
            {
                flags.push_back(&flag);
            }
        }
    }
    return flags;
}

std::string CheckWord(const std::string& kind, const std::string& word, const std::string& known)
{
    const std::vector<std::string> words = SplitText(known, ' ');
    return std::ranges::count(words, word) > 0
               ? ""
               : "unknown " + kind + " " + UnknownName(word, {words.begin(), words.end()});
}

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
    std::ranges::transform(table.verbs, std::back_inserter(verbs),
                           [](const Verb& each) { return std::pair(each.name, each.help); });
    return text + TableText("verbs", verbs, width) + options + "\n" +
           Wrapped(k_ExitCodes, 0, 0, width);
}

std::string ManPage(const FlagTable& table)
{
    std::string text = ".TH LIMN 1 \"\" \"limn " LIMN_VERSION_TEXT "\" \"User Commands\"\n"
                       ".SH NAME\nlimn \\- draw scenes as Unity's render pipeline does\n"
                       ".SH SYNOPSIS\n.B " +
                       TroffLine(UsageText(table, table.limn)) + ".SH DESCRIPTION\n" +
                       TroffLine(table.limn.help) + ".SH VERBS\n";
    for (const Verb& verb : table.verbs)
    {
        text += ".SS " + TroffLine(UsageText(table, verb)) + TroffLine(verb.help + ".") +
                TroffFlags(verb.flags);
    }
    return text + ".SH OPTIONS OF EVERY VERB\n" + TroffFlags(table.limn.flags) +
           ".SH EXIT STATUS\n" + TroffLine(k_ExitCodes);
}

} // namespace limn

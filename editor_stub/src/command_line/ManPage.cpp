#include "command_line/FlagTable.h"

#include <limn/features/Version.h>

namespace limn
{

namespace
{

/// A line of text as troff takes it: with its backslashes and hyphens, and not as a request.
std::string Line(const std::string& text)
{
    std::string line = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
    for (const char c : text)
    {
        line += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return line + "\n";
}

std::string FlagLines(const std::vector<Flag>& flags)
{
    std::string text;
    for (const Flag& flag : flags)
    {
        const std::string name = flag.FullText();
        text += ".TP\n.B " + Line(name.substr(name.find_first_not_of(' '))) + Line(flag.help);
    }
    return text;
}

} // namespace

std::string ManPage(const FlagTable& table)
{
    std::string text = ".TH LIMN 1 \"\" \"limn " LIMN_VERSION_TEXT "\" \"User Commands\"\n"
                       ".SH NAME\nlimn \\- draw scenes as Unity's render pipeline does\n"
                       ".SH SYNOPSIS\n.B " +
                       Line(UsageText(table, table.limn)) + ".SH DESCRIPTION\n" +
                       Line(table.limn.help) + ".SH VERBS\n";
    for (const Verb& verb : table.verbs)
    {
        text +=
            ".SS " + Line(UsageText(table, verb)) + Line(verb.help + ".") + FlagLines(verb.flags);
    }
    return text + ".SH OPTIONS OF EVERY VERB\n" + FlagLines(table.limn.flags) +
           ".SH EXIT STATUS\n" + Line(k_ExitCodes);
}

} // namespace limn

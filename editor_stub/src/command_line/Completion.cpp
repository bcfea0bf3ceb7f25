#include "command_line/FlagTable.h"

#include "console/Texts.h"

#include <exception>
#include <limn/base/EmbeddedFile.h>
#include <limn/base/TerminalText.h>

namespace limn
{

namespace embedded
{
// Bash makes words of their own of '=' and ':', which its script puts together again. What is
// offered must then lack what stands before the last of them, and have its blanks quoted unless the
// person has begun with a quote.
std::span<const EmbeddedFile> CompletionScripts();
} // namespace embedded

namespace
{

/// Returns a line for each candidate that begins as the word does, with `before` in front.
std::string LinesOf(const std::vector<std::string>& candidates, const std::string& word,
                    const std::string& before = "")
{
    std::string text;
    for (const std::string& candidate : candidates)
    {
        text += candidate.starts_with(word) ? before + OneLine(candidate) + "\n" : "";
    }
    return text;
}

/// Returns the lines of what the flag's value may be; none if a file that must be read for them is
/// wrong, as a person who is typing is not told yet.
std::string ValuesOf(const Flag& flag, const std::string& word, const std::string& before = "")
{
    const std::string words = flag.Words();
    if (!words.empty())
    {
        return LinesOf(SplitText(words, ' '), word, before);
    }
    try
    {
        return flag.candidates ? LinesOf(flag.candidates(word), word, before) : "";
    }
    catch (const std::exception&)
    {
        return "";
    }
}

/// Returns the first part of a help text; a list has room for no more.
std::string Brief(const std::string& help)
{
    return help.substr(0, help.find_first_of(";:"));
}

std::string VerbLines(const FlagTable& table, const std::string& word)
{
    std::string text;
    for (const Verb& verb : table.verbs)
    {
        text += verb.name.starts_with(word) ? verb.name + "\t" + Brief(verb.help) + "\n" : "";
    }
    return text;
}

std::string FlagLines(const FlagTable& table, const Verb& verb, const std::string& word)
{
    std::string text;
    for (const Flag* flag : table.FlagsOf(verb))
    {
        for (const std::string& spelling : flag->Spellings())
        {
            const bool isWanted = spelling.starts_with(word) && (spelling.size() > 2 || word != "");
            text += isWanted ? spelling + "\t" + Brief(flag->help) + "\n" : "";
        }
    }
    return text;
}

} // namespace

std::string CompletionText(const FlagTable& table, std::span<const std::string> words)
{
    const std::string& word = words.back();
    const ParsedFlags before = ParseFlags(words.first(words.size() - 1), table);
    const bool isFlag = word.starts_with('-');
    const std::size_t equals = word.find('=');
    if (before.next && !before.next->isArgument())
    {
        return ValuesOf(*before.next, word);
    }
    if (isFlag && equals != std::string::npos)
    {
        const std::vector<const Flag*> flags = table.FlagsOf(*before.verb);
        const auto flag = std::ranges::find(flags, word.substr(0, equals), &Flag::Name);
        return flag == flags.end()
                   ? ""
                   : ValuesOf(**flag, word.substr(equals + 1), word.substr(0, equals + 1));
    }
    if (isFlag || (!before.next && before.verb != &table.limn))
    {
        return FlagLines(table, *before.verb, word);
    }
    return before.next ? ValuesOf(*before.next, word) : VerbLines(table, word);
}

std::string CompletionScript(const std::string& shell)
{
    const auto scripts = embedded::CompletionScripts();
    return std::string(std::ranges::find(scripts, "limn." + shell, &EmbeddedFile::path)->text);
}

} // namespace limn

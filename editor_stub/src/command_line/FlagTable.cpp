#include "command_line/FlagTable.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>

namespace limn
{

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
    std::string names;
    for (const Verb& verb : verbs)
    {
        names += (names.empty() ? "" : " ") + verb.name;
    }
    return names;
}

std::vector<const Flag*> FlagTable::FlagsOf(const Verb& verb) const
{
    std::vector<const Flag*> flags;
    for (const Verb* each : {&verb, &limn})
    {
        for (const Flag& flag : each->flags)
        {
            if (!flag.isArgument())
            {
                flags.push_back(&flag);
            }
        }
    }
    return flags;
}

std::vector<std::string> SplitText(const std::string& text, char separator)
{
    std::vector<std::string> parts;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1)
    {
        end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end - begin));
    }
    return parts;
}

std::string CheckWord(const std::string& kind, const std::string& word, const std::string& known)
{
    const std::vector<std::string> words = SplitText(known, ' ');
    return std::ranges::count(words, word) > 0
               ? ""
               : "unknown " + kind + " " + UnknownName(word, {words.begin(), words.end()});
}

} // namespace limn

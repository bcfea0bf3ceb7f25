#include "command_line/FlagTable.h"

#include "console/Texts.h"

#include <exception>
#include <limn/base/TerminalText.h>

namespace limn
{

namespace
{

// Bash makes words of their own of '=' and ':', which are put together again. What is offered must
// then lack what stands before the last of them, and have its blanks quoted unless the person has
// begun with a quote.
constexpr const char* k_Bash = R"sh(_limn()
{
    local words=() word typed line i
    for ((i = 1; i <= COMP_CWORD; i++)); do
        word=${COMP_WORDS[i]}
        [[ $word == [\"\']* ]] && word=${word:1}
        word=${word//\\/}
        if ((i > 1)) && [[ ${COMP_WORDS[i]} == [=:]* || ${COMP_WORDS[i - 1]} == *[=:] ]]; then
            words[${#words[@]} - 1]+=$word
        else
            words+=("$word")
        fi
    done
    typed=$word
    [[ $typed == [=:]* ]] && typed=
    local before=${words[${#words[@]} - 1]%"$typed"}
    local limn=${BASH_ALIASES[${COMP_WORDS[0]}]:-${COMP_WORDS[0]}}
    limn=${limn/#\~/$HOME}
    COMPREPLY=()
    while IFS= read -r line; do
        line=${line%%$'\t'*}
        line=${line#"$before"}
        [[ ${COMP_WORDS[COMP_CWORD]} == [\"\']* || $line != *[\ \'\"\(\)\&]* ]] ||
            printf -v line %q "$line"
        COMPREPLY+=("$line")
    done < <("$limn" complete -- "${words[@]}" 2>/dev/null)
    # A folder, a component and a parameter go on.
    [[ ${#COMPREPLY[@]} != 1 || $COMPREPLY != *[/.=] ]] || compopt -o nospace 2>/dev/null
}
complete -o default -F _limn limn
)sh";

constexpr const char* k_Zsh = R"sh(#compdef limn
_limn()
{
    local -a lines ends opens
    local line
    lines=("${(@f)$("${(Q)words[1]/#\~/$HOME}" complete -- "${(@Q)words[2,CURRENT]}" 2>/dev/null)}")
    for line in $lines; do
        # A folder, a component and a parameter go on.
        case $line in
            *[/.=]) opens+=("$line") ;;
            *$'\t'*) ends+=("${${line%%$'\t'*}//:/\\:}:${line#*$'\t'}") ;;
            *) ends+=("${line//:/\\:}") ;;
        esac
    done
    if (( $#ends + $#opens == 0 )); then
        _files
        return
    fi
    (( $#opens )) && compadd -S '' -a opens
    (( $#ends )) && _describe value ends
}
# It is sourced, or it is the body of a function that zsh loads at the first Tab.
if [ "$funcstack[1]" = _limn ]; then _limn; else compdef _limn limn; fi
)sh";

constexpr const char* k_Fish = R"sh(function __limn_complete
    set -l words (commandline -opc)
    set -l found ($words[1] complete -- $words[2..] (commandline -ct) 2>/dev/null)
    if test (count $found) -gt 0
        printf '%s\n' $found
    else
        __fish_complete_path (commandline -ct)
    end
end
complete -c limn -f -a '(__limn_complete)'
)sh";

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
    return shell == "bash" ? k_Bash : shell == "zsh" ? k_Zsh : k_Fish;
}

} // namespace limn

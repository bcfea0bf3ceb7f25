#include "command_line/FlagTable.h"

namespace limn
{

namespace
{

/// The text with `before` in front of every character that is special.
std::string Escaped(const std::string& text, const std::string& special, const std::string& before)
{
    std::string escaped;
    for (const char c : text)
    {
        escaped += (special.find(c) == std::string::npos ? "" : before) + c;
    }
    return escaped;
}

/// Text within '...' of bash and zsh, which end it before a quote; fish takes a backslash.
std::string Quoted(const std::string& text, bool isFish = false)
{
    return "'" + Escaped(text, "'", isFish ? "\\" : "'\\'") + "'";
}

/// The words that may be a verb's argument, "bash zsh"; those of `help` are the verbs.
std::string WordsOf(const FlagTable& table, const Verb& verb)
{
    const bool hasArgument = !verb.flags.empty() && verb.flags.front().isArgument();
    return verb.name == "help" ? table.VerbNames() : hasArgument ? verb.flags.front().Words() : "";
}

std::string BashScript(const FlagTable& table)
{
    std::string options;
    std::string values;
    for (const Verb& verb : table.verbs)
    {
        std::string words = WordsOf(table, verb);
        for (const Flag* flag : table.FlagsOf(verb))
        {
            for (const std::string& spelling : flag->Spellings())
            {
                words += (words.empty() ? "" : " ") + spelling;
                values += flag->Words().empty() ? ""
                                                : "        '" + verb.name + " " + spelling +
                                                      "') words='" + flag->Words() + "' ;;\n";
            }
        }
        options += "        " + verb.name + ") words='" + words + "' ;;\n";
    }
    return "_limn()\n"
           "{\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words=\n"
           "    if [ \"$COMP_CWORD\" = 1 ]; then\n"
           "        words='" +
           table.VerbNames() +
           "'\n"
           "    else\n"
           "        case ${COMP_WORDS[1]} in\n" +
           options +
           "        esac\n"
           "        case \"${COMP_WORDS[1]} $before\" in\n" +
           values +
           "        esac\n"
           "    fi\n"
           "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
           "}\n"
           "complete -o default -F _limn limn\n";
}

/// "'*--size[Picture size]:value:_files'" for zsh's _arguments.
std::string ZshFlag(const Flag& flag)
{
    const std::string words = flag.Words().empty() ? "_files" : "(" + flag.Words() + ")";
    const std::string value = flag.value.empty() ? "" : ":value:" + words;
    std::string text;
    for (const std::string& spelling : flag.Spellings())
    {
        text += " \\\n            " +
                Quoted("*" + spelling + "[" + Escaped(flag.help, "[]:", "\\") + "]" + value);
    }
    return text;
}

std::string ZshScript(const FlagTable& table)
{
    std::string verbs;
    std::string cases;
    for (const Verb& verb : table.verbs)
    {
        verbs += "        " + Quoted(verb.name + ":" + verb.help) + "\n";
        const std::string words = WordsOf(table, verb);
        cases += "    " + verb.name +
                 ")\n        _arguments '*:word:" + (words.empty() ? "_files" : "(" + words + ")") +
                 "'";
        for (const Flag* flag : table.FlagsOf(verb))
        {
            cases += ZshFlag(*flag);
        }
        cases += "\n        ;;\n";
    }
    return "#compdef limn\n"
           "_limn()\n"
           "{\n"
           "    local -a verbs=(\n" +
           verbs +
           "    )\n"
           "    if (( CURRENT == 2 )); then\n"
           "        _describe verb verbs\n"
           "        return\n"
           "    fi\n"
           "    shift words\n"
           "    (( CURRENT-- ))\n"
           "    case $words[1] in\n" +
           cases +
           "    esac\n"
           "}\n"
           // It is sourced, or it is the body of a function that zsh loads at the first Tab.
           "if [ \"$funcstack[1]\" = _limn ]; then _limn; else compdef _limn limn; fi\n";
}

std::string FishScript(const FlagTable& table)
{
    std::string script;
    for (const Verb& verb : table.verbs)
    {
        script += "complete -c limn -n __fish_use_subcommand -f -a " + verb.name + " -d " +
                  Quoted(verb.help, true) + "\n";
        const std::string condition =
            "complete -c limn -n '__fish_seen_subcommand_from " + verb.name + "'";
        const std::string words = WordsOf(table, verb);
        script += words.empty() ? "" : condition + " -f -a '" + words + "'\n";
        for (const Flag* flag : table.FlagsOf(verb))
        {
            script += condition + " -l " + flag->name +
                      (flag->letter == '\0' ? "" : " -s " + flag->Spellings().back().substr(1)) +
                      (flag->value.empty() ? "" : " -r") +
                      (flag->Words().empty() ? "" : " -f -a '" + flag->Words() + "'") + " -d " +
                      Quoted(flag->help, true) + "\n";
        }
    }
    return script;
}

} // namespace

std::string CompletionScript(const FlagTable& table, const std::string& shell)
{
    return shell == "bash"  ? BashScript(table)
           : shell == "zsh" ? ZshScript(table)
                            : FishScript(table);
}

} // namespace limn

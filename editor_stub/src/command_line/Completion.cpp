#include "command_line/Completion.h"

#include "command_line/OptionText.h"

#include <CLI/CLI.hpp>

namespace limn
{

namespace
{

std::string Joined(const std::vector<std::string>& words)
{
    return CLI::detail::join(words, " ");
}

/// Text within '...' of any of the shells.
std::string Quoted(std::string text, const std::string& escapedQuote)
{
    return "'" + CLI::detail::find_and_replace(std::move(text), "'", escapedQuote) + "'";
}

std::vector<const CLI::Option*> OptionsOf(const CLI::App& verb, bool arePositional)
{
    std::vector<const CLI::Option*> options;
    for (const CLI::App* app = &verb; app; app = arePositional ? nullptr : app->get_parent())
    {
        for (const CLI::Option* option : app->get_options())
        {
            const bool isShadowed = app != &verb && option->get_name() == "--help";
            if (option->get_positional() == arePositional && !isShadowed)
            {
                options.push_back(option);
            }
        }
    }
    return options;
}

/// "--output", "-o"
std::vector<std::string> Spellings(const CLI::Option& option)
{
    std::vector<std::string> spellings;
    for (const std::string& name : option.get_lnames())
    {
        spellings.push_back("--" + name);
    }
    for (const std::string& name : option.get_snames())
    {
        spellings.push_back("-" + name);
    }
    return spellings;
}

/// The words that may follow a verb; for `help` the verbs.
std::vector<std::string> WordsOf(const CLI::App& verb)
{
    std::vector<std::string> words;
    for (const CLI::Option* option : OptionsOf(verb, true))
    {
        const std::vector<std::string> choices = ChoicesOf(*option);
        words.insert(words.end(), choices.begin(), choices.end());
    }
    return verb.get_name() == "help" ? VerbNames(*verb.get_parent()) : words;
}

std::string BashScript(const CLI::App& app)
{
    std::string options;
    std::string values;
    for (const CLI::App* verb : app.get_subcommands({}))
    {
        std::vector<std::string> words = WordsOf(*verb);
        for (const CLI::Option* option : OptionsOf(*verb, false))
        {
            const std::vector<std::string> spellings = Spellings(*option);
            words.insert(words.end(), spellings.begin(), spellings.end());
            const std::vector<std::string> choices = ChoicesOf(*option);
            for (const std::string& spelling : choices.empty() ? choices : spellings)
            {
                values += "        '" + verb->get_name() + " " + spelling + "') words='" +
                          Joined(choices) + "' ;;\n";
            }
        }
        options += "        " + verb->get_name() + ") words='" + Joined(words) + "' ;;\n";
    }
    return "_limn()\n"
           "{\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words=\n"
           "    if [ \"$COMP_CWORD\" = 1 ]; then\n"
           "        words='" +
           Joined(VerbNames(app)) +
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

/// "'--size[Picture size]:WxH:_files'" for zsh's _arguments.
std::string ZshOption(const CLI::Option& option)
{
    std::string description = option.get_description();
    for (const char* special : {"[", "]", ":"})
    {
        description =
            CLI::detail::find_and_replace(description, special, std::string("\\") + special);
    }
    const std::vector<std::string> choices = ChoicesOf(option);
    const std::string value =
        isFlag(option) ? ""
                       : ":value:" + (choices.empty() ? "_files" : "(" + Joined(choices) + ")");
    std::string text;
    for (const std::string& spelling : Spellings(option))
    {
        text +=
            " \\\n            " + Quoted("*" + spelling + "[" + description + "]" + value, "'\\''");
    }
    return text;
}

std::string ZshScript(const CLI::App& app)
{
    std::string verbs;
    std::string cases;
    for (const CLI::App* verb : app.get_subcommands({}))
    {
        verbs +=
            "        " + Quoted(verb->get_name() + ":" + verb->get_description(), "'\\''") + "\n";
        const std::vector<std::string> words = WordsOf(*verb);
        cases += "    " + verb->get_name() + ")\n        _arguments" +
                 " '*:word:" + (words.empty() ? "_files" : "(" + Joined(words) + ")") + "'";
        for (const CLI::Option* option : OptionsOf(*verb, false))
        {
            cases += ZshOption(*option);
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
           "compdef _limn limn\n";
}

std::string FishScript(const CLI::App& app)
{
    std::string script;
    for (const CLI::App* verb : app.get_subcommands({}))
    {
        script += "complete -c limn -n __fish_use_subcommand -f -a " + verb->get_name() + " -d " +
                  Quoted(verb->get_description(), "\\'") + "\n";
        const std::string condition =
            "complete -c limn -n '__fish_seen_subcommand_from " + verb->get_name() + "'";
        const std::vector<std::string> words = WordsOf(*verb);
        script += words.empty() ? "" : condition + " -f -a '" + Joined(words) + "'\n";
        for (const CLI::Option* option : OptionsOf(*verb, false))
        {
            const std::vector<std::string> choices = ChoicesOf(*option);
            script += condition + " -l " + option->get_lnames().front() +
                      (option->get_snames().empty() ? "" : " -s " + option->get_snames().front()) +
                      (isFlag(*option) ? "" : " -r") +
                      (choices.empty() ? "" : " -f -a '" + Joined(choices) + "'") + " -d " +
                      Quoted(option->get_description(), "\\'") + "\n";
        }
    }
    return script;
}

} // namespace

std::string CompletionScript(const CLI::App& app, const std::string& shell)
{
    return shell == "bash" ? BashScript(app) : shell == "zsh" ? ZshScript(app) : FishScript(app);
}

} // namespace limn

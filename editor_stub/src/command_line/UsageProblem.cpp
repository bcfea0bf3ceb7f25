#include "command_line/UsageProblem.h"

#include "command_line/OptionText.h"

#include <CLI/CLI.hpp>
#include <limn/base/Diagnostic.h>
#include <limn/base/TerminalText.h>

namespace limn
{

namespace
{

std::vector<std::string_view> Views(const std::vector<std::string>& texts)
{
    return {texts.begin(), texts.end()};
}

bool looksLikeOption(const std::string& word)
{
    return word.size() > 1 && word[0] == '-';
}

std::string UnknownOption(const std::string& word, const CLI::App& verb)
{
    std::vector<std::string> known = SpellingsOf(verb);
    if (verb.get_parent())
    {
        const std::vector<std::string> common = SpellingsOf(*verb.get_parent());
        known.insert(known.end(), common.begin(), common.end());
    }
    const std::string name = word.substr(0, word.find('='));
    const std::string nearest(NearestName(name, Views(known)));
    return "unknown option '" + Shortened(name, 64) + "'" +
           (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
}

bool beginsWithName(const std::string& message, const std::string& name)
{
    return message.starts_with(name) && (message.size() == name.size() ||
                                         message.find_first_of(": ", name.size()) == name.size());
}

/// The option that a message of CLI11 begins with; of a flag it may leave the dashes out.
const CLI::Option* FindSubject(const std::string& message, const CLI::App& verb)
{
    for (const CLI::App* app = &verb; app; app = app->get_parent())
    {
        for (const CLI::Option* option : app->get_options())
        {
            if (beginsWithName(message, option->get_name()) ||
                (isFlag(*option) && beginsWithName(message, option->get_lnames().front())))
            {
                return option;
            }
        }
    }
    return nullptr;
}

std::string MissingOf(const CLI::App& verb)
{
    std::vector<std::string> missing;
    for (const CLI::Option* option : verb.get_options())
    {
        if (option->get_required() && option->count() == 0)
        {
            missing.push_back(option->get_positional() ? option->get_type_name()
                                                       : "-" + option->get_snames().front() + " " +
                                                             option->get_type_name());
        }
    }
    std::string text = missing.front();
    for (std::size_t i = 1; i < missing.size(); ++i)
    {
        text += (i + 1 < missing.size() ? ", " : " and ") + missing[i];
    }
    return text + (missing.size() == 1 ? " is" : " are") + " missing";
}

std::string MismatchOf(const CLI::Option& option, const std::string& message)
{
    const std::string name = OptionName(option);
    if (isFlag(option))
    {
        return name + " takes no value";
    }
    return message.ends_with("missing")
               ? name + " needs a value: " + option.get_type_name()
               : name + " is given " + std::to_string(option.results().size()) +
                     " times, and takes one value";
}

/// `error` in limn's words.
std::string Reworded(const CLI::ParseError& error, const CLI::App& verb)
{
    const std::string message = error.what();
    const auto afterWord = [&message](const std::string& word)
    {
        return message.substr(message.find(word) + word.size());
    };
    const CLI::Option* subject = FindSubject(message, verb);
    if (dynamic_cast<const CLI::RequiredError*>(&error))
    {
        return verb.get_parent() ? MissingOf(verb) : "a verb is missing";
    }
    if (!subject)
    {
        return message;
    }
    const std::string name = OptionName(*subject);
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
    {
        return MismatchOf(*subject, message);
    }
    if (dynamic_cast<const CLI::RequiresError*>(&error))
    {
        return name + " needs " + afterWord(" requires ") + " beside it";
    }
    if (dynamic_cast<const CLI::ExcludesError*>(&error))
    {
        return name + " and " + afterWord(" excludes ") + " exclude each other";
    }
    const std::string reason = message.substr(subject->get_name().size());
    return subject->get_positional() ? reason.substr(std::string(": ").size()) : name + reason;
}

/// An option that was taken for the value of the one before it.
std::string SwallowedOption(const CLI::App& verb)
{
    for (const CLI::Option* option : verb.get_options())
    {
        for (const std::string& value : option->results())
        {
            if (!isFlag(*option) && looksLikeOption(value) && verb.get_option_no_throw(value))
            {
                return OptionName(*option) + " needs a value: " + option->get_type_name() + "; '" +
                       value + "' is an option";
            }
        }
    }
    return {};
}

} // namespace

std::string UnknownVerb(const std::string& name, const CLI::App& app)
{
    const std::vector<std::string> names = VerbNames(app);
    return "unknown verb " + UnknownName(name, Views(names));
}

std::string ProblemBeforeVerb(std::span<const std::string> args, const CLI::App& app)
{
    for (std::size_t i = 0; i < args.size(); ++i)
    {
        if (!looksLikeOption(args[i]))
        {
            const std::vector<std::string> verbs = VerbNames(app);
            const bool isVerb = std::find(verbs.begin(), verbs.end(), args[i]) != verbs.end();
            return isVerb ? "" : UnknownVerb(args[i], app);
        }
        const CLI::Option* option = app.get_option_no_throw(args[i].substr(0, args[i].find('=')));
        if (!option)
        {
            return UnknownOption(args[i], app);
        }
        i += !isFlag(*option) && args[i].find('=') == std::string::npos ? 1 : 0;
    }
    return {};
}

std::string ProblemOf(const CLI::App& app, const CLI::ParseError* error)
{
    const CLI::App& verb = ParsedVerb(app);
    const std::vector<std::string> left = app.remaining(true);
    for (const std::string& word : left)
    {
        if (looksLikeOption(word) && word != "--")
        {
            return UnknownOption(word, verb);
        }
    }
    const std::string swallowed = SwallowedOption(verb);
    if (!swallowed.empty() || error)
    {
        return swallowed.empty() ? Reworded(*error, verb) : swallowed;
    }
    return left.empty() ? "" : "unexpected argument '" + Shortened(left.front(), 64) + "'";
}

const CLI::App& ParsedVerb(const CLI::App& app)
{
    const std::vector<CLI::App*> parsed = app.get_subcommands();
    return parsed.empty() ? app : *parsed.front();
}

} // namespace limn

#pragma once

#include "console/Console.h"

#include <functional>
#include <limn/editor_stub/RunLimn.h>
#include <span>
#include <string>
#include <vector>

namespace limn
{

// The command line is a table. Parsing, help, completion, the man page and errors all use it.

inline constexpr const char* k_ExitCodes =
    "Results go to stdout, everything else to stderr. Exit codes: 0 done, 1 the input is bad, 2 "
    "wrong usage, 3 the machine lacks something, 70 a bug in limn.";

enum class Times
{
    AtMostOnce,
    Once,
    Any,
    AnyInARow, ///< any number, and several values may follow one flag
    AtLeastOnce
};

/// A flag, or an argument, which is a word that is known by its place.
struct Flag
{
    std::string name; ///< "output", as in --output; "" for an argument
    /// The name of its value, "FILE", or the allowed words, "bash|zsh"; "" if it takes no value.
    std::string value;
    std::string help;
    /// Stores the value, and returns what is wrong with it, or "" if nothing is.
    std::function<std::string(const std::string&)> store;
    Times times = Times::AtMostOnce;
    /// Returns what the value may be where a person has begun to type it, once the words before it
    /// are stored. Null where a shell offers the names of all files. May throw what loaders throw.
    std::function<std::vector<std::string>(const std::string&)> candidates = {};
    char letter = '\0';      ///< 'o', as in -o; '\0' if there is none
    std::string unless = {}; ///< the flag whose presence makes this one optional

    bool isArgument() const { return name.empty(); }
    bool isRequired() const { return times == Times::Once || times == Times::AtLeastOnce; }
    bool isRepeatable() const { return times >= Times::Any; }

    std::string Words() const;                  ///< "bash zsh", if only these words are allowed
    std::vector<std::string> Spellings() const; ///< "--output", "-o"
    std::string Name() const;                   ///< "SCENE", "--output"
    std::string ShortText() const;              ///< "SCENE", "-o FILE"
    std::string FullText() const;               ///< "SCENE ...", "-o, --output FILE"
};

/// A flag that needs another beside it, or two that exclude each other.
struct FlagRule
{
    std::string first;
    std::string second;
    bool isNeeded = false; ///< true if the first needs the second
};

struct Verb
{
    std::string name;
    std::string help;
    std::function<ExitCode(Console&)> run;
    std::vector<Flag> flags; ///< in the order in which help lists them, the arguments first
    std::vector<FlagRule> rules = {};
    bool isRead = false; ///< true if it prints at its end, for people to read
};

struct FlagTable
{
    Verb limn; ///< has the flags that all verbs take
    std::vector<Verb> verbs;

    const Verb* Find(const std::string& verb) const; ///< null if there is no such verb
    std::string VerbNames() const;                   ///< "render watch"
    /// Returns the flags that a verb can have, without its arguments.
    std::vector<const Flag*> FlagsOf(const Verb& verb) const;
};

struct ParsedFlags
{
    const Verb* verb;             ///< FlagTable::limn if the words name no verb
    std::string problem;          ///< a sentence about the first wrong word; "" if there is none
    std::string unknownVerb = {}; ///< the word that stands where a verb should, if it is none
    /// The flag that lacks its value behind the last word, else the argument that may follow; null
    /// if there is none.
    const Flag* next = nullptr;
};

/// Parses the arguments and runs the verb; errors come as exceptions.
ExitCode RunCommandLine(std::span<const std::string> args, Console& console);

/// Reads `[FLAGS] VERB [FLAGS|ARGUMENTS]` and stores every value, even behind a wrong word.
ParsedFlags ParseFlags(std::span<const std::string> words, const FlagTable& table);

/// Returns the usage of a verb: "limn render SCENE -o FILE [OPTIONS]".
std::string UsageText(const FlagTable& table, const Verb& verb);

/// Returns what `limn help VERB` prints, or `limn help` for the table's `limn`.
/// @param width  the most columns of a line
std::string HelpText(const FlagTable& table, const Verb& verb, std::size_t width);

/// Returns the man page limn(1) in troff, with every verb and flag.
std::string ManPage(const FlagTable& table);

/// Returns a script that makes a shell ask `limn complete` for what may stand in place of a word,
/// and complete the word as a file's name where nothing may.
/// @param shell  "bash", "zsh" or "fish"
std::string CompletionScript(const std::string& shell);

/// Returns what may stand in place of the last word of a command line: verbs, flags, values. Each
/// has a line, in which a tab and what it is for may follow it.
/// @param words  what was typed behind "limn", not empty; its values are stored
std::string CompletionText(const FlagTable& table, std::span<const std::string> words);

/// Returns what is wrong with a word, "unknown verb 'rendr'; did you mean 'render'?", or "" if it
/// is one of the known words.
/// @param known  the known words: "render watch"
std::string CheckWord(const std::string& kind, const std::string& word, const std::string& known);

} // namespace limn

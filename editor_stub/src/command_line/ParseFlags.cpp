#include "command_line/FlagTable.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/base/TerminalText.h>
#include <map>
#include <optional>

namespace limn
{

namespace
{

class FlagParser
{
public:
    FlagParser(std::span<const std::string> words, const FlagTable& table)
        : m_Words(words), m_Table(table), m_Verb(&table.limn)
    {
    }

    ParsedFlags Parse()
    {
        bool hasFlags = true; // "--" ends them
        while (m_Next < m_Words.size())
        {
            const std::string& word = m_Words[m_Next++];
            if (!hasFlags || word.size() < 2 || word[0] != '-')
            {
                ReadArgument(word);
                continue;
            }
            m_InARow = nullptr;
            hasFlags = word != "--";
            if (hasFlags)
            {
                word[1] == '-' ? ReadLong(word) : ReadLetters(word);
            }
        }
        CheckTimes();
        CheckRules(m_Table.limn);
        CheckMissing();
        CheckRules(*m_Verb);
        Complain(m_Surplus);
        return {m_Verb, m_Problem, m_UnknownVerb, m_Open ? m_Open : NextArgument()};
    }

private:
    void ReadArgument(const std::string& word)
    {
        if (m_Verb == &m_Table.limn)
        {
            const Verb* verb = m_Table.Find(word);
            Complain(CheckWord("verb", word, m_Table.VerbNames()));
            m_UnknownVerb = verb ? "" : word;
            m_Verb = verb ? verb : m_Verb;
            m_Next = verb ? m_Next : m_Words.size();
            return;
        }
        if (isOneMore(word))
        {
            return;
        }
        m_InARow = nullptr;
        if (const Flag* argument = NextArgument())
        {
            Store(*argument, word);
        }
        else if (m_Surplus.empty())
        {
            m_Surplus = "unexpected argument '" + Shortened(word, 64) + "'";
        }
    }

    /// The argument that the next word is; null if the verb takes no more.
    const Flag* NextArgument()
    {
        const auto argument = std::ranges::find_if(
            m_Verb->flags, [this](const Flag& flag)
            { return flag.isArgument() && (flag.isRepeatable() || m_Counts[&flag] == 0); });
        return argument == m_Verb->flags.end() ? nullptr : &*argument;
    }

    /// Stores the word if it is one more value of the flag before it. A folder may as well be the
    /// verb's argument, so that it is one only where the verb has an argument already.
    bool isOneMore(const std::string& word)
    {
        const bool hasArgument = std::ranges::any_of(
            m_Counts, [](const auto& count) { return count.first->isArgument() && count.second; });
        return m_InARow && (hasArgument || word.find('=') != std::string::npos) &&
               m_InARow->store(word).empty();
    }

    void ReadLong(const std::string& word)
    {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        if (const Flag* flag = FindFlag(name))
        {
            equals == std::string::npos ? TakeValue(*flag)
                                        : TakeValue(*flag, word.substr(equals + 1));
            return;
        }
        ComplainOfUnknown(name);
    }

    /// "-q", "-qv", "-j2", "-qj2", "-o" before its value.
    void ReadLetters(const std::string& word)
    {
        for (std::size_t i = 1; i < word.size(); ++i)
        {
            const Flag* flag = FindFlag({'-', word[i]});
            if (!flag)
            {
                ComplainOfUnknown("-" + word.substr(i, word.find('=', i + 1) - i));
                return;
            }
            if (!flag->value.empty() && i + 1 < word.size())
            {
                TakeValue(*flag, word.substr(i + 1));
                return;
            }
            TakeValue(*flag);
        }
    }

    /// @param own  the value that stands in the flag's own word
    void TakeValue(const Flag& flag, const std::optional<std::string>& own = std::nullopt)
    {
        const bool isLast = m_Next == m_Words.size();
        if (own && flag.value.empty())
        {
            Complain(flag.Name() + " takes no value");
        }
        else if (own || flag.value.empty())
        {
            Store(flag, own.value_or(""));
        }
        else if (isLast || FindFlag(m_Words[m_Next]))
        {
            m_Open = isLast ? &flag : nullptr;
            Complain(flag.Name() + " needs a value: " + flag.value +
                     (isLast ? "" : "; '" + m_Words[m_Next] + "' is an option"));
        }
        else
        {
            Store(flag, m_Words[m_Next++]);
            m_InARow = flag.times == Times::AnyInARow ? &flag : nullptr;
        }
    }

    void Store(const Flag& flag, const std::string& value)
    {
        ++m_Counts[&flag];
        const std::string words = flag.Words();
        const std::string unknown = words.empty() ? "" : CheckWord("word", value, words);
        const std::string problem = unknown.empty() ? flag.store(value) : unknown;
        Complain(problem.empty() || flag.isArgument() ? problem : flag.Name() + ": " + problem);
    }

    /// @param spelling  "--output", "-o"
    /// @return null if neither the verb nor limn has such a flag
    const Flag* FindFlag(const std::string& spelling) const
    {
        const std::vector<const Flag*> flags = m_Table.FlagsOf(*m_Verb);
        const auto found =
            std::ranges::find_if(flags, [&](const Flag* flag)
                                 { return std::ranges::count(flag->Spellings(), spelling) > 0; });
        return found == flags.end() ? nullptr : *found;
    }

    int Count(const std::string& name) const
    {
        const auto found = m_Counts.find(FindFlag("--" + name));
        return found == m_Counts.end() ? 0 : found->second;
    }

    /// Keeps the first complaint that is not empty.
    void Complain(const std::string& problem)
    {
        m_Problem = m_Problem.empty() ? problem : m_Problem;
    }

    void ComplainOfUnknown(const std::string& spelling)
    {
        std::vector<std::string> known;
        std::ranges::transform(m_Table.FlagsOf(*m_Verb), std::back_inserter(known), &Flag::Name);
        Complain("unknown option '" + Shortened(spelling, 64) + "'" +
                 DidYouMean(spelling, {known.begin(), known.end()}));
    }

    void CheckTimes()
    {
        for (const Flag* flag : m_Table.FlagsOf(*m_Verb))
        {
            const int count = m_Counts[flag];
            Complain(count < 2 || flag->value.empty() || flag->isRepeatable()
                         ? ""
                         : flag->Name() + " is given " + std::to_string(count) +
                               " times, and takes one value");
        }
    }

    void CheckMissing()
    {
        std::vector<std::string> missing;
        for (const Flag& flag : m_Verb->flags)
        {
            if (flag.isRequired() && m_Counts[&flag] == 0 && Count(flag.unless) == 0)
            {
                missing.push_back(flag.ShortText());
            }
        }
        if (m_Verb == &m_Table.limn)
        {
            missing = {"a verb"};
        }
        std::string text;
        for (std::size_t i = 0; i < missing.size(); ++i)
        {
            text += (i == 0 ? "" : i + 1 < missing.size() ? ", " : " and ") + missing[i];
        }
        Complain(missing.empty() ? "" : text + (missing.size() == 1 ? " is" : " are") + " missing");
    }

    void CheckRules(const Verb& verb)
    {
        for (const FlagRule& rule : verb.rules)
        {
            const std::string first = "--" + rule.first;
            const std::string second = "--" + rule.second;
            const bool isBroken = Count(rule.first) && (Count(rule.second) > 0) != rule.isNeeded;
            Complain(!isBroken       ? ""
                     : rule.isNeeded ? first + " needs " + second + " beside it"
                                     : first + " and " + second + " exclude each other");
        }
    }

    std::span<const std::string> m_Words;
    const FlagTable& m_Table;
    const Verb* m_Verb;
    std::size_t m_Next = 0; ///< of m_Words
    std::map<const Flag*, int> m_Counts;
    const Flag* m_InARow = nullptr; ///< the flag that may have one value more
    const Flag* m_Open = nullptr;   ///< the flag that lacks its value at the end
    std::string m_UnknownVerb;
    std::string m_Surplus; ///< complaint about the first argument that has no place
    std::string m_Problem;
};

} // namespace

ParsedFlags ParseFlags(std::span<const std::string> words, const FlagTable& table)
{
    return FlagParser(words, table).Parse();
}

} // namespace limn

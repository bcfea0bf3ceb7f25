#include "port/csharp/CSharpConditions.h"

#include "console/Texts.h"

#include <algorithm>
#include <functional>
#include <limn/base/ParseWhole.h>

namespace limn
{

namespace
{

/// Removes the symbol that a text begins with, and returns it; "" if there is none.
std::string_view TakeSymbol(std::string_view& text)
{
    const auto end =
        std::ranges::find_if_not(text, [](char c) { return isLetter(c) || isDigit(c); });
    const std::string_view symbol(text.begin(), end);
    text.remove_prefix(symbol.size());
    return symbol;
}

/// a || b && !(c == d)
class ConditionReader
{
public:
    ConditionReader(std::string_view text, std::function<bool(std::string_view)> isDefined)
        : m_Text(text), m_IsDefined(std::move(isDefined))
    {
    }

    /// Returns its answer, or nothing if it is no condition.
    std::optional<bool> Read()
    {
        const bool answer = Or();
        return m_IsGood && Trim(m_Text).empty() ? std::optional(answer) : std::nullopt;
    }

private:
    bool Next(std::string_view word)
    {
        m_Text = Trim(m_Text);
        if (!m_Text.starts_with(word))
        {
            return false;
        }
        m_Text.remove_prefix(word.size());
        return true;
    }
    bool Or()
    {
        bool value = And();
        while (Next("||"))
        {
            value = And() || value;
        }
        return value;
    }
    bool And()
    {
        bool value = Equal();
        while (Next("&&"))
        {
            value = Equal() && value;
        }
        return value;
    }
    bool Equal()
    {
        const bool value = Single();
        if (Next("=="))
        {
            return value == Single();
        }
        return Next("!=") ? value != Single() : value;
    }
    bool Single()
    {
        if (!m_IsGood || ++m_Depth > 100)
        {
            m_IsGood = false;
            return false;
        }
        if (Next("("))
        {
            const bool value = Or();
            m_IsGood = Next(")") && m_IsGood;
            return value;
        }
        if (!m_Text.starts_with("!=") && Next("!"))
        {
            return !Single();
        }
        const std::string_view word = TakeSymbol(m_Text);
        m_IsGood = m_IsGood && !word.empty();
        return word == "true" || (word != "false" && m_IsDefined(word));
    }

    std::string_view m_Text;
    std::function<bool(std::string_view)> m_IsDefined;
    bool m_IsGood = true;
    int m_Depth = 0;
};

/// "UNITY_2021_2_OR_NEWER": who, since which version.
struct VersionSymbol
{
    explicit VersionSymbol(std::string_view symbol)
    {
        for (const std::string_view suffix : {"_OR_NEWER", "_OR_HIGHER", "_OR_LATER", "_PLUS"})
        {
            if (symbol.ends_with(suffix))
            {
                symbol.remove_suffix(suffix.size());
                isOrNewer = true;
            }
        }
        for (std::size_t bar = symbol.rfind('_'); bar != std::string_view::npos && bar > 0;
             bar = symbol.rfind('_'))
        {
            const std::optional<int> number = ParseWhole<int>(symbol.substr(bar + 1));
            if (!number)
            {
                break;
            }
            numbers.insert(numbers.begin(), *number);
            symbol = symbol.substr(0, bar);
        }
        subject = symbol;
    }

    bool isMetBy(const std::vector<int>& version) const
    {
        const auto [wanted, there] = std::ranges::mismatch(numbers, version);
        return wanted == numbers.end() || there == version.end() || (isOrNewer && *wanted < *there);
    }

    std::string_view subject; ///< "UNITY"
    std::vector<int> numbers; ///< 2021, 2
    bool isOrNewer = false;
};

/// "URP", "UNITY_PIPELINE_URP", "USING_UNIVERSAL_RP", as projects call it.
bool IsOfUniversalPipeline(std::string_view subject)
{
    return subject.find("URP") != std::string_view::npos ||
           subject.find("UNIVERSAL") != std::string_view::npos;
}

} // namespace

std::string CSharpTarget::name() const
{
    return "Unity " + std::to_string(year) + "." + std::to_string(release) + " (URP " +
           std::to_string(urp()) + ")";
}

bool IsDefinedFor(std::string_view symbol, const CSharpTarget& target)
{
    if (symbol.starts_with("UNITY_EDITOR"))
    {
        return false; // limn is a player
    }
    const VersionSymbol version(symbol);
    if (version.subject == "UNITY" && !version.numbers.empty())
    {
        return version.isMetBy({target.year, target.release});
    }
    if (IsOfUniversalPipeline(version.subject))
    {
        return version.numbers.empty()
                   ? version.subject.find("COMPATIBILITY") == std::string_view::npos ||
                         target.urp() < 17
                   : version.isMetBy({target.urp()});
    }
    return symbol == "UNITY_STANDALONE" || symbol == "UNITY_64" ||
           (target.isUnknownDefined && !symbol.starts_with("UNITY_"));
}

bool CSharpConditions::Answer(std::string_view condition, const SourceLocation& location)
{
    const auto isDefined = [this](std::string_view symbol)
    {
        const auto own = m_Defined.find(symbol);
        return own == m_Defined.end() ? IsDefinedFor(symbol, m_Target) : own->second;
    };
    const std::optional<bool> answer = ConditionReader(condition, isDefined).Read();
    if (!answer)
    {
        Fail(location, "'" + std::string(condition) +
                           "' is no condition; symbols with !, &&, || and () are expected");
    }
    m_Answered.push_back({std::string(condition), *answer, location});
    return *answer;
}

void CSharpConditions::Take(std::string_view line, const SourceLocation& location)
{
    line = Trim(line.substr(1));
    const std::string_view name = TakeSymbol(line);
    const std::string_view rest = Trim(line.substr(0, line.find("//")));
    if (name == "if")
    {
        const bool isOuterTaken = isTaken();
        const bool isIn = isOuterTaken && Answer(rest, location);
        m_Open.push_back({location, isOuterTaken, isIn, isIn});
    }
    else if (IsIn(name, {"elif", "else", "endif"}) && m_Open.empty())
    {
        Fail(location, "'#" + std::string(name) + "' stands behind no #if");
    }
    else if (name == "elif" || name == "else")
    {
        Branch& open = m_Open.back();
        open.isTaken =
            open.isOuterTaken && !open.wasTaken && (name == "else" || Answer(rest, location));
        open.wasTaken = open.wasTaken || open.isTaken;
    }
    else if (name == "endif")
    {
        m_Open.pop_back();
    }
    else if (isTaken() && (name == "define" || name == "undef"))
    {
        m_Defined[std::string(rest)] = name == "define";
    }
}

void CSharpConditions::Finish() const
{
    if (!m_Open.empty())
    {
        Fail(m_Open.back().location, "'#if' has no #endif");
    }
}

void CSharpConditions::Fail(const SourceLocation& location, const std::string& message) const
{
    throw AssetError(m_File, location, message);
}

} // namespace limn

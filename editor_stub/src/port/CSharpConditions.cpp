#include "port/CSharpConditions.h"

#include <charconv>
#include <functional>

namespace limn
{

namespace
{

bool IsWordCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string_view Trimmed(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos)
    {
        return {};
    }
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string_view WithoutComment(std::string_view text)
{
    return Trimmed(text.substr(0, text.find("//")));
}

/// a || b && !(c == d)
class ConditionReader
{
public:
    ConditionReader(std::string_view text, std::function<bool(std::string_view)> isDefined)
        : m_Text(text), m_IsDefined(std::move(isDefined))
    {
    }

    /// Whether it is a condition, and its answer.
    bool Read(bool& answer)
    {
        answer = Or();
        Skip();
        return m_IsGood && m_Text.empty();
    }

private:
    void Skip() { m_Text = Trimmed(m_Text); }
    bool Next(std::string_view word)
    {
        Skip();
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
            const bool other = And();
            value = value || other;
        }
        return value;
    }
    bool And()
    {
        bool value = Equal();
        while (Next("&&"))
        {
            const bool other = Equal();
            value = value && other;
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
        Skip();
        if (!m_Text.starts_with("!=") && Next("!"))
        {
            return !Single();
        }
        std::size_t length = 0;
        while (length < m_Text.size() && IsWordCharacter(m_Text[length]))
        {
            ++length;
        }
        m_IsGood = m_IsGood && length > 0;
        const std::string_view word = m_Text.substr(0, length);
        m_Text.remove_prefix(length);
        return word == "true" || (word != "false" && m_IsDefined(word));
    }

    std::string_view m_Text;
    std::function<bool(std::string_view)> m_IsDefined;
    bool m_IsGood = true;
    int m_Depth = 0;
};

} // namespace

bool IsDefinedForLimn(std::string_view symbol)
{
    // UNITY_2022_3_OR_NEWER, UNITY_2020_1_OR_NEWER, ... UNITY_6000_0_OR_NEWER is not.
    constexpr std::string_view prefix = "UNITY_";
    constexpr std::string_view suffix = "_OR_NEWER";
    if (!symbol.starts_with(prefix) || !symbol.ends_with(suffix) ||
        symbol.size() < prefix.size() + suffix.size())
    {
        return false;
    }
    int numbers[2] = {0, 0};
    const char* begin = symbol.data() + prefix.size();
    const char* end = symbol.data() + symbol.size() - suffix.size();
    const auto year = std::from_chars(begin, end, numbers[0]);
    if (year.ec != std::errc{} || year.ptr == end || *year.ptr != '_')
    {
        return false;
    }
    const auto release = std::from_chars(year.ptr + 1, end, numbers[1]);
    return release.ec == std::errc{} &&
           (numbers[0] < 2022 || (numbers[0] == 2022 && numbers[1] <= 3));
}

bool CSharpConditions::Answer(std::string_view condition, const SourceLocation& location)
{
    bool answer = false;
    const auto isDefined = [this](std::string_view symbol)
    {
        return m_Defined.contains(symbol) ||
               (!m_Undefined.contains(symbol) && IsDefinedForLimn(symbol));
    };
    if (!ConditionReader(condition, isDefined).Read(answer))
    {
        Fail(location, "'" + std::string(condition) +
                           "' is no condition; symbols with !, &&, || and () are expected");
    }
    m_Answered.push_back({std::string(condition), answer, location});
    return answer;
}

void CSharpConditions::Take(std::string_view line, const SourceLocation& location)
{
    line = Trimmed(line.substr(1));
    std::size_t length = 0;
    while (length < line.size() && IsWordCharacter(line[length]))
    {
        ++length;
    }
    const std::string_view name = line.substr(0, length);
    const std::string_view rest = WithoutComment(line.substr(length));
    if (name == "if")
    {
        const bool isOuterTaken = isTaken();
        const bool isIn = isOuterTaken && Answer(rest, location);
        m_Open.push_back({location, isOuterTaken, isIn, isIn});
    }
    else if (name == "elif" || name == "else")
    {
        if (m_Open.empty())
        {
            Fail(location, "'#" + std::string(name) + "' stands behind no #if");
        }
        Branch& open = m_Open.back();
        open.isTaken =
            open.isOuterTaken && !open.wasTaken && (name == "else" || Answer(rest, location));
        open.wasTaken = open.wasTaken || open.isTaken;
    }
    else if (name == "endif")
    {
        if (m_Open.empty())
        {
            Fail(location, "'#endif' stands behind no #if");
        }
        m_Open.pop_back();
    }
    else if (isTaken() && (name == "define" || name == "undef"))
    {
        (name == "define" ? m_Defined : m_Undefined).insert(std::string(rest));
        (name == "define" ? m_Undefined : m_Defined).erase(std::string(rest));
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

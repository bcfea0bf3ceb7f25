#include "port/csharp/CSharpTokens.h"

#include "port/csharp/CSharpConditions.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Letters of other scripts are bytes above 127.
bool IsNameStart(char c)
{
    return isLetter(c) || static_cast<unsigned char>(c) > 127;
}

constexpr std::string_view k_LongPunctuation[] = {
    "=>", "::", "?.", "??", "==", "!=", "<=", ">=", "+=",
    "-=", "*=", "/=", "%=", "&=", "|=", "^=", "&&", "||"};
constexpr int k_MaxHoles = 20; ///< strings in strings

class Tokenizer
{
public:
    Tokenizer(std::string_view text, const std::string& file, const CSharpTarget& target)
        : m_Text(text), m_File(file), m_Conditions(file, target)
    {
    }

    CSharpTokens Run()
    {
        if (m_Text.starts_with("\xEF\xBB\xBF"))
        {
            m_At = 3;
            m_LineStart = 3;
        }
        CSharpTokens result;
        while (SkipToToken())
        {
            Read(result.tokens);
        }
        m_Conditions.Finish();
        CSharpToken end;
        end.offset = m_Text.size();
        end.location = Here();
        result.tokens.push_back(end);
        Match(result.tokens);
        result.conditions = m_Conditions.answered();
        result.leftOut = std::move(m_LeftOut);
        return result;
    }

private:
    char Peek(std::size_t ahead = 0) const
    {
        return m_At + ahead < m_Text.size() ? m_Text[m_At + ahead] : '\0';
    }
    bool StartsWith(std::string_view word) const { return m_Text.substr(m_At).starts_with(word); }
    SourceLocation Here() const { return {m_Line, static_cast<int>(m_At - m_LineStart) + 1}; }
    [[noreturn]] void Fail(const SourceLocation& location, const std::string& message) const
    {
        throw AssetError(m_File, location, message);
    }

    void Advance(std::size_t count = 1)
    {
        for (; count > 0 && m_At < m_Text.size(); --count)
        {
            if (m_Text[m_At++] == '\n')
            {
                ++m_Line;
                m_LineStart = m_At;
                m_IsLineEmpty = true;
            }
        }
    }
    std::string_view RestOfLine() const
    {
        return m_Text.substr(m_At, m_Text.find('\n', m_At) - m_At);
    }

    /// @return whether there is one
    bool SkipToToken()
    {
        while (m_At < m_Text.size())
        {
            const char c = Peek();
            if (c == '#' && m_IsLineEmpty)
            {
                m_Conditions.Take(RestOfLine(), Here());
                LeaveOutLine();
            }
            else if (c == ' ' || c == '\t' || c == '\r' || c == '\n')
            {
                Advance();
            }
            else if (!m_Conditions.isTaken())
            {
                LeaveOutLine();
            }
            else if (StartsWith("//"))
            {
                Advance(RestOfLine().size());
            }
            else if (StartsWith("/*"))
            {
                SkipComment();
            }
            else
            {
                return true;
            }
        }
        return false;
    }

    void LeaveOutLine()
    {
        m_LeftOut.push_back({m_At, m_At + RestOfLine().size()});
        Advance(RestOfLine().size());
    }

    void SkipComment()
    {
        const std::size_t end = m_Text.find("*/", m_At + 2);
        if (end == std::string_view::npos)
        {
            Fail(Here(), "this comment has no end; '*/' is expected");
        }
        Advance(end + 2 - m_At);
    }

    void Read(std::vector<CSharpToken>& tokens)
    {
        m_IsLineEmpty = false;
        CSharpToken token;
        token.offset = m_At;
        token.location = Here();
        const char c = Peek();
        if (ReadString(token))
        {
            token.kind = CSharpTokenKind::String;
        }
        else if (c == '\'')
        {
            token.kind = CSharpTokenKind::Character;
            SkipCharacter(token.location);
        }
        else if (IsNameStart(c) || (c == '@' && IsNameStart(Peek(1))))
        {
            token.kind = CSharpTokenKind::Identifier;
            token.offset += c == '@' ? 1 : 0;
            Advance();
            SkipWhile(IsNamePart);
        }
        else if (isDigit(c) || (c == '.' && isDigit(Peek(1))))
        {
            token.kind = CSharpTokenKind::Number;
            SkipNumber();
        }
        else
        {
            token.kind = CSharpTokenKind::Punctuation;
            SkipPunctuation();
        }
        token.text = m_Text.substr(token.offset, m_At - token.offset);
        tokens.push_back(std::move(token));
    }

    template <typename Is>
    void SkipWhile(Is is)
    {
        while (m_At < m_Text.size() && is(m_Text[m_At]))
        {
            Advance();
        }
    }

    void SkipNumber()
    {
        const bool isHex = StartsWith("0x") || StartsWith("0X");
        while (IsNamePart(Peek()) || (Peek() == '.' && isDigit(Peek(1))) ||
               (!isHex && (Peek() == '+' || Peek() == '-') &&
                (m_Text[m_At - 1] == 'e' || m_Text[m_At - 1] == 'E')))
        {
            Advance();
        }
    }

    void SkipPunctuation()
    {
        const char c = Peek();
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f' || c == '`' || c == '\\')
        {
            Fail(Here(), "C# has no such character here; is this a C# file?");
        }
        const bool isLong = std::ranges::any_of(k_LongPunctuation, [this](std::string_view word)
                                                { return StartsWith(word); });
        Advance(isLong && !(StartsWith("?.") && isDigit(Peek(2))) ? 2 : 1);
    }

    void SkipCharacter(const SourceLocation& start)
    {
        Advance(Peek(1) == '\\' ? 3 : 2);
        while (m_At < m_Text.size() && Peek() != '\'' && Peek() != '\n')
        {
            Advance(Peek() == '\\' ? 2 : 1);
        }
        if (Peek() != '\'')
        {
            Fail(start, "this character has no end; ' is expected");
        }
        Advance();
    }

    /// "a", @"a", $"a", $@"a", """a""".
    bool ReadString(CSharpToken& token)
    {
        std::size_t prefix = 0;
        bool isVerbatim = false;
        bool isInterpolated = false;
        while (Peek(prefix) == '@' || Peek(prefix) == '$')
        {
            isVerbatim = isVerbatim || Peek(prefix) == '@';
            isInterpolated = isInterpolated || Peek(prefix) == '$';
            ++prefix;
        }
        if (Peek(prefix) != '"')
        {
            return false;
        }
        if (m_Text.substr(m_At + prefix).starts_with("\"\"\""))
        {
            ReadRawString(prefix, token.location);
            return true;
        }
        Advance(prefix + 1);
        for (;;)
        {
            const char c = Peek();
            const bool isDoubled = Peek(1) == c;
            if (m_At >= m_Text.size() || (c == '\n' && !isVerbatim))
            {
                Fail(token.location, "this text has no end; '\"' is expected");
            }
            if (c == '"' && !(isVerbatim && isDoubled))
            {
                Advance();
                return true;
            }
            if (isInterpolated && c == '{' && !isDoubled)
            {
                ReadHole(token);
                continue;
            }
            const bool isPair = (isVerbatim ? c == '"' : c == '\\') ||
                                (isInterpolated && (c == '{' || c == '}') && isDoubled);
            Advance(isPair ? 2 : 1);
        }
    }

    void ReadRawString(std::size_t prefix, const SourceLocation& start)
    {
        std::size_t quotes = 0;
        while (Peek(prefix + quotes) == '"')
        {
            ++quotes;
        }
        const std::size_t end =
            m_Text.find(m_Text.substr(m_At + prefix, quotes), m_At + prefix + quotes);
        if (end == std::string_view::npos)
        {
            Fail(start, "this text has no end; " + std::string(quotes, '"') + " is expected");
        }
        Advance(end + quotes - m_At);
    }

    /// Reads the code between { and } in a text.
    void ReadHole(CSharpToken& token)
    {
        if (++m_HoleDepth > k_MaxHoles)
        {
            Fail(Here(), "interpolated texts are nested too deeply here");
        }
        Advance();
        int depth = 1;
        for (;;)
        {
            SkipWhile([](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
            if (m_At >= m_Text.size() || (depth == 1 && Peek() == '"'))
            {
                Fail(token.location, "the {...} of this text has no end; '}' is expected");
            }
            depth += Peek() == '{' || Peek() == '(' ? 1 : Peek() == '}' || Peek() == ')' ? -1 : 0;
            if (depth == 0)
            {
                Advance();
                break;
            }
            if (depth == 1 && Peek() == ':') // the format
            {
                SkipWhile([](char c) { return c != '}' && c != '"' && c != '\n'; });
                continue;
            }
            Read(token.hole);
        }
        Match(token.hole);
        token.hole.push_back({});
        --m_HoleDepth;
    }

    void Match(std::vector<CSharpToken>& tokens) const
    {
        constexpr std::string_view k_Opening = "([{";
        constexpr std::string_view k_Closing = ")]}";
        std::vector<CSharpToken*> open;
        for (CSharpToken& token : tokens)
        {
            const bool isMark = token.kind == CSharpTokenKind::Punctuation;
            if (isMark && k_Opening.find(token.text) != std::string_view::npos)
            {
                open.push_back(&token);
            }
            const std::size_t kind = isMark ? k_Closing.find(token.text) : std::string_view::npos;
            if (kind == std::string_view::npos)
            {
                continue;
            }
            if (open.empty() || open.back()->text[0] != k_Opening[kind])
            {
                const std::string other =
                    open.empty()
                        ? ""
                        : "; '" + std::string(open.back()->text) + "' of line " +
                              std::to_string(open.back()->location.line) + " is still open";
                Fail(token.location, "'" + std::string(token.text) + "' closes nothing" + other);
            }
            open.back()->match = &token - open.back();
            token.match = -open.back()->match;
            open.pop_back();
        }
        if (!open.empty())
        {
            Fail(open.back()->location, "'" + std::string(open.back()->text) + "' is never closed");
        }
    }

    std::string_view m_Text;
    const std::string& m_File;
    CSharpConditions m_Conditions;
    std::vector<CSharpRange> m_LeftOut;
    std::size_t m_At = 0;
    std::size_t m_LineStart = 0;
    int m_Line = 1;
    int m_HoleDepth = 0;
    bool m_IsLineEmpty = true; ///< so far
};

} // namespace

bool IsNamePart(char c)
{
    return IsNameStart(c) || isDigit(c);
}

CSharpTokens TokenizeCSharp(std::string_view text, const std::string& file,
                            const CSharpTarget& target)
{
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    {
        throw AssetError(file, {1, 1}, "is text in UTF-16; save it as UTF-8");
    }
    const std::size_t zero = text.find('\0');
    if (zero != std::string_view::npos)
    {
        const auto before = text.substr(0, zero);
        const int line = 1 + static_cast<int>(std::ranges::count(before, '\n'));
        throw AssetError(file, {line, static_cast<int>(zero - (before.rfind('\n') + 1)) + 1},
                         "the file is not text: here is a byte of 0; a C# file is expected");
    }
    return Tokenizer(text, file, target).Run();
}

} // namespace limn

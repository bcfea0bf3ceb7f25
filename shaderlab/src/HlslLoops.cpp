#include "HlslLoops.h"

#include "HlslTokens.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace limn
{

namespace
{

class LoopHoister
{
public:
    explicit LoopHoister(const std::string& text) : m_Text(text), m_Tokens(TokenizeHlsl(text))
    {
        int depth = 0;
        for (std::size_t i = 0; i < m_Tokens.size(); ++i)
        {
            depth += std::min(Step(i), 0);
            m_Depth.push_back(depth);
            depth += std::max(Step(i), 0);
        }
    }

    std::string Hoist()
    {
        std::string result;
        std::size_t position = 0;
        for (std::size_t i = 0; i < m_Tokens.size(); ++i)
        {
            const Declared declared = isLeaking(i) ? DeclaredBefore(i) : Declared::ByHand;
            if (declared == Declared::ByHand)
            {
                continue;
            }
            const std::string_view type = Text(i + 2);
            const std::size_t start = m_Tokens[FirstOfLoop(i)].Begin(m_Text);
            const std::size_t typeAt = m_Tokens[i + 2].Begin(m_Text);
            result.append(m_Text, position, start - position);
            if (declared == Declared::Nowhere)
            {
                result.append(type).append(" ").append(Text(i + 3)).append("; ");
            }
            result.append(m_Text, start, typeAt - start);
            position = typeAt + type.size();
        }
        return result.append(m_Text, position);
    }

private:
    enum class Declared
    {
        Nowhere,
        ByLoop, ///< by one whose variable is used after it
        ByHand,
    };

    std::string_view Text(std::size_t index) const
    {
        return index < m_Tokens.size() ? m_Tokens[index].text : std::string_view();
    }

    bool isWord(std::size_t index) const
    {
        return index < m_Tokens.size() && m_Tokens[index].isWord;
    }

    bool isBoundary(std::size_t index) const
    {
        return Text(index) == ";" || Text(index) == "{" || Text(index) == "}";
    }

    /// `for (int i = …; …)` after a whole statement, whose `i` somebody uses later.
    bool isLeaking(std::size_t index) const
    {
        if (Text(index) != "for" || Text(index + 1) != "(" || !isWord(index + 2) ||
            !isWord(index + 3) || Text(index + 4) != "=")
        {
            return false;
        }
        const std::size_t first = FirstOfLoop(index);
        return first > 0 && isBoundary(first - 1) && !hasCommaInHead(index + 4) &&
               isUsedAfter(EndOfStatement(index), Text(index + 3));
    }

    /// Attributes belong to the loop: `[unroll] for`.
    std::size_t FirstOfLoop(std::size_t index) const
    {
        while (index > 0 && Text(index - 1) == "]")
        {
            while (index > 0 && Text(--index) != "[")
            {
            }
        }
        return index;
    }

    bool hasCommaInHead(std::size_t index) const
    {
        const int depth = m_Depth[index];
        for (; index < m_Tokens.size() && Text(index) != ";"; ++index)
        {
            if (m_Depth[index] == depth && Text(index) == ",")
            {
                return true;
            }
        }
        return false;
    }

    int Step(std::size_t index) const
    {
        const std::string_view text = Text(index);
        return text == "(" || text == "{" || text == "["   ? 1
               : text == ")" || text == "}" || text == "]" ? -1
                                                           : 0;
    }

    /// The token after the bracket that closes the one at the index.
    std::size_t AfterBracket(std::size_t index) const
    {
        int depth = 0;
        for (; index < m_Tokens.size(); ++index)
        {
            depth += Step(index);
            if (depth <= 0)
            {
                return index + 1;
            }
        }
        return index;
    }

    /// The token after the statement that begins at the index.
    std::size_t EndOfStatement(std::size_t index) const
    {
        while (Text(index) == "[")
        {
            index = AfterBracket(index);
        }
        if (Text(index) == "{")
        {
            return AfterBracket(index);
        }
        if (Text(index) == "for" || Text(index) == "while" || Text(index) == "if")
        {
            const std::size_t end = EndOfStatement(AfterBracket(index + 1));
            return Text(end) == "else" ? EndOfStatement(end + 1) : end;
        }
        while (index < m_Tokens.size() && Text(index) != ";")
        {
            index = Step(index) > 0 ? AfterBracket(index) : index + 1;
        }
        return index + 1;
    }

    /// Whether the word at the index is what a declaration declares: `int i`, `int n, i`.
    bool isDeclaration(std::size_t index) const
    {
        if (index == 0 || isWord(index - 1))
        {
            return index > 0 && Text(index - 1) != "return" && Text(index - 1) != "else";
        }
        const int depth = m_Depth[index];
        std::size_t first = index;
        while (first > 0 && m_Depth[first - 1] >= depth &&
               !(m_Depth[first - 1] == depth && isBoundary(first - 1)))
        {
            --first;
        }
        return Text(index - 1) == "," && isWord(first) && isWord(first + 1) &&
               Text(first) != "return" && Text(first) != "else";
    }

    /// In what is left of the block, before the name is declared again.
    bool isUsedAfter(std::size_t index, std::string_view name) const
    {
        const int depth = index < m_Tokens.size() ? m_Depth[index] : 0;
        const int block = Text(index) == "}" ? depth + 1 : depth;
        for (; index < m_Tokens.size() && m_Depth[index] >= block; ++index)
        {
            if (Text(index) == name && Text(index - 1) != ".")
            {
                return !isDeclaration(index);
            }
        }
        return false;
    }

    /// In the function so far, its parameters included; loops that keep theirs to themselves aside.
    Declared DeclaredBefore(std::size_t index) const
    {
        const std::string_view name = Text(index + 3);
        Declared result = Declared::Nowhere;
        while (index-- > 0 && (m_Depth[index] > 0 || Text(index) == "{" || !isBoundary(index)))
        {
            if (Text(index) != name || !isDeclaration(index))
            {
                continue;
            }
            const bool isOfLoop = index > 2 && Text(index - 3) == "for";
            if (!isOfLoop)
            {
                return Declared::ByHand;
            }
            result = isLeaking(index - 3) ? Declared::ByLoop : result;
        }
        return result;
    }

    const std::string& m_Text;
    const std::vector<HlslToken> m_Tokens;
    std::vector<int> m_Depth; ///< by token: brackets around it, a bracket not within itself
};

} // namespace

std::string HoistLoopVariables(std::string text)
{
    return LoopHoister(text).Hoist();
}

} // namespace limn

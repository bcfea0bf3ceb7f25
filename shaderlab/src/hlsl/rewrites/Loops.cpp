#include "hlsl/rewrites/Rewrites.h"

#include "hlsl/Editor.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace limn
{

namespace
{

/// Whether `for (` stands anywhere.
bool hasLoops(std::string_view text)
{
    constexpr std::string_view k_For = "for";
    for (std::size_t at = text.find(k_For); at != text.npos; at = text.find(k_For, at + 1))
    {
        const std::size_t next = text.find_first_not_of(" \t\r\n", at + k_For.size());
        if (next != text.npos && text[next] == '(')
        {
            return true;
        }
    }
    return false;
}

class LoopHoister
{
public:
    explicit LoopHoister(const std::string& text) : m_Code(text)
    {
        int depth = 0;
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            depth += std::min(m_Code.Step(i), 0);
            m_Depth.push_back(depth);
            depth += std::max(m_Code.Step(i), 0);
        }
    }

    std::string Hoist()
    {
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            if (!isLeaking(i))
            {
                continue;
            }
            if (!isDeclaredByHand(i))
            {
                Hoist(i);
            }
            else if (isHiding(i))
            {
                HoistRenamed(i);
            }
        }
        return m_Code.Assemble();
    }

private:
    enum class Declared
    {
        Nowhere,
        ByLoop, ///< by one whose variable is used after it
        ByHand,
    };

    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }
    bool isWord(std::size_t index) const { return m_Code.isWord(index); }

    /// Puts the declarations of all its variables before the loop.
    void Hoist(std::size_t loop)
    {
        const std::string type(Text(loop + 2));
        std::string declarations;
        for (const std::size_t name : Names(loop))
        {
            if (DeclaredBefore(loop, Text(name)) == Declared::Nowhere)
            {
                declarations.append(type).append(" ").append(Text(name)).append("; ");
            }
        }
        m_Code.Spelling(FirstOfLoop(loop)).insert(0, declarations);
        m_Code.Spelling(loop + 2).clear();
    }

    /// The same under another name: one of this name is there already, and the compilers of old
    /// took the newest.
    void HoistRenamed(std::size_t loop)
    {
        const std::string_view name = Text(loop + 3);
        const std::string renamed = "limn_" + std::string(name) + std::to_string(loop);
        const std::string declaration = std::string(Text(loop + 2)) + " " + renamed + "; ";
        const int block = BlockDepth(EndOfStatement(loop));
        for (std::size_t i = loop; i < m_Code.size() && m_Depth[i] >= block; ++i)
        {
            if (Text(i) == name && Text(i - 1) != ".")
            {
                m_Code.Spelling(i) = renamed;
            }
        }
        m_Code.Spelling(FirstOfLoop(loop)).insert(0, declaration);
        m_Code.Spelling(loop + 2).clear();
    }

    /// Whether a loop hides a number by its only variable, and the name is used behind it. What has
    /// members is no number: it is the hidden one that is meant.
    bool isHiding(std::size_t loop) const
    {
        const std::vector<std::size_t> names = Names(loop);
        const std::string_view name = Text(names[0]);
        const std::size_t end = EndOfStatement(loop);
        const int block = BlockDepth(end);
        for (std::size_t i = names[0] + 1; i < m_Code.size() && m_Depth[i] >= block; ++i)
        {
            const bool isName = Text(i) == name && Text(i - 1) != ".";
            if (isName && (isDeclaration(i) || Text(i + 1) == "." || Text(i + 1) == "["))
            {
                return false;
            }
        }
        return names.size() == 1 && DeclaredBefore(loop, name) == Declared::ByHand;
    }

    bool isBoundary(std::size_t index) const
    {
        return Text(index) == ";" || Text(index) == "{" || Text(index) == "}";
    }

    /// What `for (int i = 0, j; …)` declares; empty for another head.
    std::vector<std::size_t> Names(std::size_t loop) const
    {
        if (Text(loop) != "for" || Text(loop + 1) != "(" || !isWord(loop + 2) ||
            !isWord(loop + 3) || Text(loop + 4) != "=")
        {
            return {};
        }
        std::vector<std::size_t> names = {loop + 3};
        const std::size_t end = m_Code.FindOutside(loop + 3, ";");
        for (std::size_t i = m_Code.FindOutside(loop + 3, ","); i < end;
             i = m_Code.FindOutside(i + 1, ","))
        {
            names.push_back(i + 1);
        }
        return names;
    }

    /// A loop after a whole statement, one of whose variables somebody uses later.
    bool isLeaking(std::size_t loop) const
    {
        const std::vector<std::size_t> names = Names(loop);
        const std::size_t first = FirstOfLoop(loop);
        if (names.empty() || first == 0 || !isBoundary(first - 1))
        {
            return false;
        }
        const std::size_t end = EndOfStatement(loop);
        return std::any_of(names.begin(), names.end(),
                           [&](std::size_t name) { return isUsedAfter(end, Text(name)); });
    }

    bool isDeclaredByHand(std::size_t loop) const
    {
        const std::vector<std::size_t> names = Names(loop);
        const std::size_t end = EndOfStatement(loop);
        return std::any_of(names.begin(), names.end(),
                           [&](std::size_t name)
                           {
                               return DeclaredBefore(loop, Text(name)) == Declared::ByHand ||
                                      isDeclaredAfter(end, Text(name));
                           });
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

    /// The token after the statement that begins at the index.
    std::size_t EndOfStatement(std::size_t index) const
    {
        while (Text(index) == "[")
        {
            index = m_Code.AfterBracket(index);
        }
        if (Text(index) == "{")
        {
            return m_Code.AfterBracket(index);
        }
        if (Text(index) == "for" || Text(index) == "while" || Text(index) == "if")
        {
            const std::size_t end = EndOfStatement(m_Code.AfterBracket(index + 1));
            return Text(end) == "else" ? EndOfStatement(end + 1) : end;
        }
        while (index < m_Code.size() && Text(index) != ";")
        {
            index = m_Code.Step(index) > 0 ? m_Code.AfterBracket(index) : index + 1;
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
        const std::size_t use = NextUse(index, name);
        return use < m_Code.size() && !isDeclaration(use);
    }

    /// In the same block, so that it cannot be declared before the loop as well.
    bool isDeclaredAfter(std::size_t index, std::string_view name) const
    {
        const std::size_t use = NextUse(index, name);
        return use < m_Code.size() && isDeclaration(use) && m_Depth[use] == BlockDepth(index);
    }

    /// Of the block that the statement before the token is in.
    int BlockDepth(std::size_t index) const
    {
        const int depth = index < m_Code.size() ? m_Depth[index] : 0;
        return Text(index) == "}" ? depth + 1 : depth;
    }

    std::size_t NextUse(std::size_t index, std::string_view name) const
    {
        const int block = BlockDepth(index);
        for (; index < m_Code.size() && m_Depth[index] >= block; ++index)
        {
            if (Text(index) == name && Text(index - 1) != ".")
            {
                return index;
            }
        }
        return m_Code.size();
    }

    /// The `(` around the token, else size().
    std::size_t BracketAround(std::size_t index) const
    {
        const int depth = m_Depth[index];
        while (index > 0 && m_Depth[index] >= depth && Text(index) != ";")
        {
            --index;
        }
        return Text(index) == "(" ? index : m_Code.size();
    }

    /// In the blocks around the loop so far, and in the function's parameters; loops that keep
    /// theirs to themselves aside.
    Declared DeclaredBefore(std::size_t loop, std::string_view name) const
    {
        Declared result = Declared::Nowhere;
        int open = m_Depth[loop];
        std::size_t index = loop;
        while (index-- > 0 && (m_Depth[index] > 0 || Text(index) == "{" || !isBoundary(index)))
        {
            open = std::min(open, m_Depth[index]);
            if (Text(index) != name || !isDeclaration(index))
            {
                continue;
            }
            const std::size_t bracket = BracketAround(index);
            const bool isOfLoop = bracket < m_Code.size() && Text(bracket - 1) == "for";
            const std::size_t place = isOfLoop ? bracket : index;
            const bool isParameter = bracket < m_Code.size() && !isOfLoop;
            if (m_Depth[place] > open && !isParameter)
            {
                continue; // in a block that has ended
            }
            if (!isOfLoop)
            {
                return Declared::ByHand;
            }
            result = isLeaking(bracket - 1) ? Declared::ByLoop : result;
        }
        return result;
    }

    HlslEditor m_Code;
    std::vector<int> m_Depth; ///< by token: brackets around it, a bracket not within itself
};

} // namespace

std::string HoistLoopVariables(std::string text)
{
    return hasLoops(text) ? LoopHoister(text).Hoist() : text;
}

} // namespace limn

#include "hlsl/rewrites/Rewrites.h"

#include "hlsl/Editor.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
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
    explicit LoopHoister(const std::string& text) : m_Code(text), m_Close(m_Code.size())
    {
        std::vector<std::size_t> open;
        std::vector<std::size_t> waiting; // for the bracket around them to close
        std::size_t start = 0;
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            if (m_Code.Step(i) < 0 && !open.empty())
            {
                for (; waiting.size() > open.back(); waiting.pop_back())
                {
                    m_Close[waiting.back()] = i;
                }
                open.pop_back();
            }
            m_Depth.push_back(static_cast<int>(open.size()));
            m_Start.push_back(start);
            waiting.push_back(i);
            if (m_Code.Step(i) > 0)
            {
                open.push_back(waiting.size());
            }
            start = open.empty() && isBoundary(i) ? i + 1 : start;
            if (isWord(i) && Text(i - 1) != ".")
            {
                m_Uses[Text(i)].push_back(i);
            }
        }
        for (const std::size_t i : waiting)
        {
            m_Close[i] = m_Code.size();
        }
    }

    std::string Hoist()
    {
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            if (Text(i) != "for" || !isLeaking(i))
            {
                continue;
            }
            m_Leaking.insert(i);
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

    struct Declaration
    {
        std::size_t name = 0;
        std::size_t place = 0; ///< the name, or of a loop's the bracket behind `for`
        bool isOfLoop = false;
        bool isParameter = false;
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
        for (const std::size_t use : Uses(name, loop, EndOfBlock(EndOfStatement(loop))))
        {
            m_Code.Spelling(use) = renamed;
        }
        m_Code.Spelling(FirstOfLoop(loop)).insert(0, declaration);
        m_Code.Spelling(loop + 2).clear();
    }

    /// Whether a loop hides a number by its only variable, and the name is used behind it. What has
    /// members is no number: it is the hidden one that is meant.
    bool isHiding(std::size_t loop)
    {
        const std::vector<std::size_t> names = Names(loop);
        const std::string_view name = Text(names[0]);
        for (const std::size_t use : Uses(name, names[0] + 1, EndOfBlock(EndOfStatement(loop))))
        {
            if (isDeclaration(use) || Text(use + 1) == "." || Text(use + 1) == "[")
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

    bool isDeclaredByHand(std::size_t loop)
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
        if (index > 0 && isWord(index - 1))
        {
            return Text(index - 1) != "return" && Text(index - 1) != "else";
        }
        if (Text(index - 1) != ",")
        {
            return false;
        }
        const int depth = m_Depth[index];
        std::size_t first = index;
        while (first > 0 && m_Depth[first - 1] >= depth &&
               !(m_Depth[first - 1] == depth && isBoundary(first - 1)))
        {
            --first;
        }
        return isWord(first) && isWord(first + 1) && Text(first) != "return" &&
               Text(first) != "else";
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
        return use < m_Code.size() && isDeclaration(use) && m_Depth[use] == m_Depth[index];
    }

    /// Of the block that the statement before the token is in: its `}`.
    std::size_t EndOfBlock(std::size_t index) const
    {
        return index >= m_Code.size() || Text(index) == "}" ? index : m_Close[index];
    }

    std::size_t NextUse(std::size_t index, std::string_view name) const
    {
        const std::span<const std::size_t> uses = Uses(name, index, EndOfBlock(index));
        return uses.empty() ? m_Code.size() : uses.front();
    }

    /// Where the name stands for a variable, from one token to the one before `end`.
    std::span<const std::size_t> Uses(std::string_view name, std::size_t begin,
                                      std::size_t end) const
    {
        const auto found = m_Uses.find(name);
        if (found == m_Uses.end())
        {
            return {};
        }
        const auto first = std::ranges::lower_bound(found->second, begin);
        return {first, std::lower_bound(first, found->second.end(), std::max(begin, end))};
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
    Declared DeclaredBefore(std::size_t loop, std::string_view name)
    {
        Declared result = Declared::Nowhere;
        const std::vector<Declaration>& all = Declarations(name);
        for (auto declaration =
                 std::ranges::lower_bound(all, m_Start[loop], {}, &Declaration::name);
             declaration != all.end() && declaration->name < loop; ++declaration)
        {
            const bool hasEnded = !declaration->isParameter && m_Close[declaration->place] < loop;
            if (!hasEnded && !declaration->isOfLoop)
            {
                return Declared::ByHand;
            }
            const bool isThere = !hasEnded && m_Leaking.contains(declaration->place - 1);
            result = isThere ? Declared::ByLoop : result;
        }
        return result;
    }

    /// Of each variable of the name in the file.
    const std::vector<Declaration>& Declarations(std::string_view name)
    {
        const auto [entry, isNew] = m_Declarations.try_emplace(name);
        if (isNew)
        {
            for (const std::size_t use : Uses(name, 0, m_Code.size()))
            {
                if (isDeclaration(use))
                {
                    const std::size_t bracket = BracketAround(use);
                    const bool isInBracket = bracket < m_Code.size();
                    const bool isOfLoop = isInBracket && Text(bracket - 1) == "for";
                    entry->second.push_back(
                        {use, isOfLoop ? bracket : use, isOfLoop, isInBracket && !isOfLoop});
                }
            }
        }
        return entry->second;
    }

    HlslEditor m_Code;
    // By token; a bracket is not within itself:
    std::vector<int> m_Depth;         ///< brackets around it
    std::vector<std::size_t> m_Close; ///< where the innermost of them closes, else size()
    std::vector<std::size_t> m_Start; ///< of the declaration at file scope that it is in
    std::unordered_map<std::string_view, std::vector<std::size_t>> m_Uses; ///< of words, no members
    std::unordered_map<std::string_view, std::vector<Declaration>> m_Declarations;
    std::unordered_set<std::size_t> m_Leaking; ///< loops so far
};

} // namespace

std::string HoistLoopVariables(std::string text)
{
    return hasLoops(text) ? LoopHoister(text).Hoist() : text;
}

} // namespace limn

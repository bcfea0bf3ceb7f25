#include "desugar/Rewrites.h"

#include <algorithm>
#include <map>
#include <utility>

namespace limn
{

namespace
{

class StaticTaker
{
public:
    explicit StaticTaker(TokenEdits& code) : m_Code(code) {}

    void Take()
    {
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            Count(Text(i));
            if (Text(i) == "struct" && m_Code.isWord(i + 1) && Text(i + 2) == "{")
            {
                TakeFrom(i);
            }
            else if (m_Statics.count(Text(i)) > 0)
            {
                SpellUse(i);
            }
            else if (const auto variable = m_Variables.find(Text(i)); variable != m_Variables.end())
            {
                SpellVariable(i, variable->second);
            }
        }
    }

private:
    /// Member → variable of the file or, of a method, its name with the struct's, without which
    /// glslang crashes or does not find it.
    using Names = std::map<std::string_view, std::string>;

    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }

    void TakeFrom(std::size_t index)
    {
        const std::string type(Text(index + 1));
        const std::size_t close = m_Code.AfterBracket(index + 2) - 1;
        Names names;
        std::set<std::size_t> declared; // methods
        std::string declarations;
        for (std::size_t begin = index + 3; begin < close;)
        {
            const std::size_t end = EndOfMember(begin, close);
            const std::size_t behind = BehindStatic(begin, end);
            if (behind != 0 && Text(behind) == "(")
            {
                declared.insert(behind - 1);
                names[Text(behind - 1)] = type + "::" + std::string(Text(behind - 1));
            }
            else if (behind != 0)
            {
                AddNames(begin, end, type, names);
                for (std::size_t i = begin; i < end; ++i)
                {
                    declarations.append(Spelt(i, names)).append(" ");
                }
                m_Code.Erase(begin, end);
            }
            begin = end;
        }
        if (names.empty())
        {
            return;
        }
        m_Code.Spelling(index).insert(0, declarations);
        for (std::size_t i = index + 3; i < close; ++i)
        {
            const bool isKept = m_Code.Spelling(i).empty() || declared.count(i) > 0;
            m_Code.Spelling(i) = isKept ? m_Code.Spelling(i) : Spelt(i, names);
        }
        m_Statics[Text(index + 1)] = std::move(names);
    }

    /// Behind the `;` of a variable or the body of a method.
    std::size_t EndOfMember(std::size_t index, std::size_t close) const
    {
        for (; index < close && Text(index) != ";"; ++index)
        {
            if (Text(index) == "{" && Text(index - 1) != "=")
            {
                return m_Code.AfterBracket(index);
            }
            index = m_Code.Step(index) > 0 ? m_Code.AfterBracket(index) - 1 : index;
        }
        return std::min(index + 1, close);
    }

    /// The token behind the words that come first if `static` is among them, else 0.
    std::size_t BehindStatic(std::size_t begin, std::size_t end) const
    {
        bool isStatic = false;
        for (; begin < end && m_Code.isWord(begin); ++begin)
        {
            isStatic = isStatic || Text(begin) == "static";
        }
        return isStatic ? begin : 0;
    }

    /// Adds the names of `static const float a = 1, b[2] = { 1, 2 };`.
    void AddNames(std::size_t begin, std::size_t end, const std::string& type, Names& names) const
    {
        while (begin < end)
        {
            while (m_Code.isWord(begin + 1) || Text(begin + 1) == "<")
            {
                begin = m_Code.isWord(begin + 1) ? begin + 1 : m_Code.FindOutside(begin, ">");
            }
            names[Text(begin)] = "limn_" + type + "_" + std::string(Text(begin));
            begin = m_Code.FindOutside(begin, ",") + 1;
        }
    }

    std::string Spelt(std::size_t index, const Names& names) const
    {
        const auto name = names.find(Text(index));
        const bool isOther = Text(index - 1) == "." || Text(index - 1) == "::";
        return name == names.end() || isOther ? std::string(Text(index)) : name->second;
    }

    /// `Type::member`, or the declaration of a variable: `Type v`.
    void SpellUse(std::size_t index)
    {
        if (Text(index + 1) == "::")
        {
            Spell(index, m_Statics[Text(index)], index + 2);
        }
        else if (m_Code.isWord(index + 1))
        {
            Declare(index + 1, &m_Statics[Text(index)]);
        }
    }

    /// `v.member`, or the declaration of a variable of another type, which hides the one before.
    void SpellVariable(std::size_t index, const std::vector<const Names*>& types)
    {
        const bool isMember = index > 0 && Text(index - 1) == ".";
        if (index > 0 && m_Code.isWord(index - 1) && Text(index - 1) != "return")
        {
            if (m_Statics.count(Text(index - 1)) == 0) // else SpellUse has
            {
                Declare(index, nullptr);
            }
        }
        else if (!isMember && Text(index + 1) == "." && !types.empty() && types.back())
        {
            Spell(index, *types.back(), index + 2);
        }
    }

    void Declare(std::size_t name, const Names* statics)
    {
        // Parameters belong to the block that follows.
        m_Declared.emplace_back(m_Blocks + (m_Parentheses > 0 ? 1 : 0), Text(name));
        m_Variables[Text(name)].push_back(statics);
    }

    /// Ends the variables of a block at its `}`.
    void Count(std::string_view mark)
    {
        m_Parentheses += mark == "(" ? 1 : mark == ")" ? -1 : 0;
        m_Blocks += mark == "{" ? 1 : mark == "}" ? -1 : 0;
        while (mark == "}" && !m_Declared.empty() && m_Declared.back().first > m_Blocks)
        {
            m_Variables[m_Declared.back().second].pop_back();
            m_Declared.pop_back();
        }
    }

    /// Puts what the member is now in the place of the tokens from `first` to it.
    void Spell(std::size_t first, const Names& names, std::size_t member)
    {
        if (const auto name = names.find(Text(member)); name != names.end())
        {
            m_Code.Erase(first, member);
            m_Code.Spelling(member) = name->second;
        }
    }

    TokenEdits& m_Code;
    std::map<std::string_view, Names> m_Statics; ///< by struct
    /// Name → the statics of its type, the newest declaration last; null = of another type.
    std::map<std::string_view, std::vector<const Names*>> m_Variables;
    std::vector<std::pair<int, std::string_view>> m_Declared; ///< depth of blocks, name
    int m_Blocks = 0;
    int m_Parentheses = 0;
};

class EnumSpeller
{
public:
    explicit EnumSpeller(TokenEdits& code) : m_Code(code) {}

    void Spell()
    {
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            if (m_Code.Text(i) == "enum")
            {
                i = SpellEnum(i);
            }
            else if (m_Types.count(m_Code.Text(i)) > 0)
            {
                SpellUse(i);
            }
        }
    }

private:
    using Names = std::map<std::string_view, std::string>; ///< enumerator → constant

    /// `enum class E : uint { A, B = 4, C };` becomes the declaration of constants. Gives its last
    /// token.
    std::size_t SpellEnum(std::size_t index)
    {
        const bool isClass = m_Code.Text(index + 1) == "class";
        const std::size_t name = index + (isClass ? 2 : 1);
        std::size_t open = m_Code.isWord(name) ? name + 1 : name;
        open += m_Code.Text(open) == ":" ? 2 : 0;
        if (m_Code.Text(open) != "{")
        {
            m_Code.Spelling(index).clear(); // `enum E e`
            return index;
        }
        m_Code.Erase(index, open + 1);
        m_Code.Spelling(index) = "static const int ";
        const std::size_t close = m_Code.AfterBracket(open) - 1;
        const std::string prefix =
            isClass ? "limn_" + std::string(m_Code.Text(name)) + "_" : std::string();
        m_Types[m_Code.isWord(name) ? m_Code.Text(name) : std::string_view()] =
            SpellEnumerators(open, close, prefix);
        m_Code.Spelling(close).clear();
        return close;
    }

    Names SpellEnumerators(std::size_t open, std::size_t close, const std::string& prefix)
    {
        Names names;
        std::string next = "0";
        for (std::size_t begin = open + 1; begin < close;)
        {
            const std::size_t end = std::min(m_Code.FindOutside(begin, ","), close);
            const std::string constant = prefix + std::string(m_Code.Text(begin));
            for (std::size_t i = begin + 1; i < end; ++i)
            {
                const auto earlier = names.find(m_Code.Text(i));
                m_Code.Spelling(i) = earlier == names.end() ? m_Code.Spelling(i) : earlier->second;
            }
            m_Code.Spelling(begin) = constant + (end == begin + 1 ? " = " + next : "");
            names[m_Code.Text(begin)] = constant;
            next = constant + " + 1";
            begin = end + 1;
        }
        if (m_Code.Text(close - 1) == ",")
        {
            m_Code.Spelling(close - 1).clear();
        }
        return names;
    }

    /// `E e` is `int e`, `E::A` is the constant.
    void SpellUse(std::size_t index)
    {
        const Names& names = m_Types[m_Code.Text(index)];
        const auto constant = names.find(m_Code.Text(index + 2));
        if (m_Code.Text(index + 1) == "::" && constant != names.end())
        {
            m_Code.Erase(index, index + 2);
            m_Code.Spelling(index + 2) = constant->second;
        }
        else if (index == 0 || m_Code.Text(index - 1) != ".")
        {
            m_Code.Spelling(index) = "int";
        }
    }

    TokenEdits& m_Code;
    std::map<std::string_view, Names> m_Types; ///< by name
};

} // namespace

void TakeStaticMembers(TokenEdits& code)
{
    StaticTaker(code).Take();
}

void TakeStructsOutOfBuffers(TokenEdits& code)
{
    for (std::size_t i = 0; i < code.size(); ++i)
    {
        if ((code.Text(i) != "cbuffer" && code.Text(i) != "tbuffer") || !code.isWord(i + 1))
        {
            continue;
        }
        const std::size_t open = code.FindOutside(i, "{");
        const std::size_t end = code.AfterBracket(open);
        for (std::size_t j = open + 1; j < end; ++j)
        {
            const bool isNamed = code.isWord(j + 1);
            const std::size_t members = j + (isNamed ? 2 : 1);
            if (code.Text(j) != "struct" || code.Text(members) != "{")
            {
                continue;
            }
            const std::size_t behind = code.AfterBracket(members);
            const std::string name =
                isNamed ? std::string(code.Text(j + 1)) : "limn_Struct" + std::to_string(j);
            code.Spelling(i).insert(0,
                                    "struct " + name + " " + code.Spelled(members, behind) + "; ");
            code.Erase(j, behind);
            code.Spelling(j) = code.isWord(behind) ? name : "";
            j = behind - 1;
        }
    }
}

void CopyBaseMembers(TokenEdits& code)
{
    std::map<std::string_view, std::string> members; // by the name of the struct
    for (std::size_t i = 0; i < code.size(); ++i)
    {
        if (code.Text(i) != "struct" || !code.isWord(i + 1))
        {
            continue;
        }
        const bool hasBase = code.Text(i + 2) == ":" && code.Text(i + 4) == "{";
        const std::size_t open = i + (hasBase ? 4 : 2);
        if (code.Text(open) != "{")
        {
            continue;
        }
        std::string& own = members[code.Text(i + 1)];
        own = code.Spelled(open + 1, code.AfterBracket(open) - 1);
        const auto base = hasBase ? members.find(code.Text(i + 3)) : members.end();
        if (base != members.end())
        {
            own = base->second + own;
            code.Erase(i + 2, open);
            code.Spelling(open) = "{ " + base->second;
        }
    }
}

void SpellEnums(TokenEdits& code)
{
    EnumSpeller(code).Spell();
}

} // namespace limn

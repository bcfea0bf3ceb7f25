#include "desugar/Rewrites.h"

#include "hlsl/TokenEdits.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace limn
{

namespace
{

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

void SpellEnums(TokenEdits& code)
{
    EnumSpeller(code).Spell();
}

} // namespace limn

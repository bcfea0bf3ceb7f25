#include "hlsl/Reach.h"

#include <algorithm>
#include <unordered_map>

namespace limn
{

namespace
{

class Finder
{
public:
    Finder(const HlslTokens& tokens, const HlslDeclarations& declarations) : m_Tokens(tokens)
    {
        for (const HlslFunction& function : declarations.functions)
        {
            m_ByName[function.name].push_back(&function);
        }
    }

    void Reach(std::string_view name, std::set<const HlslFunction*>& functions) const
    {
        std::vector<std::string_view> pending = {name};
        while (!pending.empty())
        {
            const auto found = m_ByName.find(pending.back());
            pending.pop_back();
            if (found == m_ByName.end())
            {
                continue;
            }
            for (const HlslFunction* function : found->second)
            {
                if (!functions.insert(function).second)
                {
                    continue;
                }
                for (std::size_t i = function->begin; i < function->end; ++i)
                {
                    if (m_Tokens.isWord(i))
                    {
                        pending.push_back(m_Tokens.Text(i));
                    }
                }
            }
        }
    }

private:
    const HlslTokens& m_Tokens;
    std::unordered_map<std::string_view, std::vector<const HlslFunction*>> m_ByName;
};

} // namespace

HlslReach::HlslReach(const HlslTokens& tokens, const HlslDeclarations& declarations,
                     std::string_view entry)
    : m_Tokens(tokens), m_IsLeftOut(tokens.size(), false)
{
    for (const HlslFunction& function : declarations.functions)
    {
        std::fill(m_IsLeftOut.begin() + static_cast<std::ptrdiff_t>(function.begin),
                  m_IsLeftOut.begin() + static_cast<std::ptrdiff_t>(function.end), true);
    }
    const Finder finder(tokens, declarations);
    finder.Reach(entry, m_Functions);
    for (std::size_t i = 0; i < tokens.size(); ++i)
    {
        if (!m_IsLeftOut[i] && tokens.isWord(i))
        {
            finder.Reach(tokens.Text(i), m_Functions);
        }
    }
    for (const HlslFunction* function : m_Functions)
    {
        std::fill(m_IsLeftOut.begin() + static_cast<std::ptrdiff_t>(function->begin),
                  m_IsLeftOut.begin() + static_cast<std::ptrdiff_t>(function->end), false);
    }
}

bool HlslReach::Names(std::string_view word) const
{
    return std::any_of(m_Functions.begin(), m_Functions.end(),
                       [&](const HlslFunction* function)
                       {
                           for (std::size_t i = function->begin; i < function->end; ++i)
                           {
                               if (m_Tokens.Text(i) == word)
                               {
                                   return true;
                               }
                           }
                           return false;
                       });
}

} // namespace limn

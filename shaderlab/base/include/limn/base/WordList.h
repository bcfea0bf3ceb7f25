#pragma once

#include <limn/base/Text.h>

#include <algorithm>
#include <string_view>
#include <unordered_set>

namespace limn
{

/// The words of a literal that blanks separate, told apart from others.
class WordList
{
public:
    explicit WordList(std::string_view text)
    {
        for (text = Trim(text); !text.empty(); text = Trim(text))
        {
            const std::size_t size = std::min(text.find(' '), text.size());
            m_Words.insert(text.substr(0, size));
            text.remove_prefix(size);
        }
    }

    bool Has(std::string_view word) const { return m_Words.contains(word); }
    bool HasStartOf(std::string_view word) const
    {
        return std::ranges::any_of(m_Words,
                                   [&](std::string_view start) { return word.starts_with(start); });
    }

private:
    std::unordered_set<std::string_view> m_Words;
};

} // namespace limn

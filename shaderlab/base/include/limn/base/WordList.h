#pragma once

#include <limn/base/Text.h>

#include <algorithm>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace limn
{

/// Returns the words of a literal, which blanks separate.
inline std::vector<std::string_view> SplitWords(std::string_view text)
{
    std::vector<std::string_view> words;
    for (auto word = TakeWord(text); !word.empty(); word = TakeWord(text))
    {
        words.push_back(word);
    }
    return words;
}

/// A set of the words of a literal, which blanks separate.
class WordList
{
public:
    explicit WordList(std::string_view text)
    {
        const auto words = SplitWords(text);
        m_Words.insert(words.begin(), words.end());
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

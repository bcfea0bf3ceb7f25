#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Returns the texts of a list, joined with `between` between each two.
/// @param textOf  returns an item's text
template <typename Items, typename TextOf = std::identity>
std::string Joined(const Items& items, std::string_view between, const TextOf& textOf = {})
{
    std::string text;
    for (const auto& item : items)
    {
        text.append(text.empty() ? "" : between).append(std::invoke(textOf, item));
    }
    return text;
}

/// Returns whether the word is one of the words.
inline bool IsIn(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::ranges::find(words, word) != words.end();
}

/// Adds the item if it is not in the list already.
template <typename List>
void AddOnce(const typename List::value_type& item, List& items)
{
    if (std::ranges::find(items, item) == items.end())
    {
        items.push_back(item);
    }
}

/// Returns the names of items. The items must outlive the result.
/// @param nameOf  returns an item's name, not a copy of it
template <typename Items, typename NameOf>
std::vector<std::string_view> NamesOf(const Items& items, const NameOf& nameOf)
{
    std::vector<std::string_view> names;
    std::ranges::transform(items, std::back_inserter(names), nameOf);
    return names;
}

} // namespace limn

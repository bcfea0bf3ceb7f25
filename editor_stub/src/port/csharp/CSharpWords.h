#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

namespace limn
{

/// A type that nobody said.
inline constexpr const char* k_UnknownType = "?";

inline bool IsIn(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::ranges::find(words, word) != words.end();
}

/// Words of the language, but for types, `new`, `this` and `base`.
bool IsCSharpKeyword(std::string_view word);

/// Of "T[]" and "List<T>" T.
std::string ElementType(const std::string& type);

} // namespace limn

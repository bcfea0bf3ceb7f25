#pragma once

#include <limn/base/Case.h>

#include <string_view>

namespace limn
{

constexpr bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}
constexpr bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

/// Returns whether a byte of UTF-8 does not begin a character.
constexpr bool isInsideCharacter(char c)
{
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

/// Returns whether a character can be part of a name.
constexpr bool isNameCharacter(char c)
{
    return isLetter(c) || isDigit(c);
}
/// Returns whether a character can be part of a word; Unity's ShaderLab counts '#' among the
/// letters.
constexpr bool isWordCharacter(char c)
{
    return isNameCharacter(c) || c == '#';
}

/// Returns the beginning of a text, up to the first character that does not fulfil the condition.
template <typename Condition>
constexpr std::string_view Beginning(std::string_view text, Condition condition)
{
    const auto end = std::ranges::find_if_not(text, condition);
    return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

inline constexpr std::string_view k_Blanks = " \t\r\n\f\v";

constexpr std::string_view Trim(std::string_view text)
{
    text.remove_prefix(Beginning(text, isBlank).size());
    while (!text.empty() && isBlank(text.back()))
    {
        text.remove_suffix(1);
    }
    return text;
}

/// Removes the first word from a text, together with the blanks before it, and returns it; returns
/// "" if there is none.
constexpr std::string_view TakeWord(std::string_view& text)
{
    text = Trim(text);
    const std::string_view word = text.substr(0, text.find_first_of(k_Blanks));
    text.remove_prefix(word.size());
    return word;
}

} // namespace limn

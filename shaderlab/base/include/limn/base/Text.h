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

/// Returns whether a character can be part of a word; Unity's ShaderLab counts '#' among the
/// letters.
constexpr bool isWordCharacter(char c)
{
    return isLetter(c) || isDigit(c) || c == '#';
}

constexpr std::string_view Trim(std::string_view text)
{
    while (!text.empty() && isBlank(text.front()))
    {
        text.remove_prefix(1);
    }
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
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n\f\v"));
    text.remove_prefix(word.size());
    return word;
}

} // namespace limn

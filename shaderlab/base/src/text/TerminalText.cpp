#include <limn/base/TerminalText.h>

#include <limn/base/Text.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace limn
{

namespace
{

constexpr std::size_t k_MaxWordBytes = 256; ///< of a message

bool isPrintable(std::uint32_t code)
{
    const bool isControl = code < 0x20 || (code >= 0x7F && code < 0xA0);
    const bool isBreakOrTurn =
        code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E);
    const bool isInvisible = code == 0x200B || (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF;
    return !isControl && !isBreakOrTurn && !isInvisible;
}

std::string EscapeCharacter(char byte, const DecodedCharacter& character)
{
    constexpr std::string_view k_Named = "\n\r\t";
    if (const std::size_t named = k_Named.find(byte); named != k_Named.npos)
    {
        return {'\\', "nrt"[named]};
    }
    char text[8];
    const bool isByte = character.size == 0 || character.code < 0x20;
    std::snprintf(text, sizeof(text), isByte ? "\\x%02X" : "\\u%04X",
                  isByte ? static_cast<unsigned char>(byte) : character.code);
    return text;
}

std::string Escaped(std::string_view text, std::string_view staying)
{
    std::string result;
    while (!text.empty())
    {
        const DecodedCharacter character = DecodeCharacter(text);
        const std::size_t size = std::max<std::size_t>(character.size, 1);
        const bool stays = staying.find(text[0]) != staying.npos ||
                           (character.size > 0 && isPrintable(character.code));
        result += stays ? std::string(text.substr(0, size)) : EscapeCharacter(text[0], character);
        text.remove_prefix(size);
    }
    return result;
}

/// Returns the first byte of the character that has a byte at `position`.
std::size_t StartOfCharacter(std::string_view text, std::size_t position)
{
    const std::size_t lowest = position > 3 ? position - 3 : 0;
    std::size_t start = position;
    while (start > lowest && isInsideCharacter(text[start]))
    {
        --start;
    }
    return isInsideCharacter(text[start]) ? position : start; // bytes that are no UTF-8 have none
}

} // namespace

DecodedCharacter DecodeCharacter(std::string_view text)
{
    const auto first = static_cast<unsigned char>(text.empty() ? '\xFF' : text[0]);
    const std::size_t size = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (first >= 0xF8 || size > text.size() || isInsideCharacter(text[0]))
    {
        return {};
    }
    std::uint32_t code = size == 1 ? first : first & (0x7Fu >> size);
    for (const char c : text.substr(1, size - 1))
    {
        if (!isInsideCharacter(c))
        {
            return {};
        }
        code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
    }
    constexpr std::uint32_t k_Lowest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool isCode =
        code >= k_Lowest[size] && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
    return isCode ? DecodedCharacter{code, size} : DecodedCharacter{};
}

std::string OneLine(std::string_view text)
{
    return Escaped(text, "");
}

std::string Sentence(std::string_view text)
{
    const std::string line = OneLine(text);
    std::string result;
    for (std::size_t begin = 0; begin <= line.size();)
    {
        const std::size_t end = std::min(line.find(' ', begin), line.size());
        result += Shortened(std::string_view(line).substr(begin, end - begin), k_MaxWordBytes);
        result += end < line.size() ? " " : "";
        begin = end + 1;
    }
    return result;
}

std::string SeveralLines(std::string_view text)
{
    return Escaped(text, "\n\t");
}

std::string Shortened(std::string_view text, std::size_t most)
{
    if (text.size() <= most)
    {
        return std::string(text);
    }
    const std::size_t begin = StartOfCharacter(text, most * 3 / 4);
    const std::size_t end = StartOfCharacter(text, text.size() - most / 4);
    return std::string(text.substr(0, begin)) + "…" + std::string(text.substr(end));
}

std::size_t PrintableSize(std::string_view text)
{
    const DecodedCharacter character = DecodeCharacter(text);
    return isPrintable(character.code) ? character.size : 0;
}

} // namespace limn

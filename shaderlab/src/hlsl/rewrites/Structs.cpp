#include "hlsl/rewrites/Rewrites.h"

#include "hlsl/Editor.h"

#include <map>
#include <string_view>

namespace limn
{

namespace
{

/// Whether `struct name :` stands anywhere.
bool hasBases(std::string_view text)
{
    constexpr std::string_view k_Struct = "struct";
    for (std::size_t at = text.find(k_Struct); at != text.npos;
         at = text.find(k_Struct, at + k_Struct.size()))
    {
        const std::size_t end = text.find_first_of("{;:", at);
        if (end != text.npos && text[end] == ':')
        {
            return true;
        }
    }
    return false;
}

/// The tokens in one line.
std::string Join(const HlslEditor& code, std::size_t first, std::size_t end)
{
    std::string result;
    for (; first < end; ++first)
    {
        result.append(code.Text(first)).append(" ");
    }
    return result;
}

} // namespace

std::string CopyBaseMembers(std::string text)
{
    if (!hasBases(text))
    {
        return text; // as nearly always
    }
    HlslEditor code(text);
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
        own = Join(code, open + 1, code.AfterBracket(open) - 1);
        const auto base = hasBase ? members.find(code.Text(i + 3)) : members.end();
        if (base != members.end())
        {
            own = base->second + own;
            code.Erase(i + 2, open);
            code.Spelling(open) = "{ " + base->second;
        }
    }
    return code.Assemble();
}

} // namespace limn

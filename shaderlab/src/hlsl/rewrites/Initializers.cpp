#include "hlsl/rewrites/Initializers.h"

#include "hlsl/Editor.h"
#include "text/Text.h"

#include <string_view>
#include <vector>

namespace limn
{

namespace
{

/// 12 of "float3x4", 2 of "int2", 0 of what is no vector or matrix.
std::size_t Components(std::string_view type)
{
    constexpr std::string_view k_Scalars[] = {"float", "int", "uint", "bool", "double"};
    const auto isSize = [](char c)
    {
        return c >= '1' && c <= '4';
    };
    for (const std::string_view scalar : k_Scalars)
    {
        const std::string_view rest =
            type.substr(0, scalar.size()) == scalar ? type.substr(scalar.size()) : "";
        if (rest.size() == 1 && isSize(rest[0]))
        {
            return static_cast<std::size_t>(rest[0] - '0');
        }
        if (rest.size() == 3 && isSize(rest[0]) && rest[1] == 'x' && isSize(rest[2]))
        {
            return static_cast<std::size_t>((rest[0] - '0') * (rest[2] - '0'));
        }
    }
    return 0;
}

/// Whether `] = {` stands anywhere.
bool hasArrayInitializers(std::string_view text)
{
    constexpr const char* k_Blanks = " \t\r\n";
    for (std::size_t at = text.find('{'); at != text.npos; at = text.find('{', at + 1))
    {
        const std::size_t mark = text.substr(0, at).find_last_not_of(k_Blanks);
        if (mark == text.npos || mark == 0 || text[mark] != '=')
        {
            continue;
        }
        const std::size_t before = text.substr(0, mark).find_last_not_of(k_Blanks);
        if (before != text.npos && text[before] == ']')
        {
            return true;
        }
    }
    return false;
}

/// The first tokens of what stands between the commas of `{ … }`, and the `}`. Empty where a list,
/// a call or a name is among it: then its author has grouped it.
std::vector<std::size_t> Numbers(const HlslEditor& code, std::size_t open)
{
    const std::size_t close = code.AfterBracket(open) - 1;
    std::vector<std::size_t> starts;
    for (std::size_t i = open + 1; i < close; ++i)
    {
        if (code.isWord(i) || code.Text(i) == "{")
        {
            return {};
        }
        if (code.Text(i - 1) == "," || i == open + 1)
        {
            starts.push_back(i);
        }
    }
    starts.push_back(close);
    return starts;
}

void Group(HlslEditor& code, std::string_view type, std::size_t components, std::size_t open,
           std::string_view dimension)
{
    const std::vector<std::size_t> starts = Numbers(code, open);
    const std::size_t count = starts.empty() ? 0 : starts.size() - 1;
    if (count == 0 || count % components != 0 || dimension == std::to_string(count))
    {
        return;
    }
    for (std::size_t i = 0; i < count; i += components)
    {
        const std::size_t next = starts[i + components];
        const std::size_t last = code.Text(next - 1) == "," ? next - 2 : next - 1;
        code.Spelling(starts[i]).insert(0, std::string(type) + "(");
        code.Spelling(last) += ")";
    }
}

} // namespace

std::string GroupInitializers(std::string text)
{
    if (!hasArrayInitializers(text))
    {
        return text; // as nearly always
    }
    HlslEditor code(text);
    for (std::size_t i = 0; i + 2 < code.size(); ++i)
    {
        const std::size_t components = code.Text(i + 2) == "[" ? Components(code.Text(i)) : 0;
        if (components < 2 || !code.isWord(i + 1))
        {
            continue;
        }
        const std::size_t behind = code.AfterBracket(i + 2);
        if (code.Text(behind) == "=" && code.Text(behind + 1) == "{")
        {
            Group(code, code.Text(i), components, behind + 1, code.Span(i + 3, behind - 1));
        }
    }
    return code.Assemble();
}

} // namespace limn

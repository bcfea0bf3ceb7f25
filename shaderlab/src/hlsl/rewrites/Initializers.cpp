#include "hlsl/rewrites/Rewrites.h"

#include "hlsl/Editor.h"
#include "text/Text.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace limn
{

namespace
{

/// 12 of "float3x4", 2 of "int2", 0 of what is no vector or matrix.
std::size_t Components(std::string_view type)
{
    constexpr std::string_view k_ComponentTypes[] = {"float", "int", "uint", "bool", "double"};
    const auto isSize = [](char c)
    {
        return c >= '1' && c <= '4';
    };
    for (const std::string_view scalar : k_ComponentTypes)
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

/// What stands between two commas of `{ … }`.
struct Item
{
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t components = 0; ///< 0 = not to be told without types
};

/// A number is one component, a list in brackets a whole element.
std::size_t ComponentsOf(const HlslEditor& code, const Item& item, std::size_t element)
{
    const auto isWhole = [&](std::size_t open)
    {
        return code.Step(open) > 0 && code.AfterBracket(open) == item.last + 1;
    };
    if (code.Text(item.first) == "{" && isWhole(item.first))
    {
        return element;
    }
    if (code.isWord(item.first) && isWhole(item.first + 1))
    {
        return Components(code.Text(item.first));
    }
    for (std::size_t i = item.first; i <= item.last; ++i)
    {
        if (code.isWord(i) || code.Text(i) == "{")
        {
            return 0;
        }
    }
    return 1;
}

std::vector<Item> Items(const HlslEditor& code, std::size_t open, std::size_t element)
{
    const std::size_t close = code.AfterBracket(open) - 1;
    std::vector<Item> items;
    for (std::size_t i = open + 1; i < close;)
    {
        const std::size_t comma = std::min(code.FindOutside(i, ","), close);
        Item item{i, std::max(comma, i + 1) - 1, 0};
        item.components = ComponentsOf(code, item, element);
        items.push_back(item);
        i = comma + 1;
    }
    return items;
}

/// Puts constructors around the runs of items that make up an element together; where there are
/// none, or the items do not tell, all stays.
void Group(HlslEditor& code, std::string_view type, std::size_t components, std::size_t open,
           std::string_view dimension)
{
    const std::vector<Item> items = Items(code, open, components);
    std::vector<std::pair<std::size_t, std::size_t>> groups; // first and last token
    std::size_t sum = 0;
    for (const Item& item : items)
    {
        if (sum == 0)
        {
            groups.emplace_back(item.first, item.last);
        }
        groups.back().second = item.last;
        if (item.components == 0 || sum + item.components > components)
        {
            return;
        }
        sum = (sum + item.components) % components;
        if (item.components == components)
        {
            groups.pop_back();
        }
    }
    if (sum != 0 || dimension == std::to_string(items.size()))
    {
        return;
    }
    for (const auto& [first, last] : groups)
    {
        code.Spelling(first).insert(0, std::string(type) + "(");
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

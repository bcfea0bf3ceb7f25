#include "port/PortLiteral.h"

#include "port/PortOperator.h"

#include <algorithm>
#include <array>
#include <map>

namespace limn
{

namespace
{

/// C++ once had characters that begin with ??.
std::string WithoutTrigraphs(std::string text)
{
    for (std::size_t at = text.find("??"); at != std::string::npos; at = text.find("??", at))
    {
        text.insert(++at, "\\");
    }
    return text;
}

} // namespace

std::optional<PortValue> NumberValue(std::string text)
{
    std::erase(text, '_');
    const bool isHex = text.starts_with("0x") || text.starts_with("0X");
    const char last = text.back();
    if (text.starts_with("0b") || text.starts_with("0B"))
    {
        return std::nullopt;
    }
    if (!isHex && (last == 'f' || last == 'F'))
    {
        text.pop_back();
        const bool isWhole = text.find_first_of(".eE") == std::string::npos;
        return PortValue{text + (isWhole ? ".0f" : "f"), "float", true};
    }
    const bool isUnsigned = last == 'u' || last == 'U';
    if (isUnsigned)
    {
        text.pop_back();
    }
    const bool isInt = text.find_first_not_of("0123456789") == std::string::npos || isHex;
    const bool isOctal = text.size() > 1 && text[0] == '0' && !isHex; // in C++ only
    const bool hasSuffix = text.find_first_of("uUlL") != std::string::npos;
    const bool isSmall = text.size() < 10;
    if (!isInt || isOctal || hasSuffix || !(isSmall || (isHex && text.size() == 10)))
    {
        return std::nullopt;
    }
    // 0xFFFFFFFF is a uint without saying so.
    return isSmall && !isUnsigned ? PortValue{text, "int", true}
                                  : PortValue{text + "u", "uint", true};
}

std::optional<PortValue> VectorValue(const std::string& type, const std::string& member)
{
    static const std::map<std::string_view, std::array<int, 4>> values = {
        {"zero", {0, 0, 0, 0}},  {"one", {1, 1, 1, 1}},    {"up", {0, 1, 0, 0}},
        {"down", {0, -1, 0, 0}}, {"right", {1, 0, 0, 0}},  {"left", {-1, 0, 0, 0}},
        {"back", {0, 0, -1, 0}}, {"forward", {0, 0, 1, 0}}};
    const auto value = values.find(member);
    const bool isVector = IsIn(type, {"Vector2", "Vector3", "Vector4"});
    const auto size = isVector ? static_cast<std::size_t>(type.back() - '0') : 0;
    const bool isAlong = member == "back" || member == "forward";
    const bool isAny = member == "zero" || member == "one";
    if (value == values.end() || size == 0 || (size == 4 && !isAny) || (size == 2 && isAlong))
    {
        return std::nullopt;
    }
    std::string text = type + "(";
    for (std::size_t i = 0; i < size; ++i)
    {
        text += (i == 0 ? "" : ", ") + std::to_string(value->second[i]) + ".0f";
    }
    return PortValue{text + ")", type};
}

std::optional<std::vector<CSharpWords>> NewArguments(CSharpWords words)
{
    for (std::size_t i = 0; i < words.size() && words.front().Is("new"); ++i)
    {
        if (words[i].Is("("))
        {
            return SplitArguments(words[i].Inside());
        }
    }
    return std::nullopt;
}

std::optional<std::string> PlainText(CSharpWords words)
{
    if (words.size() > 2 && words.size() % 2 == 1 && words[1].Is("+"))
    {
        const auto first = PlainText(words.first(1));
        const auto rest = PlainText(words.subspan(2));
        return first && rest ? std::optional(WithoutTrigraphs(*first + *rest)) : std::nullopt;
    }
    if (words.size() != 1 || words[0].kind != CSharpTokenKind::String)
    {
        return std::nullopt;
    }
    const std::string_view text = words[0].text;
    const bool isPlain = text.size() >= 2 && text[0] == '"' && !text.starts_with("\"\"\"");
    const std::string_view inner = isPlain ? text.substr(1, text.size() - 2) : "\\";
    for (std::size_t at = inner.find('\\'); at < inner.size(); at = inner.find('\\', at + 2))
    {
        if (at + 1 >= inner.size() ||
            std::string_view("\\\"nt").find(inner[at + 1]) == std::string_view::npos)
        {
            return std::nullopt;
        }
    }
    return WithoutTrigraphs(std::string(inner));
}

std::optional<PortValue> TextWithValues(const PortPlace& place, const CSharpToken& word,
                                        std::string& problem)
{
    const std::string_view text = word.text;
    std::string cpp;
    const auto add = [&](const std::string& part)
    {
        cpp += (cpp.empty() ? "" : " + ") + part;
    };
    bool isGood = text.starts_with("$\"") && text.find('\\') == std::string_view::npos &&
                  text.find("{{") == std::string_view::npos;
    for (std::size_t at = 2; isGood && at + 1 < text.size();)
    {
        const bool isHole = text[at] == '{';
        const std::size_t end = std::min(text.find(isHole ? '}' : '{', at), text.size() - 1);
        if (!isHole)
        {
            add("std::string(\"" + std::string(text.substr(at, end - at)) + "\")");
            at = end;
            continue;
        }
        const auto isInside = [&](const CSharpToken& part)
        {
            return part.offset > word.offset + at && part.offset < word.offset + end;
        };
        const auto first = std::ranges::find_if(word.hole, isInside);
        const auto behind = std::find_if_not(first, word.hole.end(), isInside);
        const auto value = Translate(place, {first, behind}, "", &problem);
        isGood = value && IsIn(value->type, {"string", "int", "uint"});
        add(!isGood                   ? ""
            : value->type == "string" ? "std::string(" + value->cpp + ")"
                                      : "std::to_string(" + value->cpp + ")");
        at = end + 1;
    }
    PortValue value{cpp.empty() ? "std::string()" : cpp, "string"};
    value.strength = Strength("+");
    return isGood ? std::optional(value) : std::nullopt;
}

std::optional<std::string> TranslateNumber(const PortModel& model, CSharpWords words)
{
    const auto value = Translate(model, {}, words, "");
    if (!value || (value->type != "int" && value->type != "float"))
    {
        return std::nullopt;
    }
    std::string text = value->cpp;
    if (value->type == "float" && text.ends_with("f"))
    {
        text.pop_back();
    }
    return text;
}

} // namespace limn

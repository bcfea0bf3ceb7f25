#include <limn/shaderlab/InitialKeywords.h>

#include "keywords/DynamicKeywords.h"
#include <limn/base/Text.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace limn
{

namespace
{

/// "Toggle(_X)": its name and what stands between the brackets.
struct Drawer
{
    std::string_view name;
    std::string_view arguments;
};

Drawer ReadDrawer(std::string_view text)
{
    const std::size_t open = std::min(text.find('('), text.size());
    const std::size_t close = text.rfind(')');
    const bool hasArguments = close != text.npos && close > open;
    return {Trim(text.substr(0, open)),
            hasArguments ? Trim(text.substr(open + 1, close - open - 1)) : std::string_view()};
}

/// Upper case, with `_` for blanks.
std::string KeywordName(std::string_view text)
{
    std::string name;
    for (const char c : text)
    {
        const bool isLower = c >= 'a' && c <= 'z';
        name += c == ' ' ? '_' : isLower ? static_cast<char>(c - 'a' + 'A') : c;
    }
    return name;
}

std::string EnumKeyword(const ShaderProperty& property, std::string_view names)
{
    const float value = std::round(property.defaultValue[0]);
    for (float index = 0.0f;; ++index)
    {
        const std::size_t comma = std::min(names.find(','), names.size());
        if (index == value)
        {
            return KeywordName(property.name + "_" + std::string(Trim(names.substr(0, comma))));
        }
        if (comma == names.size())
        {
            return {};
        }
        names.remove_prefix(comma + 1);
    }
}

/// "" where the attribute turns no keyword on.
std::string KeywordOf(const ShaderProperty& property, const Drawer& drawer)
{
    const bool isSet = property.defaultValue[0] != 0.0f;
    const bool isToggle = drawer.name == "Toggle" || drawer.name == "MaterialToggle";
    if (isToggle ? isSet : drawer.name == "ToggleOff" && !isSet)
    {
        return drawer.arguments.empty() ? KeywordName(property.name) + (isToggle ? "_ON" : "_OFF")
                                        : std::string(drawer.arguments);
    }
    return drawer.name == "KeywordEnum" ? EnumKeyword(property, drawer.arguments) : "";
}

std::vector<std::string> WithoutEmpty(std::set<std::string> keywords)
{
    keywords.erase("");
    return {keywords.begin(), keywords.end()};
}

} // namespace

std::vector<std::string> InitialKeywords(const ShaderLabDocument& document)
{
    return InitialKeywords(document.properties);
}

std::vector<std::string> InitialKeywords(std::span<const ShaderProperty> properties)
{
    std::set<std::string> keywords;
    for (const ShaderProperty& property : properties)
    {
        for (const ShaderAttribute& attribute : property.attributes)
        {
            keywords.insert(KeywordOf(property, ReadDrawer(attribute.text)));
        }
    }
    return WithoutEmpty(std::move(keywords));
}

std::vector<std::string> SelectVariant(const PassProgram& program,
                                       std::span<const std::string> enabled,
                                       std::span<const std::string> globalKeywords)
{
    const auto has = [](std::span<const std::string> keywords, const std::string& word)
    {
        return std::ranges::find(keywords, word) != keywords.end();
    };
    const auto dynamic = DynamicKeywords(program);
    std::set<std::string> keywords;
    for (const KeywordSet& set : program.keywordSets)
    {
        std::vector<std::string> words = set.keywords;
        std::erase_if(words, [&](const std::string& word) { return dynamic.count(word) > 0; });
        const auto chosen = std::ranges::find_if(
            words, [&](const std::string& word)
            { return has(enabled, word) || (!set.isLocal && has(globalKeywords, word)); });
        if (!words.empty())
        {
            keywords.insert(chosen == words.end() ? words.front() : *chosen);
        }
    }
    return WithoutEmpty(std::move(keywords));
}

} // namespace limn

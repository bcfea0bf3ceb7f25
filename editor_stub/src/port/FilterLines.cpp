#include "port/FilterLines.h"

#include "port/PortExpression.h"

#include <array>

namespace limn
{

namespace
{

/// One line of the three.
struct FilterLine
{
    const char* member;
    const char* type;
    std::string value;
};

/// What the C# hands over, in the order of the constructor of Unity's FilteringSettings.
struct FoundFilter
{
    const CSharpClass* owner = nullptr;
    CSharpWords words; ///< FilteringSettings(...)
    std::vector<CSharpWords> arguments;
};

void FindIn(CSharpWords words, const CSharpClass& owner, FoundFilter& found)
{
    for (std::size_t i = 0; i + 1 < words.size() && !found.owner; ++i)
    {
        if (words[i].Is("FilteringSettings") && words[i + 1].Is("(") && words[i + 1].match > 1)
        {
            const auto length = static_cast<std::size_t>(words[i + 1].match);
            found = {&owner, words.subspan(i, length + 2),
                     SplitArguments(words.subspan(i + 2, length - 1))};
        }
    }
}

FoundFilter FindFilter(const PortModel& model)
{
    FoundFilter found;
    for (const CSharpClass* one : model.classes())
    {
        for (const CSharpField& field : one->fields)
        {
            FindIn(field.value, *one, found);
        }
        for (const CSharpMethod& method : one->methods)
        {
            FindIn(method.body, *one, found);
        }
    }
    return found;
}

/// On one line of a comment.
std::string Flat(std::string_view text)
{
    std::string flat;
    for (const char c : text)
    {
        const bool isSpace = static_cast<unsigned char>(c) <= ' ';
        flat += !isSpace                              ? std::string(1, c == '\\' ? '/' : c)
                : !flat.empty() && flat.back() != ' ' ? " "
                                                      : "";
    }
    return flat;
}

} // namespace

std::string FilterLines(const PortModel& model)
{
    std::array<FilterLine, 3> lines = {
        {{"renderQueueRange", "RenderQueueRange", "RenderQueueRange::all"},
         {"layerMask", "LayerMask", "LayerMask::Everything()"},
         {"renderingLayerMask", "RenderingLayerMask", "RenderingLayerMask::Everything()"}}};
    const FoundFilter found = FindFilter(model);
    std::string text;
    if (found.owner)
    {
        text = "    // C#: " + model.Place(*found.owner, found.words.front().location) + ": " +
               Flat(TextOf(model.FileOf(*found.owner), found.words)) + "\n";
    }
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        const auto value = i < found.arguments.size()
                               ? Translate(model, {}, found.arguments[i], lines[i].type)
                               : std::nullopt;
        text += "    filtering." + std::string(lines[i].member) + " = " +
                (value ? value->cpp : lines[i].value) + ";\n";
    }
    return text;
}

} // namespace limn

#include "port/PortedCode.h"

#include "console/Texts.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Returns the lines without blanks at their ends, and without empty lines around them.
std::vector<std::string> LinesOf(std::string_view text)
{
    std::vector<std::string> lines = SplitText(std::string(text), '\n');
    for (std::string& line : lines)
    {
        line.resize(line.find_last_not_of("\r \t") + 1); // of -1 as well
    }
    const auto isFilled = [](const std::string& line)
    {
        return !line.empty();
    };
    lines.erase(lines.begin(), std::ranges::find_if(lines, isFilled));
    lines.erase(std::find_if(lines.rbegin(), lines.rend(), isFilled).base(), lines.end());
    return lines;
}

/// Spaces instead of tabs; no byte that a compiler warns of in a comment.
std::string Harmless(std::string_view line)
{
    std::string text;
    for (const char c : line)
    {
        const auto byte = static_cast<unsigned char>(c);
        text += c == '\t' ? "    " : byte < 0x20 || byte == 0x7f ? "?" : std::string(1, c);
    }
    for (const std::string_view mark :
         {"\xE2\x80\xAA", "\xE2\x80\xAB", "\xE2\x80\xAC", "\xE2\x80\xAD", "\xE2\x80\xAE",
          "\xE2\x81\xA6", "\xE2\x81\xA7", "\xE2\x81\xA8", "\xE2\x81\xA9"})
    {
        text = Replaced(std::move(text), mark, "?"); // turns the direction of what follows
    }
    const bool isContinued = text.ends_with("\\") || text.ends_with("?\?/");
    return isContinued ? text + " //" : text;
}

constexpr std::string_view k_Unused = "[[maybe_unused]] ";

/// Returns a line of code with nothing between its quotation marks.
std::string WithoutTexts(const std::string& line)
{
    std::string text;
    bool isInside = false;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
        const bool isMark = line[i] == '"' && (i == 0 || line[i - 1] != '\\');
        isInside = isInside != isMark;
        text += isInside && !isMark ? "" : std::string(1, line[i]);
    }
    return text;
}

/// Returns where the block ends in which something is known that is declared before `begin`.
/// @param isBefore  true if the block opens behind the declaration, as that of a parameter
std::size_t EndOfBlock(std::string_view code, std::size_t begin, bool isBefore)
{
    int depth = 0;
    for (std::size_t i = begin; i < code.size(); ++i)
    {
        depth += code[i] == '{' ? 1 : code[i] == '}' ? -1 : 0;
        if (depth < 0 || (isBefore && depth == 0 && code[i] == '}'))
        {
            return i;
        }
    }
    return code.size();
}

/// Returns the text with the headers in front of what it calls that few ports call.
std::string WithIncludes(std::string text, std::string_view before)
{
    static constexpr std::pair<std::string_view, std::string_view> k_Headers[] = {
        {"glm::row(", "glm/gtc/matrix_access.hpp"},
        {"glm::scale(", "glm/gtc/matrix_transform.hpp"},
        {"glm::translate(", "glm/gtc/matrix_transform.hpp"},
        {"glm::perspectiveRH_NO(", "glm/gtc/matrix_transform.hpp"},
        {"glm::orthoRH_NO(", "glm/gtc/matrix_transform.hpp"},
        {"std::numeric_limits<", "limits"},
        {"QualitySettings::", "limn/core/QualitySettings.h"},
        {"Random::", "limn/core/Random.h"},
        {"Resources::Load<", "limn/core/Resources.h"}};
    std::string includes;
    for (const auto& [call, header] : k_Headers)
    {
        const std::string line = "#include <" + std::string(header) + ">\n";
        const bool isNew = text.find(call) != std::string::npos && !includes.ends_with(line);
        includes += isNew ? line : "";
    }
    return text.insert(text.find(before), includes);
}

} // namespace

bool ReadsName(std::string_view code, std::string_view name, bool orSets)
{
    for (const std::string& line : SplitText(std::string(code), '\n'))
    {
        const std::string text = WithoutTexts(line.substr(0, line.find("// ")));
        for (std::size_t at = text.find(name); at != std::string_view::npos;
             at = text.find(name, at + 1))
        {
            const std::size_t end = at + name.size();
            const char before = at == 0 ? ' ' : text[at - 1];
            const bool isMember = before == '.' || (before == '>' && text[at - 2] == '-');
            const bool isWhole =
                !isMember && !IsNamePart(before) && (end == text.size() || !IsNamePart(text[end]));
            const bool isFirst = text.find_first_not_of(' ') == at;
            const std::size_t equals = text.find(" = ");
            const bool isSet =
                isFirst && equals != std::string_view::npos &&
                text.substr(end, equals - end).find_first_of("([") == std::string_view::npos;
            if (isWhole && (orSets || !isSet))
            {
                return true;
            }
        }
    }
    return false;
}

void PortedCode::TrimUnused(std::size_t begin)
{
    for (std::size_t at = text.find(k_Unused, begin); at != std::string::npos;
         at = text.find(k_Unused, at))
    {
        std::size_t end = at + k_Unused.size();
        for (int depth = 0; end < text.size(); ++end)
        {
            depth += text[end] == '<' ? 1 : text[end] == '>' ? -1 : 0;
            if (depth == 0 && IsIn(text.substr(end, 1), {",", ")", "=", ";", "{", ":"}) &&
                text[end + 1] != ':' && text[end - 1] != ':')
            {
                break;
            }
        }
        const std::size_t last = text.find_last_not_of(' ', end - 1);
        std::size_t first = last;
        while (IsNamePart(text[first - 1]))
        {
            --first;
        }
        const std::string name = text.substr(first, last + 1 - first);
        const bool isBefore = text[end] == ',' || text[end] == ')' || text[end] == ':';
        const std::size_t blockEnd = EndOfBlock(text, end, isBefore);
        if (ReadsName(std::string_view(text).substr(end, blockEnd - end), name))
        {
            text.erase(at, k_Unused.size());
        }
        ++at;
    }
}

void PortedCode::Line(std::string_view line)
{
    if (!line.empty())
    {
        text.append(m_Indent * 4, ' ').append(line);
    }
    text += '\n';
}

void PortedCode::Open(std::string_view line)
{
    if (!line.empty())
    {
        Line(line);
    }
    Line("{");
    ++m_Indent;
}

void PortedCode::Close(std::string_view end)
{
    --m_Indent;
    Line(end);
    for (std::size_t i = 0; m_Indent == 0 && i < m_Behind.size(); ++i)
    {
        Line(m_Behind[i]);
    }
    m_Behind.resize(m_Indent == 0 ? 0 : m_Behind.size());
}

void PortedCode::Comment(std::string_view csharp)
{
    std::vector<std::string> lines = LinesOf(csharp);
    std::ranges::transform(lines, lines.begin(), Harmless);
    std::size_t shared = std::string::npos;
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        const std::size_t indent = lines[i].find_first_not_of(' ');
        const bool isFirst = i == 0 && indent == 0; // cut out of its line
        shared = indent == std::string::npos || isFirst ? shared : std::min(shared, indent);
    }
    for (const std::string& line : lines)
    {
        const std::size_t cut = std::min({shared, line.find_first_not_of(' '), line.size()});
        Line(line.empty() ? "//" : "// " + line.substr(cut));
    }
}

void PortedCode::Todo(const std::string& why, const std::string& place, std::string_view csharp)
{
    Line("// TODO " + place + ": " + why);
    Comment(csharp);
}

void PortedCode::TodoBody(const std::string& why, const CSharpClass& one,
                          const CSharpMethod& method)
{
    Todo(why, m_Model.Place(one, method.location), BodyText(*one.file, method));
}

std::string InComment(std::string text)
{
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\\'; }, ' ');
    return text;
}

std::string_view BodyText(const CSharpFile& file, const CSharpMethod& method)
{
    if (method.isExpression)
    {
        return TextOf(file, method.body);
    }
    if (method.body.data() == nullptr) // abstract
    {
        return {};
    }
    const std::size_t begin = method.body.data()[-1].offset + 1;
    const std::size_t end = method.body.data()[method.body.size()].offset;
    return std::string_view(file.text).substr(begin, end - begin);
}

std::string PortedHeader(PortedCode& code)
{
    PortModel& model = code.model();
    code.text = "#pragma once\n\n#include <limn/core/ComputeShader.h>\n#include "
                "<limn/core/CurrentCamera.h>\n#include <limn/core/Debug.h>\n#include "
                "<limn/core/Mathf.h>\n#include <limn/core/NullCheck.h>\n#include "
                "<limn/core/RenderGraph.h>\n"
                "#include <limn/core/ScriptableRenderer.h>\n#include <limn/limn.h>\n\n";
    code.text += "// Written by `limn port` from " +
                 Joined(model.files(), ", ", [](const auto& file) { return file->name(); }) +
                 "; PORTING.md says what is left.\n\nnamespace " + model.name() +
                 "Plugin\n{\n\nusing namespace limn;\n\n";
    for (const CSharpClass* pass : model.TopLevel(PortRole::Pass))
    {
        code.Line("class " + model.ClassName(*pass) + ";");
    }
    std::vector<const CSharpClass*> types = model.TopLevel(PortRole::Enum);
    std::ranges::copy(model.TopLevel(PortRole::Data), std::back_inserter(types));
    std::ranges::copy(model.TopLevel(PortRole::Context), std::back_inserter(types));
    WriteTypes(code, types);
    for (const CSharpClass* component : model.TopLevel(PortRole::Component))
    {
        WriteComponent(code, *component);
        code.Line();
    }
    for (const CSharpClass* feature : model.TopLevel(PortRole::Feature))
    {
        WriteFeature(code, *feature);
        code.Line();
    }
    code.Line("} // namespace " + model.name() + "Plugin");
    return WithIncludes(std::move(code.text), "#include <limn/core/ComputeShader.h>");
}

std::string PortedSource(PortedCode& code)
{
    PortModel& model = code.model();
    const auto features = model.TopLevel(PortRole::Feature);
    code.text = "#include \"" + features.front()->name +
                ".h\"\n\n#include <limn/features/Plugin.h>\n\nnamespace " + model.name() +
                "Plugin\n{\n\n";
    for (const CSharpClass* one : model.classes())
    {
        const CSharpClass* outer = one->outer;
        const PortRole role = model.RoleOf(*one);
        const bool isNested = outer && (role == PortRole::Component || role == PortRole::Feature);
        if ((model.isLeftOut(*one) || isNested) && !(outer && model.isLeftOut(*outer)))
        {
            code.Todo("limn has nothing of this kind: " + one->keyword + " " + one->name,
                      model.Place(*one, one->location), TextOf(*one->file, one->words));
            code.Line();
        }
    }
    for (const CSharpClass* pass : model.Of(PortRole::Pass))
    {
        if (!model.isLeftOut(*pass))
        {
            WritePass(code, *pass);
        }
    }
    for (const CSharpClass* feature : features)
    {
        WriteFeatureMethods(code, *feature);
    }
    code.Line("} // namespace " + model.name() + "Plugin");
    code.Line();
    code.Open("LIMN_PLUGIN(features, components)");
    for (const PortRole role : {PortRole::Feature, PortRole::Component})
    {
        const std::string registry = role == PortRole::Feature ? "features" : "components";
        for (const CSharpClass* one : model.TopLevel(role))
        {
            code.Line(registry + ".Register<" + model.name() + "Plugin::" + model.ClassName(*one) +
                      ">(\"" + RegisteredName(*one) + "\");");
        }
    }
    code.Close();
    return WithIncludes(std::move(code.text), "#include <limn/features/Plugin.h>");
}

} // namespace limn

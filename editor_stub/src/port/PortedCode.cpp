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

} // namespace

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

std::vector<PortedAssignment> AssignmentsOf(CSharpWords body)
{
    std::vector<PortedAssignment> assignments;
    const CSharpToken* const end = body.data() + body.size();
    const CSharpToken* begin = body.data();
    const CSharpToken* equals = nullptr;
    for (const CSharpToken* at = begin; at < end; at = at->Behind())
    {
        if (at->Is("=") && !equals)
        {
            equals = at;
        }
        if (at->Is(";") || (at->Is("{") && !equals))
        {
            if (equals && equals > begin)
            {
                assignments.push_back({{begin, equals}, {equals + 1, at}});
            }
            begin = at->Behind();
            equals = nullptr;
        }
    }
    return assignments;
}

std::string PortedHeader(PortedCode& code)
{
    PortModel& model = code.model();
    code.text = "#pragma once\n\n#include <limn/core/ComputeShader.h>\n#include "
                "<limn/core/Mathf.h>\n#include <limn/core/RenderGraph.h>\n"
                "#include <limn/core/ScriptableRenderer.h>\n#include <limn/limn.h>\n\n";
    code.text += "// Begun by `limn port` from " +
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
    return std::move(code.text);
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
    return std::move(code.text);
}

} // namespace limn

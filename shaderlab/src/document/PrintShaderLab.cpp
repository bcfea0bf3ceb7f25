#include <limn/shaderlab/PrintShaderLab.h>

#include "document/PrintState.h"
#include <limn/base/Text.h>

#include <cstddef>
#include <string_view>

namespace limn
{

namespace
{

/// The include blocks in scope and the program itself as one text; each starts on a line of its
/// own.
std::string ProgramText(const PassProgram& program)
{
    std::string text;
    for (const SourceChunk& chunk : program.chunks)
    {
        const std::size_t line = text.rfind('\n');
        const std::string_view last = std::string_view(text).substr(line + 1);
        text += Trim(last).empty() ? "" : "\n";
        text += chunk.text;
    }
    return text;
}

std::string Quoted(const std::string& text)
{
    return "\"" + text + "\"";
}

class Printer
{
public:
    std::string Print(const ShaderLabDocument& document)
    {
        Line("Shader " + Quoted(document.name));
        Open();
        PrintProperties(document);
        for (const ShaderLabSubShader& subShader : document.subShaders)
        {
            PrintSubShader(subShader);
        }
        PrintEnd(document);
        Close();
        return std::move(m_Text);
    }

private:
    void Line(std::string_view text) { m_Text.append(m_Depth * 4, ' ').append(text) += '\n'; }
    void Open()
    {
        Line("{");
        ++m_Depth;
    }
    void Close()
    {
        --m_Depth;
        Line("}");
    }

    void PrintProperties(const ShaderLabDocument& document);
    void PrintSubShader(const ShaderLabSubShader& subShader);
    void PrintPass(const ShaderLabPass& pass);
    void PrintSurface(const ShaderLabPass& pass);
    void PrintGrabPass(const ShaderLabPass& pass);
    void PrintTags(const ShaderTags& tags);
    void PrintRequirements(const std::vector<PackageRequirement>& requirements);
    void PrintCommands(const ShaderLabPass& pass);
    void PrintProgram(const PassProgram& program);
    void PrintEnd(const ShaderLabDocument& document);

    std::string m_Text;
    std::size_t m_Depth = 0;
    // State around the next pass: what stands in front of a surface shader holds for what follows.
    RenderState m_State;
    std::size_t m_LegacyCommands = 0;
};

std::string TagsText(const ShaderTags& tags)
{
    std::string text = "Tags {";
    for (const ShaderTag& tag : tags.items)
    {
        text += " " + Quoted(tag.key) + " = " + Quoted(tag.value);
    }
    return text + " }";
}

void Printer::PrintProperties(const ShaderLabDocument& document)
{
    if (document.properties.empty())
    {
        return;
    }
    Line("Properties");
    Open();
    for (const ShaderProperty& property : document.properties)
    {
        std::string line;
        for (const ShaderAttribute& attribute : property.attributes)
        {
            line += "[" + attribute.text + "] ";
        }
        Line(line + property.name + "(" + Quoted(property.displayName) + ", " +
             PropertyTypeText(property) + ") = " + PropertyDefaultText(property));
    }
    Close();
}

void Printer::PrintSubShader(const ShaderLabSubShader& subShader)
{
    m_State = RenderState{};
    m_LegacyCommands = 0;
    Line("SubShader");
    Open();
    PrintRequirements(subShader.packageRequirements);
    PrintTags(subShader.tags);
    if (subShader.lod != 0)
    {
        Line("LOD " + std::to_string(subShader.lod));
    }
    for (const ShaderLabPass& pass : subShader.passes)
    {
        if (pass.kind == ShaderLabPassKind::UsePass)
        {
            Line("UsePass " + Quoted(pass.usePass));
        }
        else if (pass.kind == ShaderLabPassKind::GrabPass)
        {
            PrintGrabPass(pass);
        }
        else if (pass.isSurface)
        {
            PrintSurface(pass);
        }
        else
        {
            PrintPass(pass);
        }
    }
    Close();
}

void Printer::PrintGrabPass(const ShaderLabPass& pass)
{
    std::string line = "GrabPass {";
    line += pass.grabTexture.empty() ? "" : " " + Quoted(pass.grabTexture);
    line += pass.name.empty() ? "" : " Name " + Quoted(pass.name);
    line += pass.tags.items.empty() ? "" : " " + TagsText(pass.tags);
    Line(line + " }");
}

void Printer::PrintPass(const ShaderLabPass& pass)
{
    Line("Pass");
    Open();
    PrintRequirements(pass.packageRequirements);
    if (!pass.name.empty())
    {
        Line("Name " + Quoted(pass.name));
    }
    PrintTags(pass.tags);
    PrintCommands(pass);
    if (pass.program)
    {
        PrintProgram(*pass.program);
    }
    Close();
}

void Printer::PrintSurface(const ShaderLabPass& pass)
{
    PrintCommands(pass);
    m_State = pass.state;
    m_LegacyCommands = pass.legacyCommands.size();
    if (pass.program)
    {
        PrintProgram(*pass.program);
    }
}

void Printer::PrintTags(const ShaderTags& tags)
{
    if (!tags.items.empty())
    {
        Line(TagsText(tags));
    }
}

void Printer::PrintRequirements(const std::vector<PackageRequirement>& requirements)
{
    if (requirements.empty())
    {
        return;
    }
    std::string line = "PackageRequirements {";
    for (const PackageRequirement& requirement : requirements)
    {
        line += " " + Quoted(requirement.package);
        line += requirement.range.empty() ? "" : " : " + Quoted(requirement.range);
    }
    Line(line + " }");
}

void Printer::PrintCommands(const ShaderLabPass& pass)
{
    for (const std::string& command : StateCommands(pass.state, m_State))
    {
        Line(command);
    }
    for (std::size_t i = m_LegacyCommands; i < pass.legacyCommands.size(); ++i)
    {
        Line(pass.legacyCommands[i].text);
    }
}

void Printer::PrintProgram(const PassProgram& program)
{
    static constexpr const char* k_Names[] = {"HLSL", "CG", "GLSL"};
    const std::string name = k_Names[static_cast<std::size_t>(program.language)];
    Line(name + "PROGRAM" + ProgramText(program) + "END" + name);
}

void Printer::PrintEnd(const ShaderLabDocument& document)
{
    if (!document.fallback.empty())
    {
        Line("Fallback " + Quoted(document.fallback));
    }
    if (!document.customEditor.empty())
    {
        Line("CustomEditor " + Quoted(document.customEditor));
    }
    for (const PipelineEditor& editor : document.pipelineEditors)
    {
        Line("CustomEditorForRenderPipeline " + Quoted(editor.editor) + " " +
             Quoted(editor.pipelineAsset));
    }
    for (const ShaderDependency& dependency : document.dependencies)
    {
        Line("Dependency " + Quoted(dependency.name) + " = " + Quoted(dependency.shader));
    }
}

template <typename Items>
void ForgetPlaces(Items& items)
{
    for (auto& item : items)
    {
        item.location = {};
    }
}

ShaderLabPass WithoutPlaces(ShaderLabPass pass)
{
    pass.location = {};
    ForgetPlaces(pass.tags.items);
    ForgetPlaces(pass.packageRequirements);
    ForgetPlaces(pass.legacyCommands);
    if (pass.program)
    {
        // All else in a program is read from its text.
        PassProgram program;
        program.language = pass.program->language;
        program.chunks = {{ProgramText(*pass.program), 1}};
        pass.program = std::move(program);
    }
    return pass;
}

ShaderLabDocument WithoutPlaces(ShaderLabDocument document)
{
    document.file.clear();
    document.location = {};
    document.fallbackLocation = {};
    ForgetPlaces(document.properties);
    for (ShaderProperty& property : document.properties)
    {
        ForgetPlaces(property.attributes);
    }
    for (ShaderLabSubShader& subShader : document.subShaders)
    {
        subShader.location = {};
        ForgetPlaces(subShader.packageRequirements);
        ForgetPlaces(subShader.tags.items);
        for (ShaderLabPass& pass : subShader.passes)
        {
            pass = WithoutPlaces(std::move(pass));
        }
    }
    ForgetPlaces(document.pipelineEditors);
    ForgetPlaces(document.dependencies);
    return document;
}

} // namespace

std::string PropertyTypeText(const ShaderProperty& property)
{
    switch (property.type)
    {
    case ShaderPropertyType::Float:
        return "Float";
    case ShaderPropertyType::Range:
        return "Range(" + NumberToShaderLab(property.rangeMin) + ", " +
               NumberToShaderLab(property.rangeMax) + ")";
    case ShaderPropertyType::Int:
        return "Int";
    case ShaderPropertyType::Integer:
        return "Integer";
    case ShaderPropertyType::Color:
        return "Color";
    case ShaderPropertyType::Vector:
        return "Vector";
    case ShaderPropertyType::Texture:
        return property.textureType;
    }
    throw ContractError("ShaderPropertyType: unknown value");
}

std::string PropertyDefaultText(const ShaderProperty& property)
{
    const std::array<float, 4>& value = property.defaultValue;
    switch (property.type)
    {
    case ShaderPropertyType::Texture:
        return Quoted(property.defaultTexture) +
               (property.textureMode.empty() ? " {}" : " { " + property.textureMode + " }");
    case ShaderPropertyType::Color:
    case ShaderPropertyType::Vector:
        return "(" + NumberToShaderLab(value[0]) + ", " + NumberToShaderLab(value[1]) + ", " +
               NumberToShaderLab(value[2]) + ", " + NumberToShaderLab(value[3]) + ")";
    default:
        return NumberToShaderLab(value[0]);
    }
}

std::string PrintShaderLab(const ShaderLabDocument& document)
{
    return Printer().Print(document);
}

bool SameContent(const ShaderLabDocument& a, const ShaderLabDocument& b)
{
    return WithoutPlaces(a) == WithoutPlaces(b);
}

} // namespace limn

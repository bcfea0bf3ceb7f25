#include <limn/shaderlab/PrintShaderLab.h>

#include "document/StateNames.h"
#include <limn/base/Text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string_view>

namespace limn
{

namespace
{

/// Returns a number as ShaderLab writes it, without an exponent and with the fewest digits that
/// read back to the same float.
std::string NumberToShaderLab(float number)
{
    std::array<char, 128> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                      std::chars_format::fixed);
    return {buffer.data(), result.ptr};
}

using Lines = std::vector<std::string>;

template <typename T>
void Add(Lines& lines, const std::string& command, const StateValue<T>& value,
         const StateValue<T>& base)
{
    if (value != base)
    {
        lines.push_back(command + " " + StateText(value));
    }
}

std::string WriteMaskText(const PassBlendState& target)
{
    return ColorMaskText(target.writeMask);
}

/// The text of one command for each of the eight targets.
using TargetTexts = std::array<std::string, 8>;

TargetTexts TextsOf(const RenderState& state, std::string (*text)(const PassBlendState&))
{
    TargetTexts texts;
    std::ranges::transform(state.targets, texts.begin(), text);
    return texts;
}

/// The text that most targets have; of several, the one that comes first.
const std::string& MostFrequent(const TargetTexts& texts)
{
    return *std::ranges::max_element(
        texts, {}, [&](const std::string& text) { return std::ranges::count(texts, text); });
}

/// One line for all targets where that helps, then one for each target that differs from it.
template <typename Line>
void AddTargets(Lines& lines, const TargetTexts& texts, TargetTexts base, const Line& line)
{
    const bool isSameForAll = std::ranges::count(base, base[0]) == std::ssize(base);
    if (isSameForAll && MostFrequent(texts) != base[0])
    {
        base.fill(MostFrequent(texts));
        lines.push_back(line(base[0], ""));
    }
    for (std::size_t i = 0; i < texts.size(); ++i)
    {
        if (texts[i] != base[i])
        {
            lines.push_back(line(texts[i], std::to_string(i)));
        }
    }
}

void AddBlend(Lines& lines, const RenderState& state, const RenderState& base)
{
    const auto lineOf = [](const char* command)
    {
        return [command](const std::string& text, const std::string& target)
        {
            return std::string(command) + " " + target + (target.empty() ? "" : " ") + text;
        };
    };
    AddTargets(lines, TextsOf(state, BlendText), TextsOf(base, BlendText), lineOf("Blend"));
    AddTargets(lines, TextsOf(state, BlendOpText), TextsOf(base, BlendOpText), lineOf("BlendOp"));
    // Only ColorMask names its target last.
    AddTargets(lines, TextsOf(state, WriteMaskText), TextsOf(base, WriteMaskText),
               [](const std::string& text, const std::string& target)
               { return "ColorMask " + text + (target.empty() ? "" : " ") + target; });
}

template <typename T>
void AddFaces(Lines& lines, const std::string& command, const StateValue<T>& front,
              const StateValue<T>& back, const StateValue<T>& base)
{
    if (front == back)
    {
        Add(lines, "    " + command, front, base);
        return;
    }
    Add(lines, "    " + command + "Front", front, base);
    Add(lines, "    " + command + "Back", back, base);
}

void AddStencil(Lines& lines, const PassStencilState& stencil)
{
    const PassStencilState none;
    const StencilFaceState& front = stencil.front;
    const StencilFaceState& back = stencil.back;
    lines.push_back("Stencil");
    lines.push_back("{");
    Add(lines, "    Ref", stencil.reference, none.reference);
    Add(lines, "    ReadMask", stencil.readMask, none.readMask);
    Add(lines, "    WriteMask", stencil.writeMask, none.writeMask);
    AddFaces(lines, "Comp", front.compare, back.compare, none.front.compare);
    AddFaces(lines, "Pass", front.pass, back.pass, none.front.pass);
    AddFaces(lines, "Fail", front.fail, back.fail, none.front.fail);
    AddFaces(lines, "ZFail", front.zFail, back.zFail, none.front.zFail);
    lines.push_back("}");
}

/// Returns the commands that turn `base` into `state`, one per line. A Stencil block has several
/// lines and is indented by four spaces inside.
Lines StateCommands(const RenderState& state, const RenderState& base)
{
    Lines lines;
    Add(lines, "Cull", state.cull, base.cull);
    Add(lines, "ZClip", state.zClip, base.zClip);
    Add(lines, "ZTest", state.zTest, base.zTest);
    Add(lines, "ZWrite", state.zWrite, base.zWrite);
    if (state.offsetFactor != base.offsetFactor || state.offsetUnits != base.offsetUnits)
    {
        lines.push_back("Offset " + StateText(state.offsetFactor) + ", " +
                        StateText(state.offsetUnits));
    }
    Add(lines, "Conservative", state.conservative, base.conservative);
    AddBlend(lines, state, base);
    Add(lines, "AlphaToMask", state.alphaToMask, base.alphaToMask);
    if (state.stencil != base.stencil)
    {
        AddStencil(lines, state.stencil);
    }
    return lines;
}

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

std::string TagsText(const ShaderTags& tags)
{
    std::string text = "Tags {";
    for (const ShaderTag& tag : tags.items)
    {
        text += " " + Quoted(tag.key) + " = " + Quoted(tag.value);
    }
    return text + " }";
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

    void PrintProperties(const ShaderLabDocument& document)
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

    void PrintSubShader(const ShaderLabSubShader& subShader)
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

    void PrintPass(const ShaderLabPass& pass)
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

    void PrintSurface(const ShaderLabPass& pass)
    {
        PrintCommands(pass);
        m_State = pass.state;
        m_LegacyCommands = pass.legacyCommands.size();
        if (pass.program)
        {
            PrintProgram(*pass.program);
        }
    }

    void PrintGrabPass(const ShaderLabPass& pass)
    {
        std::string line = "GrabPass {";
        line += pass.grabTexture.empty() ? "" : " " + Quoted(pass.grabTexture);
        line += pass.name.empty() ? "" : " Name " + Quoted(pass.name);
        line += pass.tags.items.empty() ? "" : " " + TagsText(pass.tags);
        Line(line + " }");
    }

    void PrintTags(const ShaderTags& tags)
    {
        if (!tags.items.empty())
        {
            Line(TagsText(tags));
        }
    }

    void PrintRequirements(const std::vector<PackageRequirement>& requirements)
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

    void PrintCommands(const ShaderLabPass& pass)
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

    void PrintProgram(const PassProgram& program)
    {
        static constexpr const char* k_Names[] = {"HLSL", "CG", "GLSL"};
        const std::string name = k_Names[static_cast<std::size_t>(program.language)];
        Line(name + "PROGRAM" + ProgramText(program) + "END" + name);
    }

    void PrintEnd(const ShaderLabDocument& document)
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

    std::string m_Text;
    std::size_t m_Depth = 0;
    // State around the next pass: what stands in front of a surface shader holds for what follows.
    RenderState m_State;
    std::size_t m_LegacyCommands = 0;
};

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

/// ZTest is off by the name of Unity's enum, which no other list has.
std::string StateText(const StateValue<CullMode>& value)
{
    return NameOf(k_CullModes, value);
}
std::string StateText(const StateValue<CompareFunction>& value)
{
    return NameOf(k_DepthTests, value);
}
std::string StateText(const StateValue<bool>& value)
{
    return NameOf(k_Bools, value);
}
std::string StateText(const StateValue<BlendMode>& value)
{
    return NameOf(k_BlendModes, value);
}
std::string StateText(const StateValue<BlendOp>& value)
{
    return NameOf(k_BlendOps, value);
}
std::string StateText(const StateValue<StencilOp>& value)
{
    return NameOf(k_StencilOps, value);
}
std::string StateText(const StateValue<int>& value)
{
    return value.property.empty() ? std::to_string(value.value) : "[" + value.property + "]";
}

std::string ColorMaskText(const StateValue<int>& mask)
{
    if (!mask.property.empty())
    {
        return "[" + mask.property + "]";
    }
    std::string letters;
    letters += (mask.value & ColorWriteMask::Red) != 0 ? "R" : "";
    letters += (mask.value & ColorWriteMask::Green) != 0 ? "G" : "";
    letters += (mask.value & ColorWriteMask::Blue) != 0 ? "B" : "";
    letters += (mask.value & ColorWriteMask::Alpha) != 0 ? "A" : "";
    return letters.empty() ? "0" : letters;
}

std::string StateText(const StateValue<float>& value)
{
    return value.property.empty() ? NumberToShaderLab(value.value) : "[" + value.property + "]";
}

std::string BlendText(const PassBlendState& target)
{
    if (!target.enabled)
    {
        return "Off";
    }
    std::string text =
        StateText(target.sourceColorBlendMode) + " " + StateText(target.destinationColorBlendMode);
    if (target.sourceAlphaBlendMode != target.sourceColorBlendMode ||
        target.destinationAlphaBlendMode != target.destinationColorBlendMode)
    {
        text += ", " + StateText(target.sourceAlphaBlendMode) + " " +
                StateText(target.destinationAlphaBlendMode);
    }
    return text;
}

std::string BlendOpText(const PassBlendState& target)
{
    const std::string color = StateText(target.colorBlendOperation);
    return target.alphaBlendOperation == target.colorBlendOperation
               ? color
               : color + ", " + StateText(target.alphaBlendOperation);
}

std::string BlendOpName(BlendOp op)
{
    return StateText(StateValue<BlendOp>(op));
}

std::string PropertyTypeText(const ShaderProperty& property)
{
    if (property.type == ShaderPropertyType::Texture)
    {
        return property.textureType;
    }
    const auto* const found =
        std::ranges::find(k_PropertyTypes, property.type, &PropertyTypeName::type);
    if (found == std::end(k_PropertyTypes))
    {
        throw ContractError("ShaderPropertyType: unknown value");
    }
    const std::string name(found->name);
    return property.type == ShaderPropertyType::Range
               ? name + "(" + NumberToShaderLab(property.rangeMin) + ", " +
                     NumberToShaderLab(property.rangeMax) + ")"
               : name;
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

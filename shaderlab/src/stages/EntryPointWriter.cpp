#include "stages/EntryPointWriter.h"

#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

namespace
{

constexpr const char* k_InputType = "limn_Input";
constexpr const char* k_Input = "limn_input";
constexpr const char* k_Stream = "limn_stream";

/// Returns the type that the pipeline gives a system value, whatever type the author declares.
std::string SystemType(const StageValue& value)
{
    if (value.semantic == "SV_POSITION" || value.semantic == "SV_TARGET")
    {
        return TypeName(value.semantic == "SV_TARGET" ? value.scalar : "float", 4);
    }
    if (value.semantic == "SV_ISFRONTFACE")
    {
        return "bool";
    }
    const bool isFloat = value.semantic.find("DISTANCE") != std::string::npos ||
                         value.semantic.find("DEPTH") != std::string::npos ||
                         value.semantic == "PSIZE";
    return isFloat ? "float" : "uint";
}

/// Returns the number of components of a type: 3 for "float3".
int ComponentsOf(const std::string& type)
{
    return type.back() >= '2' && type.back() <= '4' ? type.back() - '0' : 1;
}

/// Returns `source`, which has `components`, as another vector type: truncated, or filled up with
/// zeros.
std::string ConvertText(const std::string& source, int components, const std::string& scalar,
                        int wanted)
{
    const std::string type = TypeName(scalar, wanted);
    if (wanted <= components)
    {
        const std::string swizzle = std::string("xyzw").substr(0, static_cast<std::size_t>(wanted));
        return "(" + type + ")" + source + (wanted < components ? "." + swizzle : "");
    }
    std::string text = type + "(" + source;
    for (int i = components; i < wanted; ++i)
    {
        text += ", 0";
    }
    return text + ")";
}

/// Returns the semantic of a system value, with its index if indices count: "SV_TARGET1".
std::string SystemSemantic(const StageValue& value)
{
    return value.semantic + (value.semantic == "SV_TARGET" ? std::to_string(value.index) : "");
}

/// Returns attribute, type, name and semantic of a varying; both sides of a border declare it with
/// this text.
///
/// @param modifiers  the modifiers between attribute and type, "" or with a blank at the end
std::string VaryingText(const Varying& varying, const std::string& name,
                        const std::string& modifiers)
{
    const std::string location = std::to_string(varying.location);
    return "[[vk::location(" + location + ")]] " + modifiers +
           TypeName(varying.scalar, varying.components) + " " + name + " : LIMN" + location;
}

bool isUnwritten(const StageBorder& border, const StageValue& value)
{
    return !value.isSystemValue &&
           std::ranges::find(border.unwritten, value.semanticName()) != border.unwritten.end();
}

/// Returns scalar and number of components of a value as the border has it.
Varying AtBorder(const StageValue& value, const StageBorder& border)
{
    if (!value.isSystemValue)
    {
        return border.Find(value.semanticName());
    }
    const std::string type = SystemType(value);
    return {"", type.substr(0, type.find_first_of("234")), ComponentsOf(type), 0};
}

/// Returns the call of the author's function.
std::string CallText(const HlslFunction& function)
{
    std::string text;
    if (function.returnType != "void")
    {
        text += std::string(function.returnType) + " " + std::string(k_ResultName) + " = ";
    }
    text += AuthorFunctionName(function.name) + "(";
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
    {
        text += i == 0 ? "" : ", ";
        text += isStream(function.parameters[i].type) ? k_Stream : ArgumentName(i);
    }
    return text + ");\n";
}

/// Returns the generated function.
/// @param attributes  the lines before it, "" or with a line break at the end
std::string EntryText(const std::string& attributes, const std::string& parameters,
                      const std::string& body)
{
    return "\n#line 1 \"" + std::string(k_EntryFile) + "\"\n" + attributes + "void " +
           std::string(k_EntryName) + "(" + parameters + ")\n{\n" + body + "}\n";
}

/// Returns the declarations of a local variable for each parameter of the author's function, except
/// streams.
std::string ArgumentLocals(const StageInterface& interface)
{
    std::string text;
    const auto& parameters = interface.function->parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
    {
        if (isStream(parameters[i].type))
        {
            continue;
        }
        text += std::string(parameters[i].type) + " " + ArgumentName(i);
        for (const std::string_view size : parameters[i].dimensions)
        {
            text += "[" + std::string(size) + "]";
        }
        text += ";\n";
    }
    return text;
}

const std::string k_FirstInstance = "limn_FirstInstance";

std::string DrawIndexText(const std::string& index)
{
    return "limn_DrawIndex = limn_Instances[" + index + "];\n";
}

class EntryWriter
{
public:
    EntryWriter(const StageInterface& interface, const StageLinkage& linkage, ShaderStage stage)
        : m_Interface(interface), m_Linkage(linkage), m_Stage(stage)
    {
    }

    std::string Compose(const std::string& prologue, bool usesDrawIndex)
    {
        for (const StageValue& value : m_Interface.inputs)
        {
            AddInput(value);
        }
        for (const StageValue& value : m_Interface.outputs)
        {
            AddOutput(value);
        }
        if (usesDrawIndex)
        {
            m_DrawIndex =
                DrawIndexText(m_Stage == ShaderStage::Vertex ? InstanceIndex() : k_FirstInstance);
        }
        return EntryText("", m_Parameters,
                         m_DrawIndex + prologue + ArgumentLocals(m_Interface) + m_Before +
                             CallText(*m_Interface.function) + m_After);
    }

private:
    std::string NextName() { return "limn_p" + std::to_string(m_Count++); }

    void AddParameter(const std::string& text)
    {
        m_Parameters += (m_Parameters.empty() ? "" : ", ") + text;
    }

    /// Returns the index of the instance on the device. There is one parameter per semantic,
    /// because two members may ask for the same system value.
    const std::string& InstanceIndex()
    {
        if (m_InstanceIndex.empty())
        {
            m_InstanceIndex = NextName();
            AddParameter("uint " + m_InstanceIndex + " : SV_InstanceID");
        }
        return m_InstanceIndex;
    }

    void AddInput(const StageValue& value)
    {
        const bool isVertex = m_Stage == ShaderStage::Vertex;
        if (isVertex && value.semantic == "SV_INSTANCEID")
        {
            Read(value, "(" + InstanceIndex() + " - limn_InstanceBase)", 1);
        }
        else if (value.isSystemValue)
        {
            const std::string name = NextName();
            const std::string type = SystemType(value);
            AddParameter(type + " " + name + " : " + value.semantic);
            // VFACE is a number: positive for front faces.
            const bool isFace = type == "bool" && value.scalar == "float";
            Read(value, isFace ? "(" + name + " ? 1.0 : -1.0)" : name, ComponentsOf(type));
        }
        else if (isVertex)
        {
            AddAttribute(value);
        }
        else
        {
            AddVaryingInput(value);
        }
    }

    void AddAttribute(const StageValue& value)
    {
        const std::string name = NextName();
        const std::string semantic = value.semanticName();
        const auto input =
            std::ranges::find(m_Linkage.vertexInputs, semantic, &VertexInput::semantic);
        AddParameter("[[vk::location(" + std::to_string(input->location) + ")]] " +
                     TypeName(value.scalar, value.components) + " " + name + " : " + semantic);
        Read(value, name, value.components);
    }

    void AddVaryingInput(const StageValue& value)
    {
        const StageBorder& border = m_Linkage.Before(m_Stage);
        if (isUnwritten(border, value))
        {
            m_Before += value.expression + " = 0;\n";
            return;
        }
        const Varying& varying = border.Find(value.semanticName());
        const std::string name = NextName();
        const bool isFlat = varying.scalar != "float";
        AddParameter(VaryingText(varying, name, isFlat ? "nointerpolation " : value.interpolation));
        Read(value, name, varying.components);
    }

    void AddOutput(const StageValue& value)
    {
        const std::string name = NextName();
        const Varying target = AtBorder(value, m_Linkage.Behind(m_Stage));
        AddParameter(value.isSystemValue
                         ? "out " + SystemType(value) + " " + name + " : " + SystemSemantic(value)
                         : VaryingText(target, name, "out "));
        m_After +=
            name + " = " +
            ConvertText(value.expression, value.components, target.scalar, target.components) +
            ";\n";
    }

    void Read(const StageValue& value, const std::string& source, int components)
    {
        m_Before += value.expression + " = " +
                    ConvertText(source, components, value.scalar, value.components) + ";\n";
    }

    const StageInterface& m_Interface;
    const StageLinkage& m_Linkage;
    ShaderStage m_Stage;
    int m_Count = 0;
    std::string m_InstanceIndex;
    std::string m_Parameters;
    std::string m_DrawIndex;
    std::string m_Before;
    std::string m_After;
};

std::string MemberName(std::size_t index)
{
    return "limn_p" + std::to_string(index);
}

std::string Struct(const std::string& name, const std::vector<StageValue>& values,
                   const StageBorder& border)
{
    std::string text = "struct " + name + " { ";
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        if (isUnwritten(border, values[i]))
        {
            continue;
        }
        text +=
            values[i].isSystemValue
                ? SystemType(values[i]) + " " + MemberName(i) + " : " + SystemSemantic(values[i])
                : VaryingText(border.Find(values[i].semanticName()), MemberName(i), "");
        text += "; ";
    }
    return text + "}; ";
}

std::string ReadInput(const StageInterface& interface, const StageBorder& border)
{
    std::string text;
    for (std::size_t i = 0; i < interface.inputs.size(); ++i)
    {
        const StageValue& value = interface.inputs[i];
        const std::string source =
            std::string(k_Input) + "[" + std::string(k_InputIndex) + "]." + MemberName(i);
        text +=
            value.expression + " = " +
            (isUnwritten(border, value) ? "0"
                                        : ConvertText(source, AtBorder(value, border).components,
                                                      value.scalar, value.components)) +
            ";\n";
    }
    return text;
}

/// Returns the HLSL of a function k_EntryName that calls the author's geometry function.
std::string WriteGeometryEntry(const StageInterface& interface, const StageLinkage& linkage,
                               const std::string& prologue)
{
    const GeometrySignature& geometry = *interface.geometry;
    const std::string count = std::to_string(geometry.inputVertices);
    std::string parameters =
        std::string(geometry.primitive) + " " + k_InputType + " " + k_Input + "[" + count + "]";
    std::string before;
    for (std::size_t i = 0; i < interface.primitiveInputs.size(); ++i)
    {
        const StageValue& value = interface.primitiveInputs[i];
        const std::string name = "limn_value" + std::to_string(i);
        parameters += ", " + SystemType(value) + " " + name + " : " + value.semantic;
        before += value.expression + " = (" + value.scalar + ")" + name + ";\n";
    }
    parameters += ", inout " + std::string(geometry.stream) + "<" + std::string(k_GeometryOutput) +
                  "> " + k_Stream;

    std::string attributes;
    for (const std::string_view attribute : interface.function->attributes)
    {
        attributes.append(attribute);
    }
    const std::string index(k_InputIndex);
    return EntryText(attributes + "\n", parameters,
                     prologue + ArgumentLocals(interface) + before + "for (int " + index +
                         " = 0; " + index + " < " + count + "; ++" + index + ")\n{\n" +
                         ReadInput(interface, linkage.Before(ShaderStage::Geometry)) + "}\n" +
                         CallText(*interface.function));
}

} // namespace

std::string AuthorFunctionName(std::string_view name)
{
    return name == k_TakenName ? "limn_AuthorMain" : std::string(name);
}

std::string WriteEntryPoint(const StageInterface& interface, const StageLinkage& linkage,
                            ShaderStage stage, const std::string& prologue, bool usesDrawIndex)
{
    if (interface.geometry)
    {
        return WriteGeometryEntry(interface, linkage,
                                  (usesDrawIndex ? DrawIndexText(k_FirstInstance) : "") + prologue);
    }
    return EntryWriter(interface, linkage, stage).Compose(prologue, usesDrawIndex);
}

std::string WriteGeometryTypes(const StageInterface& interface, const StageLinkage& linkage)
{
    const StageBorder& border = linkage.Behind(ShaderStage::Geometry);
    const std::string output(k_GeometryOutput);
    std::string text = Struct(k_InputType, interface.inputs, linkage.Before(ShaderStage::Geometry));
    text += Struct(output, interface.outputs, border);
    text += output + " " + std::string(k_PackFunction) + "(" +
            std::string(interface.geometry->outputType) + " " + std::string(k_OutputVertex) +
            ") { " + output + " limn_packed; ";
    for (std::size_t i = 0; i < interface.outputs.size(); ++i)
    {
        const StageValue& value = interface.outputs[i];
        const Varying target = AtBorder(value, border);
        text += "limn_packed." + MemberName(i) + " = " +
                ConvertText(value.expression, value.components, target.scalar, target.components) +
                "; ";
    }
    return text + "return limn_packed; } ";
}

std::string_view ThreadsOf(const HlslFunction& kernel)
{
    const auto isThreads = [](std::string_view attribute)
    {
        return Trim(attribute.substr(1)).starts_with("numthreads");
    };
    const auto found = std::ranges::find_if(kernel.attributes, isThreads);
    return found == kernel.attributes.end() ? std::string_view() : *found;
}

bool HasValidThreads(std::string_view attribute, const IntegerNames& constants)
{
    constexpr std::int64_t k_Most[] = {1024, 1024, 64};
    constexpr std::int64_t k_MostInAll = 1024;
    const std::size_t open = attribute.find('(');
    const std::size_t close = attribute.rfind(')');
    if (open == attribute.npos || close == attribute.npos || close < open)
    {
        return false;
    }
    std::string_view rest = attribute.substr(open + 1, close - open - 1);
    std::int64_t inAll = 1;
    for (std::size_t i = 0; i < std::size(k_Most); ++i)
    {
        const bool isLast = i + 1 == std::size(k_Most);
        const std::size_t comma = isLast ? rest.size() : rest.find(',');
        const std::string_view text = rest.substr(0, comma);
        const bool isOne = comma != rest.npos && text.find(',') == text.npos;
        const std::int64_t threads = isOne ? EvaluateInteger(text, constants) : 0;
        if (threads < 1 || threads > k_Most[i])
        {
            return false;
        }
        inAll *= threads;
        rest.remove_prefix(isLast ? 0 : comma + 1);
    }
    return inAll <= k_MostInAll;
}

std::string WriteKernelEntry(const HlslFunction& kernel, const std::string& prologue)
{
    std::string parameters;
    for (std::size_t i = 0; i < kernel.parameters.size(); ++i)
    {
        const HlslVariable& parameter = kernel.parameters[i];
        parameters += (i == 0 ? "" : ", ") + std::string(parameter.type) + " " + ArgumentName(i);
        if (!parameter.semantic.empty()) // else it is a struct whose members have some
        {
            parameters += " : " + std::string(parameter.semantic);
        }
    }
    return EntryText(std::string(ThreadsOf(kernel)) + "\n", parameters,
                     prologue + CallText(kernel));
}

} // namespace limn

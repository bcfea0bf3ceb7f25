#include "stages/GeometryEntryWriter.h"

#include "stages/EntryPointWriter.h"
#include "stages/StageValueText.h"

#include <algorithm>

namespace limn
{

namespace
{

constexpr const char* k_InputType = "limn_Input";
constexpr const char* k_Input = "limn_input";
constexpr const char* k_Stream = "limn_stream";

bool isUnwritten(const StageBorder& border, const StageValue& value)
{
    return !value.isSystemValue && std::find(border.unwritten.begin(), border.unwritten.end(),
                                             value.semanticName()) != border.unwritten.end();
}

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

/// Scalar and number of components of a value as the border has it.
Varying AtBorder(const StageValue& value, const StageBorder& border)
{
    if (!value.isSystemValue)
    {
        return border.Find(value.semanticName());
    }
    const std::string type = SystemType(value);
    return {"", type.substr(0, type.find_first_of("234")), ComponentsOf(type), 0};
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

std::string Call(const StageInterface& interface)
{
    std::string arguments;
    for (std::size_t i = 0; i < interface.function->parameters.size(); ++i)
    {
        arguments += (i == 0 ? "" : ", ");
        arguments += i == interface.geometry->streamParameter ? k_Stream : ArgumentName(i);
    }
    return AuthorFunctionName(interface.function->name) + "(" + arguments + ");\n";
}

} // namespace

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

    std::string text = "\n#line 1 \"" + std::string(k_EntryFile) + "\"\n";
    for (const std::string_view attribute : interface.function->attributes)
    {
        text.append(attribute);
    }
    const std::string index(k_InputIndex);
    return text + "\nvoid " + std::string(k_EntryName) + "(" + parameters + ")\n{\n" + prologue +
           ArgumentLocals(interface) + before + "for (int " + index + " = 0; " + index + " < " +
           count + "; ++" + index + ")\n{\n" +
           ReadInput(interface, linkage.Before(ShaderStage::Geometry)) + "}\n" + Call(interface) +
           "}\n";
}

} // namespace limn

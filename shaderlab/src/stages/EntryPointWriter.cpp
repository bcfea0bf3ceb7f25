#include "stages/EntryPointWriter.h"

#include "stages/GeometryEntryWriter.h"
#include "stages/StageValueText.h"

#include <algorithm>

namespace limn
{

namespace
{

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
            AddDrawIndex();
        }
        return "\n#line 1 \"" + std::string(k_EntryFile) + "\"\nvoid " + std::string(k_EntryName) +
               "(" + m_Parameters + ")\n{\n" + m_DrawIndex + prologue +
               ArgumentLocals(m_Interface) + m_Before + Call() + m_After + "}\n";
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

    void AddDrawIndex()
    {
        m_DrawIndex =
            DrawIndexText(m_Stage == ShaderStage::Vertex ? InstanceIndex() : k_FirstInstance);
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
            ReadSystemValue(value, name, type);
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

    void ReadSystemValue(const StageValue& value, const std::string& name, const std::string& type)
    {
        if (type == "bool" && value.scalar == "float")
        {
            // VFACE is a number: positive for front faces.
            Read(value, "(" + name + " ? 1.0 : -1.0)", 1);
            return;
        }
        Read(value, name, ComponentsOf(type));
    }

    void AddAttribute(const StageValue& value)
    {
        const std::string name = NextName();
        const std::string semantic = value.semanticName();
        const auto input = std::find_if(
            m_Linkage.vertexInputs.begin(), m_Linkage.vertexInputs.end(),
            [&](const VertexInput& candidate) { return candidate.semantic == semantic; });
        AddParameter("[[vk::location(" + std::to_string(input->location) + ")]] " +
                     TypeName(value.scalar, value.components) + " " + name + " : " + semantic);
        Read(value, name, value.components);
    }

    void AddVaryingInput(const StageValue& value)
    {
        const StageBorder& border = m_Linkage.Before(m_Stage);
        if (std::find(border.unwritten.begin(), border.unwritten.end(), value.semanticName()) !=
            border.unwritten.end())
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
        if (value.isSystemValue)
        {
            const std::string type = SystemType(value);
            AddParameter("out " + type + " " + name + " : " + SystemSemantic(value));
            const std::string scalar = type.substr(0, type.find_first_of("234"));
            Write(value, name, scalar, ComponentsOf(type));
            return;
        }
        const Varying& varying = m_Linkage.Behind(m_Stage).Find(value.semanticName());
        AddParameter(VaryingText(varying, name, "out "));
        Write(value, name, varying.scalar, varying.components);
    }

    void Read(const StageValue& value, const std::string& source, int components)
    {
        m_Before += value.expression + " = " +
                    ConvertText(source, components, value.scalar, value.components) + ";\n";
    }

    void Write(const StageValue& value, const std::string& target, const std::string& scalar,
               int components)
    {
        m_After += target + " = " +
                   ConvertText(value.expression, value.components, scalar, components) + ";\n";
    }

    std::string Call() const
    {
        const HlslFunction& function = *m_Interface.function;
        std::string text;
        if (function.returnType != "void")
        {
            text += std::string(function.returnType) + " " + std::string(k_ResultName) + " = ";
        }
        text += AuthorFunctionName(function.name) + "(";
        for (std::size_t i = 0; i < function.parameters.size(); ++i)
        {
            text += (i == 0 ? "" : ", ") + ArgumentName(i);
        }
        return text + ");\n";
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

} // namespace

std::string AuthorFunctionName(std::string_view name)
{
    return name == k_TakenName ? "limn_AuthorMain" : std::string(name);
}

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

} // namespace limn

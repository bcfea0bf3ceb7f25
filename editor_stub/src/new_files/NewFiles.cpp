#include "new_files/NewFiles.h"

#include "console/Texts.h"
#include "settings/SettingsCollector.h"

#include <algorithm>
#include <cmath>
#include <limn/base/EmbeddedFile.h>
#include <limn/base/TerminalText.h>
#include <limn/volume/ProfileEdit.h>
#include <limn/volume/YamlRead.h>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> NewSceneFile();
}

namespace
{

constexpr std::size_t k_CommentColumn = 44;

/// Returns the line with a comment behind it, which stands below those of other lines.
std::string WithComment(std::string line, const std::string& comment)
{
    if (!comment.empty())
    {
        line.resize(std::max(line.size() + 1, k_CommentColumn), ' ');
        line += "# " + OneLine(comment);
    }
    return line + "\n";
}

std::string RangeComment(const VolumeParameter& parameter)
{
    std::string text = parameter.unit();
    if (const std::optional<ValueRange> range = parameter.range())
    {
        const bool hasEnd = std::isfinite(range->max);
        const std::string from = std::isfinite(range->min) ? NumberText(range->min) : "";
        const std::string bounds = from.empty() ? (hasEnd ? "up to " + NumberText(range->max) : "")
                                   : hasEnd     ? from + " to " + NumberText(range->max)
                                                : from + " or more";
        text += (text.empty() || bounds.empty() ? "" : ", ") + bounds;
    }
    return text;
}

/// Returns whether a file may have the parameter's text as its value.
bool CanBeRead(VolumeParameter& parameter)
{
    try
    {
        AssetDiagnostics diagnostics("");
        return parameter.ReadYaml(ParseTypedValue(parameter.ValueText(), ""), "", diagnostics) &&
               diagnostics.diagnostics().empty();
    }
    catch (const AssetError&)
    {
        return false;
    }
}

std::string ParameterLine(VolumeParameter& parameter)
{
    const std::string range = RangeComment(parameter);
    const std::string tooltip = parameter.tooltip();
    const bool isSwitch = parameter.name() == "m_Enable" || parameter.name() == "enable";
    const std::string value = isSwitch ? "true" : parameter.ValueText();
    const std::string line =
        (CanBeRead(parameter) ? "  " : "  # ") + parameter.name() + ": " + value;
    return WithComment(line, range + (range.empty() || tooltip.empty() ? "" : ": ") + tooltip);
}

std::string Numbers(const ShaderProperty& property)
{
    const std::string_view names = property.type == ShaderPropertyType::Color ? "rgba" : "xyzw";
    return MembersText(property.defaultValue.data(), names);
}

std::string PropertyLine(const ShaderProperty& property)
{
    switch (property.type)
    {
    case ShaderPropertyType::Texture:
        return WithComment(
            "# " + property.name + ": picture.png",
            property.displayName + "; without it " +
                (property.defaultTexture.empty() ? "gray" : property.defaultTexture));
    case ShaderPropertyType::Color:
    case ShaderPropertyType::Vector:
        return WithComment(property.name + ": " + Numbers(property), property.displayName);
    case ShaderPropertyType::Range:
        return WithComment(
            property.name + ": " + NumberText(static_cast<double>(property.defaultValue[0])),
            property.displayName + ", " + NumberText(static_cast<double>(property.rangeMin)) +
                " to " + NumberText(static_cast<double>(property.rangeMax)));
    case ShaderPropertyType::Float:
    case ShaderPropertyType::Int:
    case ShaderPropertyType::Integer:
        break;
    }
    return WithComment(property.name + ": " +
                           NumberText(static_cast<double>(property.defaultValue[0])),
                       property.displayName);
}

} // namespace

std::string NewScene(const std::string& profile)
{
    return Replaced(std::string(embedded::NewSceneFile().front().text), "@PROFILE@", profile);
}

std::string NewProfile(std::span<const std::string> components,
                       const VolumeComponentRegistry& registry)
{
    std::string text;
    for (const std::string& name : components)
    {
        const std::unique_ptr<VolumeComponent> component = registry.Create(name);
        text += (text.empty() ? "" : "\n") + name + ":\n";
        for (VolumeParameter* parameter : component->parameters())
        {
            text += ParameterLine(*parameter);
        }
    }
    return text;
}

std::string NewMaterial(const Shader& shader)
{
    std::string text = "shader: " + shader.name() + "\n";
    for (const ShaderProperty& property : shader.document().properties)
    {
        text += property.HasAttribute("HideInInspector") ? "" : PropertyLine(property);
    }
    return text;
}

} // namespace limn

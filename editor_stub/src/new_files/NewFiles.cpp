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

std::string PropertyLine(const ShaderProperty& property)
{
    if (property.type == ShaderPropertyType::Texture)
    {
        return WithComment(
            "# " + property.name + ": picture.png",
            property.displayName + "; without it " +
                (property.defaultTexture.empty() ? "gray" : property.defaultTexture));
    }
    const auto number = [](float value)
    {
        return NumberText(static_cast<double>(value));
    };
    const bool isColor = property.type == ShaderPropertyType::Color;
    const std::string value =
        isColor || property.type == ShaderPropertyType::Vector
            ? MembersText(property.defaultValue.data(), isColor ? "rgba" : "xyzw")
            : number(property.defaultValue[0]);
    const std::string range =
        property.type == ShaderPropertyType::Range
            ? ", " + number(property.rangeMin) + " to " + number(property.rangeMax)
            : "";
    return WithComment(property.name + ": " + value, property.displayName + range);
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
        text += Joined(component->parameters(), "",
                       [](VolumeParameter* parameter) { return ParameterLine(*parameter); });
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

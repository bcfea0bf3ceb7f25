#include "scene/SettingsReader.h"

#include "scene/ReadEnum.h"

namespace limn
{

SettingsReader::SettingsReader(YamlMapReader& map, const SettingsContext& context,
                               AssetDiagnostics& diagnostics)
    : m_Map(map), m_Context(context), m_Diagnostics(diagnostics)
{
}

const YamlNode* SettingsReader::Find(std::string_view name)
{
    if (!m_Group)
    {
        m_FieldNames.emplace_back(name);
    }
    return Map().Find(name);
}

void SettingsReader::BeginGroup(std::string_view name)
{
    const YamlNode* node = Find(name);
    m_Group.emplace(node ? *node : YamlNode(), m_Map.SubjectOf(name), m_Diagnostics);
}

void SettingsReader::EndGroup()
{
    if (m_Context.refusesUnknownKeys)
    {
        m_Group->Finish();
    }
    m_Group.reset();
}

void SettingsReader::Header(std::string_view) {}

void SettingsReader::Field(std::string_view name, bool& value, std::string_view)
{
    Find(name);
    Map().Read(name, value);
}

void SettingsReader::Field(std::string_view name, int& value, FieldRange range, std::string_view)
{
    Find(name);
    Map().Read(name, value, {range.minimum, range.maximum});
}

void SettingsReader::Field(std::string_view name, float& value, FieldRange range, std::string_view)
{
    Find(name);
    Map().Read(name, value, {range.minimum, range.maximum});
}

void SettingsReader::Field(std::string_view name, Color& value, std::string_view)
{
    Find(name);
    Map().Read(name, value);
}

void SettingsReader::Field(std::string_view name, LayerMask& value, std::string_view)
{
    if (const YamlNode* node = Find(name))
    {
        const auto bits =
            ReadLayerBits(*node, Map().SubjectOf(name), {m_Context.layers, "layer"}, m_Diagnostics);
        value = LayerMask(bits.value_or(value.bits));
    }
}

void SettingsReader::Field(std::string_view name, RenderPassEvent& value, std::string_view)
{
    if (const YamlNode* node = Find(name))
    {
        value = ReadRenderPassEvent(*node, Map().SubjectOf(name), m_Diagnostics).value_or(value);
    }
}

void SettingsReader::Field(std::string_view name, std::shared_ptr<const Shader>& value,
                           std::string_view)
{
    if (const YamlNode* node = Find(name))
    {
        value = m_Context.readShader(*node, Map().SubjectOf(name));
    }
}

void SettingsReader::Field(std::string_view name, std::shared_ptr<const Material>& value,
                           std::string_view)
{
    if (const YamlNode* node = Find(name))
    {
        value = m_Context.readMaterial(*node, Map().SubjectOf(name));
    }
}

void SettingsReader::Field(std::string_view name, glm::vec4& value, std::string_view)
{
    Find(name);
    Map().Read(name, value);
}

void SettingsReader::Field(std::string_view name, std::string& value, std::string_view)
{
    Find(name);
    Map().Read(name, value);
}

void SettingsReader::Field(std::string_view name, std::vector<std::string>& value, std::string_view)
{
    const YamlNode* node = Find(name);
    if (node == nullptr)
    {
        return;
    }
    const std::string subject = Map().SubjectOf(name);
    if (!node->isSequence() && !node->isNull())
    {
        m_Diagnostics.Error(node->location(),
                            subject + ": found " + node->Describe() + "; a list is expected");
        return;
    }
    value.clear();
    for (const YamlNode& item : node->items())
    {
        value.push_back(ReadString(item, subject, m_Diagnostics).value_or(""));
    }
}

void SettingsReader::RenderingLayerIndex(std::string_view name, int& value, std::string_view)
{
    if (const YamlNode* node = Find(name))
    {
        value = ReadLayerIndex(*node, Map().SubjectOf(name),
                               {m_Context.renderingLayers, "rendering layer"}, m_Diagnostics)
                    .value_or(value);
    }
}

void SettingsReader::EnumField(std::string_view name, int& value,
                               std::span<const EnumEntry> entries, std::string_view)
{
    if (const YamlNode* node = Find(name))
    {
        value = ReadEnum(*node, entries, m_Map.SubjectOf(name), m_Diagnostics).value_or(value);
    }
}

} // namespace limn

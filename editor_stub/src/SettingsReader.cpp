#include "SettingsReader.h"

#include "ReadEnum.h"

namespace limn
{

SettingsReader::SettingsReader(YamlMapReader& map, const LayerNames& layers,
                               const LayerNames& renderingLayers, ShaderReader readShader,
                               AssetDiagnostics& diagnostics)
    : m_Map(map),
      m_Layers(layers),
      m_RenderingLayers(renderingLayers),
      m_ReadShader(std::move(readShader)),
      m_Diagnostics(diagnostics)
{
}

const YamlNode* SettingsReader::Find(std::string_view name)
{
    m_FieldNames.emplace_back(name);
    return m_Map.Find(name);
}

void SettingsReader::Header(std::string_view) {}

void SettingsReader::Field(std::string_view name, bool& value, std::string_view)
{
    Find(name);
    m_Map.Read(name, value);
}

void SettingsReader::Field(std::string_view name, int& value, FieldRange range, std::string_view)
{
    Find(name);
    m_Map.Read(name, value, {range.minimum, range.maximum});
}

void SettingsReader::Field(std::string_view name, float& value, FieldRange range, std::string_view)
{
    Find(name);
    m_Map.Read(name, value, {range.minimum, range.maximum});
}

void SettingsReader::Field(std::string_view name, Color& value, std::string_view)
{
    Find(name);
    m_Map.Read(name, value);
}

void SettingsReader::Field(std::string_view name, LayerMask& value, std::string_view)
{
    if (const YamlNode* node = Find(name))
    {
        const auto bits =
            ReadLayerBits(*node, m_Map.SubjectOf(name), {m_Layers, "layer"}, m_Diagnostics);
        value = LayerMask(bits.value_or(value.bits));
    }
}

void SettingsReader::Field(std::string_view name, RenderPassEvent& value, std::string_view)
{
    if (const YamlNode* node = Find(name))
    {
        value = ReadRenderPassEvent(*node, m_Map.SubjectOf(name), m_Diagnostics).value_or(value);
    }
}

void SettingsReader::Field(std::string_view name, std::shared_ptr<const Shader>& value,
                           std::string_view)
{
    if (const YamlNode* node = Find(name))
    {
        value = m_ReadShader(*node, m_Map.SubjectOf(name));
    }
}

void SettingsReader::RenderingLayerIndex(std::string_view name, int& value, std::string_view)
{
    if (const YamlNode* node = Find(name))
    {
        value = ReadLayerIndex(*node, m_Map.SubjectOf(name), {m_RenderingLayers, "rendering layer"},
                               m_Diagnostics)
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

#include "scene/SettingsReader.h"

#include "plugins/DescribeFeature.h"
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

void SettingsReader::Field(const FieldInfo& field, FieldValue value)
{
    if (const YamlNode* node = Find(field.name))
    {
        std::visit([&](auto target) { Read(field, *node, target); }, value);
    }
}

template <typename T>
void SettingsReader::Read(const FieldInfo& field, const YamlNode&, T* value)
{
    if constexpr (std::is_same_v<T, int> || std::is_same_v<T, float>)
    {
        Map().Read(field.name, *value, field.range.value_or(ValueRange()));
    }
    else
    {
        Map().Read(field.name, *value);
    }
}

void SettingsReader::Read(const FieldInfo& field, const YamlNode& node, LayerMask* value)
{
    const auto bits = ReadLayerBits(node, Map().SubjectOf(field.name), {m_Context.layers, "layer"},
                                    m_Diagnostics);
    *value = LayerMask(bits.value_or(value->bits));
}

void SettingsReader::Read(const FieldInfo& field, const YamlNode& node, RenderPassEvent* value)
{
    *value = ReadRenderPassEvent(node, Map().SubjectOf(field.name), m_Diagnostics).value_or(*value);
}

void SettingsReader::Read(const FieldInfo& field, const YamlNode& node,
                          std::shared_ptr<const Shader>* value)
{
    *value = m_Context.readShader(node, Map().SubjectOf(field.name));
}

void SettingsReader::Read(const FieldInfo& field, const YamlNode& node,
                          std::shared_ptr<const Material>* value)
{
    *value = m_Context.readMaterial(node, Map().SubjectOf(field.name));
}

void SettingsReader::Read(const FieldInfo& field, const YamlNode& node,
                          std::vector<std::string>* value)
{
    const std::string subject = Map().SubjectOf(field.name);
    if (!node.isSequence() && !node.isNull())
    {
        m_Diagnostics.Error(node.location(),
                            subject + ": found " + node.Describe() + "; a list is expected");
        return;
    }
    value->clear();
    for (const YamlNode& item : node.items())
    {
        value->push_back(ReadString(item, subject, m_Diagnostics).value_or(""));
    }
}

void SettingsReader::Read(const FieldInfo& field, const YamlNode& node, EnumValue value)
{
    value.value = ReadEnum(node, value.entries, Map().SubjectOf(field.name), m_Diagnostics)
                      .value_or(value.value);
}

void SettingsReader::Read(const FieldInfo& field, const YamlNode& node, RenderingLayerValue value)
{
    value.value = ReadLayerIndex(node, Map().SubjectOf(field.name),
                                 {m_Context.renderingLayers, "rendering layer"}, m_Diagnostics)
                      .value_or(value.value);
}

void ReadFeatureSettings(YamlMapReader& map, ScriptableRendererFeature& feature,
                         const SettingsContext& context, AssetDiagnostics& diagnostics)
{
    bool active = feature.isActive();
    map.Read("active", active);
    feature.SetActive(active);
    SettingsReader reader(map, context, diagnostics);
    DescribeFeature(feature, reader);
}

void TryCreate(ScriptableRendererFeature& feature, const std::shared_ptr<ShaderSource>& shaders,
               SourceLocation location, std::string_view subject, AssetDiagnostics& diagnostics)
{
    const ShaderSourceScope scope(shaders);
    try
    {
        RunFeatureCode(typeid(feature), feature.name, "Create", [&] { feature.Create(); });
    }
    catch (const AssetError& error)
    {
        diagnostics.Add(error);
    }
    catch (const ContractError& error)
    {
        diagnostics.Error(location, std::string(subject) + error.what());
    }
}

} // namespace limn

#include "settings/SettingsReader.h"

#include "plugins/DescribeFeature.h"
#include "settings/ReadEnum.h"
#include "settings/SettingsLevel.h"

namespace limn
{

namespace
{

/// Reads what Describe names, group by group.
class SettingsReader final : public Inspector
{
public:
    SettingsReader(YamlMapReader& map, const SettingName& root, const SettingsContext& context,
                   AssetDiagnostics& diagnostics)
        : m_Context(context), m_Diagnostics(diagnostics), m_Root(root)
    {
        m_Levels.emplace_back(root, context.unityType, diagnostics).Add(map);
    }

    void Field(const FieldInfo& field, FieldValue value) override
    {
        m_Map = m_Levels.back().Find(field.name);
        if (m_Map)
        {
            const YamlNode& node = *m_Map->Find(field.name);
            std::visit([&](auto target) { Read(field, node, target); }, value);
        }
    }

    void BeginGroup(std::string_view name) override
    {
        SettingsLevel& outer = m_Levels.back();
        YamlMapReader* map = outer.Find(name);
        m_Levels.emplace_back(*FindMember(outer.group(), name), m_Context.unityType, m_Diagnostics)
            .Add(map ? *map->Find(name) : YamlNode(), map ? *map : outer.map());
    }

    void EndGroup() override
    {
        m_Levels.back().Finish(m_Root);
        m_Levels.pop_back();
    }

    void Finish() { m_Levels.back().Finish(m_Root); }

private:
    std::string SubjectOf(const FieldInfo& field) const { return m_Map->SubjectOf(field.name); }

    template <typename T>
    void Read(const FieldInfo& field, const YamlNode&, T* value)
    {
        if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>)
        {
            m_Map->Read(field.name, *value, field.range.value_or(ValueRange()));
        }
        else
        {
            m_Map->Read(field.name, *value);
        }
    }

    template <typename Tag>
    void Read(const FieldInfo& field, const YamlNode& node, detail::BitMask32<Tag>* value)
    {
        constexpr bool isRendering = std::is_same_v<Tag, detail::RenderingLayerTag>;
        const LayerNames& names = isRendering ? m_Context.renderingLayers : m_Context.layers;
        const auto bits =
            ReadLayerBits(node, SubjectOf(field), {names, Tag::k_Name}, m_Diagnostics);
        value->bits = bits.value_or(value->bits);
    }

    void Read(const FieldInfo& field, const YamlNode& node, RenderPassEvent* value)
    {
        *value = ReadRenderPassEvent(node, SubjectOf(field), m_Diagnostics).value_or(*value);
    }

    void Read(const FieldInfo& field, const YamlNode& node, std::shared_ptr<const Shader>* value)
    {
        *value = m_Context.readShader(node, SubjectOf(field));
    }

    void Read(const FieldInfo& field, const YamlNode& node, std::shared_ptr<const Material>* value)
    {
        *value = m_Context.readMaterial(node, SubjectOf(field));
    }

    void Read(const FieldInfo& field, const YamlNode& node, std::vector<std::string>* value)
    {
        const std::string subject = SubjectOf(field);
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

    void Read(const FieldInfo& field, const YamlNode& node, EnumValue value)
    {
        value.value =
            ReadEnum(node, value.entries, SubjectOf(field), m_Diagnostics).value_or(value.value);
    }

    void Read(const FieldInfo& field, const YamlNode& node, RenderingLayerValue value)
    {
        value.value = ReadLayerIndex(node, SubjectOf(field),
                                     {m_Context.renderingLayers, "rendering layer"}, m_Diagnostics)
                          .value_or(value.value);
    }

    const SettingsContext& m_Context;
    AssetDiagnostics& m_Diagnostics;
    const SettingName& m_Root;
    std::deque<SettingsLevel> m_Levels; ///< the root, then the groups that the fields are in now
    YamlMapReader* m_Map = nullptr;     ///< that has the field's value
};

} // namespace

void ReadFeatureSettings(YamlMapReader& map, ScriptableRendererFeature& feature,
                         const SettingsContext& context, AssetDiagnostics& diagnostics)
{
    if (context.unityType.empty())
    {
        bool active = feature.isActive();
        map.Read("active", active);
        feature.SetActive(active);
    }
    const SettingName root = DescribedSettings(feature);
    SettingsReader reader(map, root, context, diagnostics);
    DescribeFeature(feature, reader);
    reader.Finish();
}

void TryCreate(ScriptableRendererFeature& feature, const std::shared_ptr<ShaderSource>& shaders,
               SourceLocation location, std::string_view subject, AssetDiagnostics& diagnostics)
{
    const ShaderSourceScope scope(shaders);
    try
    {
        RunPluginCode(typeid(feature), feature.name, "Create", [&] { feature.Create(); });
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

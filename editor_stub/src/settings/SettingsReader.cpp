#include "settings/SettingsReader.h"

#include "plugins/LoadPlugin.h"

#include <algorithm>
#include <limn/volume/UnityAsset.h>

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
        ReadAsset(field, node, m_Context.assets.shader, *value);
    }
    void Read(const FieldInfo& field, const YamlNode& node, std::shared_ptr<const Material>* value)
    {
        ReadAsset(field, node, m_Context.assets.material, *value);
    }
    void Read(const FieldInfo& field, const YamlNode& node, std::shared_ptr<const Texture>* value)
    {
        ReadAsset(field, node, m_Context.assets.texture, *value);
    }
    void Read(const FieldInfo& field, const YamlNode& node,
              std::shared_ptr<const ComputeShader>* value)
    {
        ReadAsset(field, node, m_Context.assets.computeShader, *value);
    }

    template <typename Asset>
    void ReadAsset(const FieldInfo& field, const YamlNode& node, const AssetReader<Asset>& read,
                   std::shared_ptr<const Asset>& asset)
    {
        asset = read ? read(node, SubjectOf(field)) : nullptr;
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

/// Fields of URP's own features that name what its package has for them, and limn has built in, or
/// that tell its editor from which version they are.
constexpr std::pair<std::string_view, std::string_view> k_PackageFields[] = {
    {"ScreenSpaceAmbientOcclusion", "m_Shader"},
    {"ScreenSpaceAmbientOcclusion", "m_BlueNoise256Textures"},
    {"FullScreenPassRendererFeature", "m_Version"}};

/// Returns whether every MonoBehaviour's or feature's block has the key, or all of this type.
bool IsBookkeeping(std::string_view type, std::string_view key)
{
    return isUnityHeaderField(key) || key == "m_Active" ||
           std::ranges::count(k_PackageFields, std::pair(type, key)) > 0;
}

/// Returns whether the value is a reference, a vector or a colour: a map that is one value.
bool IsOneValue(const YamlNode& node)
{
    const auto isLetter = [](const YamlEntry& entry)
    {
        return entry.key.size() == 1;
    };
    return node.Find("fileID") || std::ranges::all_of(node.entries(), isLetter);
}

/// Returns whether an entry that is no member of the group is a settings class whose members are.
bool IsSettingsClass(const YamlEntry& entry, const SettingName& group)
{
    if (!entry.value.isMap() || IsOneValue(entry.value) || FindMember(group, entry.key))
    {
        return false;
    }
    return std::ranges::any_of(
        entry.value.entries(), [&group](const YamlEntry& inner)
        { return FindMember(group, inner.key) || IsSettingsClass(inner, group); });
}

const YamlEntry& EntryOf(const YamlMapReader& map, std::string_view name)
{
    return *std::ranges::find_if(map.node().entries(), [name](const YamlEntry& entry)
                                 { return entry.key == name || entry.key == PlainSpelling(name); });
}

class NameCollector final : public Inspector
{
public:
    void Field(const FieldInfo& field, FieldValue) override
    {
        m_Groups.back().members.push_back({std::string(field.name)});
    }
    void BeginGroup(std::string_view name) override { m_Groups.push_back({std::string(name)}); }
    void EndGroup() override
    {
        SettingName group = std::move(m_Groups.back());
        m_Groups.pop_back();
        m_Groups.back().members.push_back(std::move(group));
    }

    SettingName Root() && { return std::move(m_Groups.front()); }

private:
    std::vector<SettingName> m_Groups{SettingName()}; ///< that are open, the outermost first
};

/// Adds the paths of everything below `owner` that is no member of `group` itself:
/// "settings.width".
void AddPaths(const SettingName& owner, const SettingName& group, const std::string& prefix,
              std::vector<std::string>& paths)
{
    for (const SettingName& member : owner.members)
    {
        if (&owner != &group)
        {
            paths.push_back(prefix + member.name);
        }
        AddPaths(member, group, prefix + member.name + ".", paths);
    }
}

} // namespace

AssetReaders ReadersOfFiles(References& references)
{
    AssetReaders readers;
    readers.shader = [&references](const YamlNode& node, const std::string& subject)
    {
        return references.ReadShader(node, subject);
    };
    readers.texture = [&references](const YamlNode& node, const std::string& subject)
    {
        return references.ReadPicture(node, subject);
    };
    readers.computeShader = [&references](const YamlNode& node, const std::string& subject)
    {
        return references.ReadComputeShader(node, subject);
    };
    return readers;
}

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

SettingsLevel::SettingsLevel(const SettingName& group, std::string unityType,
                             AssetDiagnostics& diagnostics)
    : m_Group(group), m_UnityType(std::move(unityType)), m_Diagnostics(diagnostics)
{
}

void SettingsLevel::Add(YamlMapReader& map)
{
    m_Maps.push_back(&map);
    for (const YamlEntry& entry : map.node().entries())
    {
        if (IsSettingsClass(entry, m_Group))
        {
            const YamlNode& members = *map.Find(entry.key);
            Add(m_Own.emplace_back(members, map.SubjectOf(entry.key), m_Diagnostics, map.noun()));
        }
    }
}

void SettingsLevel::Add(const YamlNode& node, const YamlMapReader& outer)
{
    Add(m_Own.emplace_back(node, outer.SubjectOf(m_Group.name), m_Diagnostics, outer.noun()));
}

YamlMapReader* SettingsLevel::Find(std::string_view name)
{
    YamlMapReader* found = nullptr;
    for (YamlMapReader* map : m_Maps)
    {
        if (!map->Find(name)) // of each, so that each knows the name
        {
            continue;
        }
        if (found)
        {
            ReportTwice(name, *found, *map);
        }
        found = found ? found : map;
    }
    return found;
}

void SettingsLevel::ReportTwice(std::string_view name, const YamlMapReader& first,
                                const YamlMapReader& second)
{
    const SourceLocation before = EntryOf(first, name).keyLocation;
    const SourceLocation place = EntryOf(second, name).keyLocation;
    const std::string subject = second.SubjectOf(name);
    const std::string same = first.SubjectOf(name) + " at " + std::to_string(before.line) + ":" +
                             std::to_string(before.column);
    if (m_UnityType.empty())
    {
        m_Diagnostics.Error(place, subject + ": " + same + " is the same " + first.noun() +
                                       "; keep one of them");
        return;
    }
    m_Diagnostics.Note(place, subject + ": it is left out; " + m_UnityType +
                                  " has one setting of this name, which is " + same +
                                  "; a group in its Describe would tell them apart");
}

void SettingsLevel::NoteUnknown(const YamlMapReader& map)
{
    for (const YamlEntry& entry : map.node().entries())
    {
        const bool isKnown = IsBookkeeping(m_UnityType, entry.key) ||
                             FindMember(m_Group, entry.key) || IsSettingsClass(entry, m_Group);
        if (!isKnown)
        {
            m_Diagnostics.Note(entry.keyLocation, map.SubjectOf(entry.key) + ": it is left out; " +
                                                      m_UnityType + " has no such setting");
        }
    }
}

void SettingsLevel::Finish(const SettingName& root)
{
    std::vector<std::string> elsewhere;
    AddPaths(root, m_Group, "", elsewhere);
    for (YamlMapReader* map : m_Maps)
    {
        if (m_UnityType.empty())
        {
            map->Finish(elsewhere);
        }
        else
        {
            NoteUnknown(*map);
        }
    }
}

SettingName DescribedSettings(ScriptableRendererFeature& feature)
{
    NameCollector collector;
    DescribeFeature(feature, collector);
    return std::move(collector).Root();
}

const SettingName* FindMember(const SettingName& group, std::string_view key)
{
    const auto found =
        std::ranges::find_if(group.members, [key](const SettingName& member)
                             { return member.name == key || PlainSpelling(member.name) == key; });
    return found == group.members.end() ? nullptr : &*found;
}

} // namespace limn

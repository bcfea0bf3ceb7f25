#include "scene/SettingsEdit.h"

#include "console/Texts.h"
#include "plugins/LoadPlugin.h"
#include "settings/ReadValues.h"
#include "settings/SettingsCollector.h"
#include "settings/SettingsReader.h"
#include "unity/UnityProject.h"

#include <algorithm>
#include <limn/core/Material.h>
#include <limn/volume/UnityAsset.h>
#include <limn/volume/YamlSplicer.h>

namespace limn
{

namespace
{

/// The part of a file that is about one feature.
struct FeatureBlock
{
    std::string name;
    std::string type;
    std::string unityType; ///< the type in a Unity asset, as SettingsContext's; else ""
    YamlNode map;

    const char* activeKey() const { return unityType.empty() ? "active" : "m_Active"; }
};

/// The features of a scene file or of a Unity renderer asset, by their text.
struct FeatureBlocks
{
    std::vector<FeatureBlock> features; ///< those whose type is known
    std::vector<YamlNode> documents;    ///< of the whole file
    LayerNames layers;
    LayerNames renderingLayers;

    std::vector<std::string_view> names() const; ///< and types
};

std::vector<std::string_view> FeatureBlocks::names() const
{
    std::vector<std::string_view> names;
    for (const FeatureBlock& block : features)
    {
        AddOnce(block.name, names);
        AddOnce(block.type, names);
    }
    return names;
}

std::string TextAt(const YamlNode& map, std::string_view key)
{
    const YamlNode* value = map.Find(key);
    return value ? value->scalar() : std::string();
}

void ReadScene(const YamlNode& scene, const std::string& file, FeatureBlocks& blocks)
{
    AssetDiagnostics ignored(file);
    for (const auto& [key, names] : {std::pair("layers", &blocks.layers),
                                     std::pair("renderingLayers", &blocks.renderingLayers)})
    {
        if (const YamlNode* node = scene.Find(key))
        {
            ReadLayerNames(*node, key, *names, ignored);
        }
    }
    const YamlNode* renderer = scene.Find("renderer");
    if (!renderer)
    {
        return;
    }
    const YamlNode* data = renderer->isScalar() ? renderer : renderer->Find("rendererData");
    if (data)
    {
        throw AssetError(file, data->location(),
                         "renderer: the features are in '" + data->scalar() +
                             "'; change them in that file");
    }
    const YamlNode* features = renderer->Find("features");
    for (const YamlNode& map : features ? features->items() : std::span<const YamlNode>())
    {
        const std::string type = TextAt(map, "type");
        const std::string name = TextAt(map, "name");
        blocks.features.push_back({name.empty() ? type : name, type, "", map});
    }
}

void ReadRendererBlocks(const std::string& text, const std::string& file, FeatureBlocks& blocks)
{
    const UnityAsset asset(text, file);
    const UnityProject project(file);
    for (const UnityHeader& header : asset.headers())
    {
        blocks.documents.push_back(asset.Read(header).fields);
    }
    const std::optional<UnityObject> root = asset.FindWithField("m_RendererFeatures");
    for (const YamlNode& reference :
         root ? root->fields.Find("m_RendererFeatures")->items() : std::span<const YamlNode>())
    {
        const std::optional<UnityObject> object = asset.Find(ReadFileID(reference).value_or(0));
        const YamlNode* script = object ? object->fields.Find("m_Script") : nullptr;
        const std::string type = script ? UnityScriptClass(ReadGuid(*script), project) : "";
        if (!type.empty())
        {
            blocks.features.push_back({object->name, type, type, object->fields});
        }
    }
}

/// @throws AssetError for broken YAML, and where the features are not in this file
FeatureBlocks ReadFeatureBlocks(const std::string& text, const std::string& file,
                                AssetContext& assets)
{
    FeatureBlocks blocks;
    if (IsUnityAsset(text))
    {
        ReadRendererBlocks(text, file, blocks);
    }
    else
    {
        blocks.documents = ParseYaml(text, file);
        ReadScene(blocks.documents.front(), file, blocks);
    }
    std::erase_if(blocks.features, [&assets](const FeatureBlock& block)
                  { return !assets.features().Create(block.type); });
    return blocks;
}

using Path = std::vector<std::string>;

/// The setting that keys lead to, as Describe names it; keys of settings classes that Describe left
/// out fall away.
Path DescribedPath(const SettingName& root, const Path& keys)
{
    Path path;
    const SettingName* group = &root;
    for (const std::string& key : keys)
    {
        if (const SettingName* member = FindMember(*group, key))
        {
            path.push_back(member->name);
            group = member;
        }
    }
    return path;
}

std::string PathText(const Path& path)
{
    return ValuePath{"", path}.KeysText();
}

/// The text of a setting in a file of Unity's or of limn's.
class SettingText final : public Inspector
{
public:
    explicit SettingText(Path path) : m_Path(std::move(path)) {}

    void BeginGroup(std::string_view name) override { m_Groups.emplace_back(name); }
    void EndGroup() override { m_Groups.pop_back(); }
    void Field(const FieldInfo& field, FieldValue value) override
    {
        Path path = m_Groups;
        path.emplace_back(field.name);
        if (path == m_Path)
        {
            std::visit([this](auto target) { Tell(target); }, value);
        }
    }

    bool isReference = false; ///< to a file
    bool isNumbers = false;   ///< a colour or a vector, which files write in several ways
    std::string unityText;

private:
    template <typename T>
    void Tell(T* value)
    {
        if constexpr (std::is_same_v<T, float>)
        {
            unityText = NumberText(static_cast<double>(*value));
        }
        else
        {
            unityText = std::to_string(static_cast<std::int64_t>(*value));
        }
    }
    void Tell(std::string* value) { unityText = Quoted(*value); }
    void Tell(std::vector<std::string>* value)
    {
        unityText = "[" + Joined(*value, ", ", Quoted) + "]";
    }
    void Tell(Color* value) { Numbers(&value->r, "rgba"); }
    template <int Size>
    void Tell(glm::vec<Size, float>* value)
    {
        Numbers(&value->x, std::string_view("xyzw").substr(0, Size));
    }
    template <typename Tag>
    void Tell(detail::BitMask32<Tag>* value)
    {
        unityText = "{m_Bits: " + std::to_string(value->bits) + "}";
    }
    template <typename Asset>
    void Tell(std::shared_ptr<const Asset>*)
    {
        isReference = true;
    }
    void Tell(EnumValue value) { unityText = std::to_string(value.value); }
    void Tell(RenderingLayerValue value) { unityText = std::to_string(value.value); }

    void Numbers(const float* numbers, std::string_view names)
    {
        isNumbers = true;
        unityText = MembersText(numbers, names);
    }
    static std::string Quoted(const std::string& text)
    {
        return '"' + Replaced(Replaced(text, "\\", "\\\\"), "\"", "\\\"") + '"';
    }

    Path m_Path;
    Path m_Groups;
};

/// Returns the value of a setting in a feature's block, or nothing if it is not there.
std::optional<YamlNode> FindSetting(const FeatureBlock& block, const SettingName& root,
                                    const Path& path, AssetDiagnostics& diagnostics)
{
    YamlMapReader map(block.map, block.name, diagnostics);
    std::deque<SettingsLevel> levels;
    levels.emplace_back(root, block.unityType, diagnostics).Add(map);
    for (std::size_t i = 0;; ++i)
    {
        YamlMapReader* found = levels.back().Find(path[i]);
        if (!found || i + 1 == path.size())
        {
            return found ? std::optional(*found->Find(path[i])) : std::nullopt;
        }
        const SettingName& group = *FindMember(levels.back().group(), path[i]);
        levels.emplace_back(group, block.unityType, diagnostics).Add(*found->Find(path[i]), *found);
    }
}

/// The value of a setting as text for people.
std::string TextOf(ScriptableRendererFeature& feature, const std::string& path,
                   const FeatureBlocks& file)
{
    for (const InspectedValue& value :
         CollectSettings(feature, feature, file.layers, file.renderingLayers))
    {
        if (value.name == path)
        {
            return value.value;
        }
    }
    return feature.isActive() ? "true" : "false";
}

/// Changes one file's text by one edit.
class SettingsEditor
{
public:
    SettingsEditor(const std::string& text, const std::string& file, AssetContext& assets)
        : m_Assets(assets),
          m_Blocks(ReadFeatureBlocks(text, file, assets)),
          m_Diagnostics(file),
          m_Text(text)
    {
    }

    std::string Edit(const ValueAssignment& edit, std::vector<ScalarChange>& changes)
    {
        m_Source = edit.Text();
        const ValuePath path = ValuePath::Split(edit.path, m_Blocks.names());
        YamlSplicer splicer(m_Text, edit.path, m_Diagnostics);
        for (const FeatureBlock* block : Named(path.name))
        {
            EditBlock(*block, path, edit, splicer, changes);
        }
        m_Diagnostics.ThrowIfErrors();
        std::string result = splicer.Result();
        splicer.RequireNoOtherChange(
            m_Blocks.documents, ReadFeatureBlocks(result, m_Diagnostics.file(), m_Assets).documents,
            {});
        return result;
    }

private:
    std::vector<const FeatureBlock*> Named(const std::string& name) const
    {
        for (const auto member : {&FeatureBlock::name, &FeatureBlock::type})
        {
            std::vector<const FeatureBlock*> found;
            for (const FeatureBlock& block : m_Blocks.features)
            {
                found.insert(found.end(), block.*member == name ? 1 : 0, &block);
            }
            if (!found.empty())
            {
                return found;
            }
        }
        const bool isComponent = m_Assets.volumeComponents().Find(name) != nullptr;
        throw AssetError(m_Source, {},
                         isComponent ? "'" + name +
                                           "' is a volume component, not a feature; set its "
                                           "parameters in the profile of a volume"
                         : m_Blocks.features.empty()
                             ? "unknown feature '" + name + "'; the file has no features"
                             : "unknown feature " + UnknownName(name, m_Blocks.names()));
    }

    SettingsContext Context(std::string unityType) const
    {
        return {m_Blocks.layers, m_Blocks.renderingLayers, {}, std::move(unityType)};
    }

    /// A feature with the typed value.
    std::unique_ptr<ScriptableRendererFeature>
    Wanted(const FeatureBlock& block, const ValuePath& path, const YamlNode& value) const
    {
        AssetDiagnostics typed(m_Source);
        std::unique_ptr<ScriptableRendererFeature> feature = m_Assets.features().Create(block.type);
        YamlMapReader map(path.AsMap(value), path.name, typed, "setting");
        ReadFeatureSettings(map, *feature, Context(""), typed);
        typed.ThrowWithoutPlaces();
        return feature;
    }

    /// The feature as the file has it, as far as it is good.
    std::unique_ptr<ScriptableRendererFeature> Current(const FeatureBlock& block) const
    {
        AssetDiagnostics ignored("");
        std::unique_ptr<ScriptableRendererFeature> feature = m_Assets.features().Create(block.type);
        YamlMapReader map(block.map, block.name, ignored);
        const YamlNode* active = block.map.Find(block.activeKey());
        ReadFeatureSettings(map, *feature, Context(block.unityType), ignored);
        feature->SetActive(active ? ReadBool(*active, "", ignored).value_or(true) : true);
        return feature;
    }

    void EditBlock(const FeatureBlock& block, const ValuePath& path, const ValueAssignment& edit,
                   YamlSplicer& splicer, std::vector<ScalarChange>& changes)
    {
        const auto current = Current(block);
        const SettingName root = DescribedSettings(*current);
        const Path described = DescribedPath(root, path.keys);
        const bool isActive = described.empty();
        const std::string before = TextOf(*current, PathText(described), m_Blocks);
        const auto [whole, member] = WithoutMember(path, root, before);
        const std::string text = edit.NewValue(before, member, m_Source);
        const YamlNode typed = ParseTypedValue(text, m_Source);
        const auto wanted = Wanted(block, whole, typed);
        SettingText setting(described);
        DescribeFeature(*wanted, setting);
        const std::string subject = block.name + "." + (isActive ? "active" : PathText(described));
        const YamlNode* active = block.map.Find(block.activeKey());
        const std::optional<YamlNode> old = !isActive
                                                ? FindSetting(block, root, described, m_Diagnostics)
                                            : active ? std::optional(*active)
                                                     : std::nullopt;
        if (!block.unityType.empty() && (!old || setting.isReference))
        {
            m_Diagnostics.Error(old ? old->location() : block.map.location(),
                                subject + (old ? ": Unity's assets name files by guid; choose it "
                                                 "in Unity"
                                               : ": the file does not have it; Unity adds it when "
                                                 "the feature is saved in its inspector"));
            return;
        }
        const bool isUnityText = setting.isNumbers || !block.unityType.empty();
        const std::string fresh = !isUnityText ? text
                                  : isActive   ? (wanted->isActive() ? "1" : "0")
                                               : setting.unityText;
        const std::string after =
            setting.isReference ? typed.scalar() : TextOf(*wanted, PathText(described), m_Blocks);
        if (!old)
        {
            changes.push_back({subject, "not set", after});
            AddSetting(block.map, isActive ? Path{block.activeKey()} : described, fresh, splicer);
            return;
        }
        changes.push_back({subject, setting.isReference ? old->scalar() : before, after});
        if (changes.back().before != after)
        {
            splicer.Replace(*old, ParseTypedValue(fresh, m_Source), fresh);
        }
    }

    /// Returns the path to the whole value, and the number of it that the path named, or "".
    static std::pair<ValuePath, std::string> WithoutMember(ValuePath path, const SettingName& root,
                                                           const std::string& valueText)
    {
        const std::vector<std::string> members = MembersOfValue(valueText);
        const std::string last = path.keys.back();
        const Path outer(path.keys.begin(), path.keys.end() - 1);
        const bool isSetting = DescribedPath(root, outer) != DescribedPath(root, path.keys);
        if (outer.empty() || isSetting || std::ranges::find(members, last) == members.end())
        {
            return {std::move(path), ""};
        }
        path.keys.pop_back();
        return {std::move(path), last};
    }

    /// Adds what a feature's block lacks of the path, and the value behind it.
    static void AddSetting(const YamlNode& block, const Path& path, const std::string& value,
                           YamlSplicer& splicer)
    {
        const YamlNode* map = &block;
        std::size_t depth = 0;
        for (; depth + 1 < path.size(); ++depth)
        {
            const YamlNode* inner = map->Find(path[depth]);
            inner = inner ? inner : map->Find(PlainSpelling(path[depth]));
            if (!inner)
            {
                break;
            }
            map = inner;
        }
        std::string text = value;
        for (std::size_t i = path.size() - 1; i > depth; --i)
        {
            text = "{" + path[i] + ": " + text + "}";
        }
        splicer.Insert(*map, path[depth], text);
    }

    AssetContext& m_Assets;
    FeatureBlocks m_Blocks;
    AssetDiagnostics m_Diagnostics;
    const std::string& m_Text;
    std::string m_Source;
};

} // namespace

std::vector<ScalarChange> SetFeatureSettings(const std::filesystem::path& path,
                                             std::span<const ValueAssignment> edits,
                                             AssetContext& assets, FileEdit* written)
{
    const auto editor = [&assets](const std::string& text, const std::string& file,
                                  const ValueAssignment& edit, std::vector<ScalarChange>& changes)
    {
        return SettingsEditor(text, file, assets).Edit(edit, changes);
    };
    return EditFile(path, edits, editor, written);
}

} // namespace limn

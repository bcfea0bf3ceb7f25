#include "scene/FeatureBlocks.h"

#include "settings/ReadLayers.h"
#include "unity/UnityScript.h"

#include <algorithm>
#include <limn/volume/UnityAsset.h>

namespace limn
{

namespace
{

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

} // namespace

std::vector<std::string_view> FeatureBlocks::names() const
{
    std::vector<std::string_view> names;
    for (const FeatureBlock& block : features)
    {
        for (const std::string_view name :
             {std::string_view(block.name), std::string_view(block.type)})
        {
            if (std::ranges::find(names, name) == names.end())
            {
                names.push_back(name);
            }
        }
    }
    return names;
}

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

} // namespace limn

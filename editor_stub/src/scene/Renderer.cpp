#include "scene/Loader.h"
#include "settings/SettingsReader.h"

#include <limn/editor_stub/UnityRendererData.h>

namespace limn
{

namespace
{

void ReadFeature(const YamlNode& node, const std::string& subject, SceneLoader& loader)
{
    AssetDiagnostics& diagnostics = loader.diagnostics;
    YamlMapReader map(node, subject, diagnostics);
    std::string type;
    map.Require("type");
    if (!map.Read("type", type))
    {
        return;
    }
    const FeatureRegistry& features = loader.references.assets().features();
    std::unique_ptr<ScriptableRendererFeature> feature = features.Create(type);
    if (!feature)
    {
        diagnostics.Error(map.Find("type")->location(), map.SubjectOf("type") +
                                                            ": unknown feature " +
                                                            UnknownName(type, features.names()));
        return;
    }
    feature->name = type;
    map.Read("name", feature->name);
    const SettingsContext context{loader.asset.layers, loader.asset.renderingLayers,
                                  [&loader](const YamlNode& value, const std::string& setting)
                                  { return loader.references.ReadShader(value, setting); },
                                  [&loader](const YamlNode& value, const std::string& setting)
                                  {
                                      return ReadMaterialName(value, setting, loader);
                                  }};
    ReadFeatureSettings(map, *feature, context, diagnostics);
    TryCreate(*feature, loader.references.assets().shaderSource(), node.location(), subject + ": ",
              diagnostics);
    loader.asset.renderer.features.push_back(std::move(feature));
    loader.asset.renderer.featureTypes.push_back(type);
}

void ReadRendererData(const YamlNode& node, const char* key, SceneLoader& loader)
{
    References& references = loader.references;
    if (node.isScalar() && std::filesystem::path(node.scalar()).extension() != ".asset")
    {
        loader.diagnostics.Error(node.location(),
                                 std::string(key) + ": '" + node.scalar() +
                                     "' is no renderer of Unity's; an .asset file is expected");
        return;
    }
    const auto load = [&references](const std::filesystem::path& path)
    {
        return LoadUnityRendererData(path, references.assets());
    };
    UnityRendererDataLoadResult result = references.Read(node, key, load);
    loader.asset.renderer = std::move(result.renderer);
    loader.AddNotes(result.notes);
}

} // namespace

void ReadRenderer(const YamlNode& node, SceneLoader& loader)
{
    if (node.isScalar())
    {
        ReadRendererData(node, "renderer", loader);
        return;
    }
    SceneMapReader map(node, "renderer", scene_keys::k_Renderer, loader.diagnostics);
    const YamlNode* data = map.Find("rendererData");
    const YamlNode* features = map.Find("features");
    map.Finish();
    if (data && features)
    {
        loader.diagnostics.Error(features->location(),
                                 "renderer.features: the features come from rendererData already; "
                                 "keep one of them");
        return;
    }
    if (data)
    {
        ReadRendererData(*data, "renderer.rendererData", loader);
    }
    if (features)
    {
        int index = 0;
        for (const YamlNode& item : ReadItems(*features, "renderer.features", loader.diagnostics))
        {
            ReadFeature(item, "renderer.features[" + std::to_string(index++) + "]", loader);
        }
    }
}

} // namespace limn

#include "FeatureReader.h"

#include "SettingsReader.h"

namespace limn
{

void ReadFeatureSettings(YamlMapReader& map, ScriptableRendererFeature& feature,
                         const SceneAsset& asset, References& references,
                         AssetDiagnostics& diagnostics)
{
    bool active = feature.isActive();
    map.Read("active", active);
    feature.SetActive(active);
    const auto readShader = [&references](const YamlNode& node, const std::string& subject)
    {
        return references.ReadShader(node, subject);
    };
    SettingsReader reader(map, asset.layers, asset.renderingLayers, readShader, diagnostics);
    feature.Describe(reader);
}

} // namespace limn

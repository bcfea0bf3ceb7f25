#include "scene/FeatureReader.h"

namespace limn
{

void ReadFeatureSettings(YamlMapReader& map, ScriptableRendererFeature& feature,
                         const SettingsContext& context, AssetDiagnostics& diagnostics)
{
    bool active = feature.isActive();
    map.Read("active", active);
    feature.SetActive(active);
    SettingsReader reader(map, context, diagnostics);
    feature.Describe(reader);
}

} // namespace limn

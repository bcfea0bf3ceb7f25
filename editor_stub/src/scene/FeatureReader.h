#pragma once

#include "scene/SettingsReader.h"

#include <limn/core/ScriptableRendererFeature.h>

namespace limn
{

/// Sets a feature's `active` and its settings to what a map of a file of limn's own says. The
/// caller calls map.Finish().
void ReadFeatureSettings(YamlMapReader& map, ScriptableRendererFeature& feature,
                         const SettingsContext& context, AssetDiagnostics& diagnostics);

} // namespace limn

#pragma once

#include "References.h"

#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

/// Sets a feature's `active` and its settings to what a map of a file of limn's own says. The
/// caller calls map.Finish().
void ReadFeatureSettings(YamlMapReader& map, ScriptableRendererFeature& feature,
                         const SceneAsset& asset, References& references,
                         AssetDiagnostics& diagnostics);

} // namespace limn

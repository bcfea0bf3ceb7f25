#pragma once

#include "unity_scene/UnityMaterials.h"

#include <limn/core/RenderSettings.h>

namespace limn
{

/// Reads an object of class 104, RenderSettings: ambient light, reflections, fog and the sky.
/// Settings that limn cannot read become notes. Until the sky is drawn, the scene is lit by the
/// average of the sky that Unity has baked, or by that of Unity's default sky.
/// @param settings  keeps the values that the object does not have
void ReadUnityRenderSettings(const UnityReader& reader, UnityMaterials& materials,
                             RenderSettings& settings);

} // namespace limn

#pragma once

#include "unity_scene/UnityMaterials.h"

#include <limn/core/RenderSettings.h>

namespace limn
{

/// Reads an object of class 104, RenderSettings: ambient light, reflections, fog and the sky. What
/// a scene has that limn cannot read becomes a note. Until the sky is drawn, its average that Unity
/// has baked lights the scene, or that of Unity's default sky.
/// @param settings  keeps what the object does not say
void ReadUnityRenderSettings(const UnityReader& reader, UnityMaterials& materials,
                             RenderSettings& settings);

} // namespace limn

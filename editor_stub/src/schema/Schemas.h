#pragma once

#include "schema/ValueSchema.h"

#include <limn/features/FeatureRegistry.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn
{

/// What a scene file may hold: its keys, and every feature's settings.
Json SceneSchema(const FeatureRegistry& features);

/// One item of a scene's `renderer.features`: any registered feature, by its `type`.
Json FeatureSchema(const FeatureRegistry& features);

/// A material as scenes write it.
Json MaterialSchema();

/// What a .material.yaml file may hold: the same, on its own.
Json MaterialFileSchema();

/// What a profile of limn's own form may hold: every registered component and parameter.
Json ProfileSchema(const VolumeComponentRegistry& registry);

/// A list of keys, the same with wrap modes around it, or Unity's form.
Json AnimationCurveSchema();

/// Keys with the value where there are none, a loop and its range; or Unity's form.
Json TextureCurveSchema();

} // namespace limn

#pragma once

#include "console/Json.h"

#include <limn/core/Inspector.h>
#include <limn/features/FeatureRegistry.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <limn/volume/YamlRead.h>
#include <string>
#include <string_view>

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

/// Keys keep their order, which is the one an editor offers them in.
// The JSON Schema of values as YamlRead and ReadLayers read them.

Json BoolSchema();
Json NumberSchema(ValueRange range = {});
Json IntegerSchema(ValueRange range = {});
Json TextSchema();
Json ColorSchema();
/// @param count  2, 3 or 4
Json VectorSchema(int count, ValueRange range = {});
Json LayerMaskSchema();
Json LayerIndexSchema();
/// A path, nothing, or Unity's {fileID, guid, type}.
Json ReferenceSchema();
Json EnumSchema(std::span<const std::string> names);
Json EnumSchema(std::span<const EnumEntry> entries);
Json RenderPassEventSchema();

/// A map that has these keys and no others.
Json MapSchema(Json properties);
Json ListSchema(Json items);

/// Adds a key in Unity's and in the plain spelling, of which a file may use one.
void AddProperty(Json& map, std::string_view name, const Json& value);

/// A whole schema: the map's keys with a title and the schema's version.
Json RootSchema(std::string_view title, const Json& map);

/// A YAML value as JSON: plain numbers and truth values are such.
Json ToJson(const YamlNode& node);

} // namespace limn

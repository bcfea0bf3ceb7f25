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

/// Returns the schema of scene files, with the settings of every feature.
Json SceneSchema(const FeatureRegistry& features);

/// Returns the schema of one item of a scene's `renderer.features`: any registered feature, by its
/// `type`.
Json FeatureSchema(const FeatureRegistry& features);

/// Returns the schema of a material as scenes write it.
Json MaterialSchema();

/// Returns the schema of profiles in limn's own form, with every registered component and
/// parameter.
Json ProfileSchema(const VolumeComponentRegistry& registry);

/// Returns the schema of a curve: a list of keys, the same with wrap modes around it, or Unity's
/// form.
Json AnimationCurveSchema();

/// Returns the schema of a texture curve: keys with the value for an empty list, a loop and its
/// range; or Unity's form.
Json TextureCurveSchema();

// The JSON Schema of values as YamlRead and ReadLayers read them. Keys keep their order, in which
// an editor offers them.

Json BoolSchema();
Json NumberSchema(ValueRange range = {});
Json IntegerSchema(ValueRange range = {});
Json TextSchema();
Json ColorSchema();
/// @param count  must be 2, 3 or 4
Json VectorSchema(int count, ValueRange range = {});
Json LayerMaskSchema();
Json LayerIndexSchema();
/// Returns the schema of a reference: a path, nothing, or Unity's {fileID, guid, type}.
Json ReferenceSchema();
Json EnumSchema(std::span<const std::string> names);
Json EnumSchema(std::span<const EnumEntry> entries);
Json RenderPassEventSchema();

/// Returns the schema of a map that has these keys and no others.
Json MapSchema(Json properties);
Json ListSchema(Json items);
Json WithDescription(Json schema, std::string_view text);
/// Returns the schema of a value that has one of several forms.
Json AnyOf(std::initializer_list<Json> schemas);

/// Adds a key in Unity's and in the plain spelling. A file may use one of the two.
void AddProperty(Json& map, std::string_view name, const Json& value);

/// Returns a whole schema: the map's keys with a title and the schema's version.
Json RootSchema(std::string_view title, const Json& map);

/// Returns a YAML value as JSON. Plain numbers and truth values become JSON numbers and booleans.
Json ToJson(const YamlNode& node);

} // namespace limn

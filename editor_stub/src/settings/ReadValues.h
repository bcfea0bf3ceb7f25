#pragma once

#include <cstdint>
#include <limn/core/Inspector.h>
#include <limn/editor_stub/LayerNames.h>
#include <limn/volume/YamlRead.h>

namespace limn
{

/// Layer names, and the noun for one in messages: "layer" or "rendering layer".
struct LayerKind
{
    const LayerNames& names;
    const char* noun;
};

/// Reads the names of a scene's `layers` or `renderingLayers`: {6: Furniture}.
void ReadLayerNames(const YamlNode& node, std::string_view subject, LayerNames& names,
                    AssetDiagnostics& diagnostics);

/// Reads one layer by its name or its number 0...31.
std::optional<int> ReadLayerIndex(const YamlNode& node, std::string_view subject,
                                  const LayerKind& kind, AssetDiagnostics& diagnostics);

/// Reads a set of layers: Everything, Nothing, a name, a list of names and numbers 0...31, the 32
/// bits as one number, Unity's {m_Bits: 64}, or a map of one number under another name.
std::optional<std::uint32_t> ReadLayerBits(const YamlNode& node, std::string_view subject,
                                           const LayerKind& kind, AssetDiagnostics& diagnostics);

/// Reads the value of an enum's member by its name or its number. An enum with a member Everything
/// is a set of bits: a list of names, any sum of numbers and Unity's -1 are read as well.
std::optional<int> ReadEnum(const YamlNode& node, std::span<const EnumEntry> entries,
                            std::string_view subject, AssetDiagnostics& diagnostics);

/// Reads a pass event: its name, a name with an offset ("AfterRenderingOpaques + 1"), or a number.
std::optional<RenderPassEvent> ReadRenderPassEvent(const YamlNode& node, std::string_view subject,
                                                   AssetDiagnostics& diagnostics);

} // namespace limn

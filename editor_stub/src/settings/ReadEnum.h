#pragma once

#include <limn/core/Inspector.h>
#include <limn/volume/YamlRead.h>

namespace limn
{

/// The value of an enum's member by its name or its number.
std::optional<int> ReadEnum(const YamlNode& node, std::span<const EnumEntry> entries,
                            std::string_view subject, AssetDiagnostics& diagnostics);

/// A pass event: its name, a name with a distance ("AfterRenderingOpaques + 1"), or a number.
std::optional<RenderPassEvent> ReadRenderPassEvent(const YamlNode& node, std::string_view subject,
                                                   AssetDiagnostics& diagnostics);

} // namespace limn

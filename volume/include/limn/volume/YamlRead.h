#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <limn/core/Color.h>
#include <limn/core/ValueRange.h>
#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/YamlNode.h>
#include <optional>
#include <string>
#include <string_view>

namespace limn
{

// Each reader returns the value, or nullopt and adds one error at the node's place. `subject` names
// the value in that error: "camera.fieldOfView".

/// Reads true, false, and 1 and 0 as Unity writes them, but not yes, no, on or off.
std::optional<bool> ReadBool(const YamlNode& node, std::string_view subject,
                             AssetDiagnostics& diagnostics);

/// Returns true for decimal digits, maybe with a sign, that are not in quotes.
bool LooksLikeNumber(const YamlNode& node);

/// Reads a whole number in decimal digits.
std::optional<std::int64_t> ReadInteger(const YamlNode& node, std::string_view subject,
                                        AssetDiagnostics& diagnostics, ValueRange range = {});
std::optional<int> ReadInt(const YamlNode& node, std::string_view subject,
                           AssetDiagnostics& diagnostics, ValueRange range = {});

/// Reads a finite number that fits in 32 bits.
std::optional<float> ReadFloat(const YamlNode& node, std::string_view subject,
                               AssetDiagnostics& diagnostics, ValueRange range = {});

/// Reads any scalar as text, quoted or not.
std::optional<std::string> ReadString(const YamlNode& node, std::string_view subject,
                                      AssetDiagnostics& diagnostics);

/// Reads `[1, 2, 3]` or `{x: 1, y: 2, z: 3}`; the components beyond `count` (2, 3 or 4) are 0.
std::optional<glm::vec4> ReadVector(const YamlNode& node, int count, std::string_view subject,
                                    AssetDiagnostics& diagnostics, ValueRange range = {});

/// The range of the numbers of a scene's colours, chosen so that lighting with them stays within a
/// float.
inline constexpr ValueRange k_ColorChannels{-1e9, 1e9};

/// Reads `{r: 0, g: 1, b: 0, a: 1}`, `[0, 1, 0]`, `[0, 1, 0, 1]`, "#00FF00" or "#00FF00FF", without
/// conversion between sRGB and linear. A missing alpha is 1.
std::optional<Color> ReadColor(const YamlNode& node, std::string_view subject,
                               AssetDiagnostics& diagnostics, ValueRange range = {});

/// Returns a number as a person writes it, without trailing zeros: "3", "0.25".
std::string NumberText(double number);
/// Returns the text of a range: "[1, 10]".
std::string RangeText(ValueRange range);

} // namespace limn

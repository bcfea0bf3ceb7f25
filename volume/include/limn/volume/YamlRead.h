#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec4.hpp>
#include <limits>
#include <limn/base/NumberText.h>
#include <limn/core/Color.h>
#include <limn/core/ValueRange.h>
#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/YamlNode.h>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

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

/// Reads a value of the type of `value`: bool, a whole number, float, std::string, Color or a
/// vector.
/// @return false, with one error and `value` as it was, if it cannot be read
template <typename T>
bool ReadValue(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
               T& value, ValueRange range = {})
{
    const auto read = [&]
    {
        if constexpr (std::is_same_v<T, bool>)
        {
            return ReadBool(node, subject, diagnostics);
        }
        else if constexpr (std::is_integral_v<T>)
        {
            range.min = std::max(range.min, static_cast<double>(std::numeric_limits<T>::min()));
            range.max = std::min(range.max, static_cast<double>(std::numeric_limits<T>::max()));
            return ReadInteger(node, subject, diagnostics, range);
        }
        else if constexpr (std::is_same_v<T, float>)
        {
            return ReadFloat(node, subject, diagnostics, range);
        }
        else if constexpr (std::is_same_v<T, std::string>)
        {
            return ReadString(node, subject, diagnostics);
        }
        else if constexpr (std::is_same_v<T, Color>)
        {
            return ReadColor(node, subject, diagnostics, range);
        }
        else
        {
            return ReadVector(node, T::length(), subject, diagnostics, range);
        }
    }();
    if (read)
    {
        value = static_cast<T>(*read);
    }
    return read.has_value();
}

/// Returns the text of a range: "[1, 10]".
std::string RangeText(ValueRange range);

} // namespace limn

#pragma once

#include <concepts>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limn/core/LayerMask.h>
#include <limn/volume/ProfileContext.h>
#include <limn/volume/TextureCurve.h>
#include <limn/volume/YamlRead.h>
#include <span>

// Reads the value of each type of parameter, and writes it in limn's form (LimnText) and in Unity's
// (UnityText). All texts fit on one line.

namespace limn::detail
{

/// The input of a reader: the node, its name in errors, where errors go, and the limits of a
/// number.
struct ValueSource
{
    const YamlNode& node;
    std::string_view subject;
    AssetDiagnostics& diagnostics;
    ValueRange range;
    const ProfileContext& context;

    ValueSource At(const YamlNode& below, std::string_view itsSubject) const
    {
        return {below, itsSubject, diagnostics, range, context};
    }
    /// Adds the error "subject: problem" and returns false.
    bool Refuse(std::string_view problem) const;
};

// Each returns whether it set the value; if not, there is an error.
template <typename T>
bool ReadValue(const ValueSource& source, T& value)
{
    return limn::ReadValue(source.node, source.subject, source.diagnostics, value, source.range);
}
bool ReadValue(const ValueSource& source, glm::vec2& value);
bool ReadValue(const ValueSource& source, LayerMask& value);
bool ReadValue(const ValueSource& source, RenderingLayerMask& value);
bool ReadValue(const ValueSource& source, AssetLocation& value);
bool ReadValue(const ValueSource& source, AnimationCurve& value);
bool ReadValue(const ValueSource& source, TextureCurve& value);

std::string LimnText(bool value);
std::string LimnText(float value);
std::string LimnText(const Color& value);
std::string LimnText(LayerMask value);
std::string LimnText(RenderingLayerMask value);
std::string LimnText(const AssetLocation& value);
std::string LimnText(const AnimationCurve& value);
std::string LimnText(const TextureCurve& value);

std::string UnityText(bool value);
std::string UnityText(float value);
std::string UnityText(const Color& value);
std::string UnityText(LayerMask value);
std::string UnityText(RenderingLayerMask value);
std::string UnityText(const AssetLocation& value);
std::string UnityText(const AnimationCurve& value);
std::string UnityText(const TextureCurve& value);

/// Returns "[1, 2]".
std::string ListText(std::span<const float> numbers);
/// Returns "{x: 1, y: 2}", with a letter of `names` for each number.
std::string FieldsText(std::span<const float> numbers, std::string_view names);

template <std::integral Number>
std::string LimnText(Number value)
{
    return std::to_string(value);
}

template <glm::length_t Count>
std::string LimnText(const glm::vec<Count, float>& value)
{
    return ListText(std::span(&value.x, Count));
}

template <std::integral Number>
std::string UnityText(Number value)
{
    return std::to_string(value);
}

template <glm::length_t Count>
std::string UnityText(const glm::vec<Count, float>& value)
{
    return FieldsText(std::span(&value.x, Count), "xyzw");
}

template <typename Asset>
bool ReadValue(const ValueSource& source, AssetReference<Asset>& value)
{
    AssetLocation location;
    const bool isRead = ReadValue(source, location);
    value = isRead ? AssetReference<Asset>{std::move(location), {}} : value;
    return isRead;
}

template <typename Asset>
std::string LimnText(const AssetReference<Asset>& value)
{
    return LimnText(value.location);
}

template <typename Asset>
std::string UnityText(const AssetReference<Asset>& value)
{
    return UnityText(value.location);
}

} // namespace limn::detail

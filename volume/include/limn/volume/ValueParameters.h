#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <limn/core/Color.h>
#include <limn/core/LayerMask.h>
#include <limn/volume/VolumeParameter.h>
#include <type_traits>

namespace limn::detail
{

/// Reads and writes the value of all parameters of one type. It blends like its base: the value
/// switches as soon as t > 0.
template <typename T>
class ValueParameter : public VolumeParameterT<T>
{
public:
    ValueParameter(VolumeComponent* owner, std::string_view name, T value, ParameterInfo info = {})
        : ValueParameter(owner, name, std::move(value), false, std::move(info))
    {
    }
    ValueParameter(VolumeComponent* owner, std::string_view name, T value, bool overrideState,
                   ParameterInfo info = {})
        : VolumeParameterT<T>(owner, name, std::move(value), overrideState, std::move(info))
    {
    }

    std::string ValueText() const override;
    std::string UnityText() const override;

protected:
    bool ReadNode(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                  const ProfileContext& context) override;
};

/// Blends to from (1 - t) + to t, per component; t is not clamped. Floats are blended in double, so
/// t = 1 gives exactly `to`, and a t between 0 and 1 gives no value beyond the two. Interp is
/// final, as in Unity.
template <typename T>
class LerpParameter : public ValueParameter<T>
{
public:
    using ValueParameter<T>::ValueParameter;
    using ValueParameter<T>::Interp;

    void Interp(const T& from, const T& to, float t) final;
};

/// A text as an argument of a template.
template <std::size_t Size>
struct FixedText
{
    constexpr FixedText(const char (&text)[Size]) { std::copy_n(text, Size, characters); }

    char characters[Size] = {};
};

/// A parameter like its base, under a type's name of its own.
template <typename Base, FixedText type>
class NamedParameter : public Base
{
public:
    using Base::Base;
    std::string_view typeName() const override { return type.characters; }
};

/// @throws ContractError about the parameter `name` unless min <= max
void CheckLimits(const std::string& name, double min, double max);

} // namespace limn::detail

namespace limn
{

/// A value that is on or off; blending switches as soon as t > 0. Unity: BoolParameter (URP 14).
class BoolParameter : public detail::ValueParameter<bool>
{
public:
    /// The control that an editor shows; blending and files ignore it.
    /// Unity: BoolParameter.DisplayType (URP 14).
    enum class DisplayType
    {
        Checkbox = 0,
        EnumPopup = 1
    };

    using ValueParameter::ValueParameter;

    BoolParameter(VolumeComponent* owner, std::string_view name, bool value, DisplayType type,
                  bool overrideState = false, ParameterInfo info = {})
        : ValueParameter(owner, name, value, overrideState, std::move(info)), displayType(type)
    {
    }

    const DisplayType displayType = DisplayType::Checkbox;

    std::string_view typeName() const override { return "Bool"; }
};

namespace detail
{

/// Hints for how an editor shows a colour; blending and files ignore them.
template <typename Base>
class ColorHints : public Base
{
public:
    using Base::Base;

    ColorHints(VolumeComponent* owner, std::string_view name, const Color& value, bool hdrColor,
               bool showAlphaChannel, bool showPicker, bool overrideState = false,
               ParameterInfo info = {})
        : Base(owner, name, value, overrideState, std::move(info)),
          hdr(hdrColor),
          showAlpha(showAlphaChannel),
          showEyeDropper(showPicker)
    {
    }

    const bool hdr = false;           ///< channels above 1 have a meaning
    const bool showAlpha = true;      ///< the alpha channel has a meaning
    const bool showEyeDropper = true; ///< the colour may be picked from the screen
};

} // namespace detail

/// A colour, blended linearly per channel (also alpha), in the colour space of its values.
/// Unity: ColorParameter (URP 14).
using ColorParameter =
    detail::NamedParameter<detail::ColorHints<detail::LerpParameter<Color>>, "Color">;

/// A colour; blending switches as soon as t > 0. Unity: NoInterpColorParameter (URP 14).
using NoInterpColorParameter =
    detail::NamedParameter<detail::ColorHints<detail::ValueParameter<Color>>, "NoInterpColor">;

/// Two numbers, each blended linearly. Unity: Vector2Parameter (URP 14).
using Vector2Parameter = detail::NamedParameter<detail::LerpParameter<glm::vec2>, "Vector2">;

/// Two numbers; blending switches as soon as t > 0. Unity: NoInterpVector2Parameter (URP 14).
using NoInterpVector2Parameter =
    detail::NamedParameter<detail::ValueParameter<glm::vec2>, "NoInterpVector2">;

/// Three numbers, each blended linearly. Unity: Vector3Parameter (URP 14).
using Vector3Parameter = detail::NamedParameter<detail::LerpParameter<glm::vec3>, "Vector3">;

/// Three numbers; blending switches as soon as t > 0. Unity: NoInterpVector3Parameter (URP 14).
using NoInterpVector3Parameter =
    detail::NamedParameter<detail::ValueParameter<glm::vec3>, "NoInterpVector3">;

/// Four numbers, each blended linearly. Unity: Vector4Parameter (URP 14).
using Vector4Parameter = detail::NamedParameter<detail::LerpParameter<glm::vec4>, "Vector4">;

/// Four numbers; blending switches as soon as t > 0. Unity: NoInterpVector4Parameter (URP 14).
using NoInterpVector4Parameter =
    detail::NamedParameter<detail::ValueParameter<glm::vec4>, "NoInterpVector4">;

/// A set of layers; blending switches as soon as t > 0. YAML has the bits as one number, "Nothing",
/// "Everything", a list of indices or of Unity's built-in layers' names ("Default", "UI"), or
/// {m_Bits: 5}. A profile does not know the names that a scene gives its layers.
/// Unity: LayerMaskParameter (URP 14).
using LayerMaskParameter = detail::NamedParameter<detail::ValueParameter<LayerMask>, "LayerMask">;

/// A set of rendering layers; blending switches as soon as t > 0. It is written in YAML like a
/// LayerMask, but the list has no names. Unity: RenderingLayerMaskParameter (URP 17).
using RenderingLayerMaskParameter =
    detail::NamedParameter<detail::ValueParameter<RenderingLayerMask>, "RenderingLayerMask">;

/// A value of an enum and its name in files.
template <typename T>
struct EnumName
{
    std::string name;
    T value;
};

namespace detail
{

using EnumNames = std::vector<EnumName<std::int64_t>>;

/// Reads a value by name or by number. Anything else is an error that lists the names.
std::optional<std::int64_t> ReadEnum(const YamlNode& node, std::string_view subject,
                                     AssetDiagnostics& diagnostics, const EnumNames& names);
/// Returns the name of the value, or the number itself if it has none.
std::string EnumText(std::int64_t value, const EnumNames& names);

} // namespace detail

/// A value of an enum; blending switches as soon as t > 0. YAML has its name or its number; Unity
/// writes the number.
///
///     EnumParameter<Mode> m_Mode{this, "m_Mode", Mode::Off, {{"Off", Mode::Off}, {"On",
///     Mode::On}}};
///
/// Unity: EnumParameter<T> (URP 17).
template <typename T>
class EnumParameter : public VolumeParameterT<T>
{
    static_assert(std::is_enum_v<T>);

public:
    EnumParameter(VolumeComponent* owner, std::string_view name, T value,
                  std::initializer_list<EnumName<T>> names, ParameterInfo info = {})
        : EnumParameter(owner, name, value, names, false, std::move(info))
    {
    }
    EnumParameter(VolumeComponent* owner, std::string_view name, T value,
                  std::initializer_list<EnumName<T>> names, bool overrideState,
                  ParameterInfo info = {})
        : VolumeParameterT<T>(owner, name, value, overrideState, std::move(info))
    {
        for (const EnumName<T>& entry : names)
        {
            m_Names.push_back({entry.name, static_cast<std::int64_t>(entry.value)});
        }
    }

    std::string ValueText() const override { return detail::EnumText(number(), m_Names); }
    std::string UnityText() const override { return std::to_string(number()); }
    std::string_view typeName() const override { return "Enum"; }
    std::vector<std::string> valueNames() const override
    {
        std::vector<std::string> names;
        for (const auto& entry : m_Names)
        {
            names.push_back(entry.name);
        }
        return names;
    }

private:
    bool ReadNode(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                  const ProfileContext&) override
    {
        const auto read = detail::ReadEnum(node, subject, diagnostics, m_Names);
        this->m_Value = read ? static_cast<T>(*read) : this->m_Value;
        return read.has_value();
    }
    std::int64_t number() const { return static_cast<std::int64_t>(this->m_Value); }

    detail::EnumNames m_Names;
};

} // namespace limn

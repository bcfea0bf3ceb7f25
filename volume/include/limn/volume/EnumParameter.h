#pragma once

#include <cstdint>
#include <initializer_list>
#include <limn/volume/VolumeParameter.h>
#include <type_traits>

namespace limn
{

/// A value of an enum and what files call it.
template <typename T>
struct EnumName
{
    std::string name;
    T value;
};

namespace detail
{

using EnumNames = std::vector<EnumName<std::int64_t>>;

/// By name or by number; an error that lists the names for anything that is not among them.
std::optional<std::int64_t> ReadEnum(const YamlNode& node, std::string_view subject,
                                     AssetDiagnostics& diagnostics, const EnumNames& names);
/// The name of the value; the number itself if it has none.
std::string EnumText(std::int64_t value, const EnumNames& names);

} // namespace detail

/// One of a list; blending switches as soon as t > 0. In YAML by name or by number; Unity writes
/// the number.
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

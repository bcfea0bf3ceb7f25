#pragma once

#include <concepts>
#include <limn/volume/VolumeComponent.h>

namespace limn
{

namespace detail
{

/// What all ObjectParameters do, whatever the type of their object.
class ObjectParameterBase : public VolumeParameter
{
public:
    /// Does nothing: always overridden, as in Unity. The object's parameters are or are not.
    void SetOverrideState(bool) override {}
    std::span<VolumeParameter* const> parameters() const override;

    std::string ValueText() const override; ///< the overridden parameters
    std::string UnityText() const override;
    std::string_view typeName() const override { return "Object"; }

protected:
    ObjectParameterBase(VolumeComponent* owner, std::string_view name,
                        std::unique_ptr<VolumeComponent> value, ParameterInfo info);

    std::unique_ptr<VolumeComponent> m_Value;

private:
    virtual std::unique_ptr<VolumeComponent> Create() const = 0;
    bool ReadNode(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                  const ProfileContext& context) final;
    void InterpValues(const VolumeParameter& from, const VolumeParameter& to, float t) final;
    void CopyValue(const VolumeParameter& other) final;
    const ObjectParameterBase& Cast(const VolumeParameter& other) const;
    void CopyParameters(const VolumeComponent& from);
};

} // namespace detail

/// A group of parameters within a parameter. Blending copies the override states of `to` and blends
/// the parameters overridden there; without an object in any of the three it does nothing. In YAML
/// a map of the object's parameters; the ones named are overridden, no object is {}.
///
/// The object is a VolumeComponent, as that is what parameters register with, and it belongs to
/// this parameter alone: copying a value copies the parameters, where Unity shares the object.
/// Unity: ObjectParameter<T> (URP 14).
template <std::derived_from<VolumeComponent> T>
class ObjectParameter final : public detail::ObjectParameterBase
{
public:
    using VolumeParameter::SetValue;

    /// @param value  may be null
    ObjectParameter(VolumeComponent* owner, std::string_view name, std::unique_ptr<T> value,
                    ParameterInfo info = {})
        : ObjectParameterBase(owner, name, std::move(value), std::move(info))
    {
    }

    void SetValue(std::unique_ptr<T> value) { m_Value = std::move(value); }

    T* value() { return static_cast<T*>(m_Value.get()); } ///< null if there is none
    const T* value() const { return static_cast<const T*>(m_Value.get()); }

private:
    std::unique_ptr<VolumeComponent> Create() const override { return std::make_unique<T>(); }
};

} // namespace limn

#pragma once

#include <limn/volume/ProfileContext.h>
#include <limn/volume/YamlRead.h>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limn
{

/// The documentation of a parameter for people, beside its name, default and range.
struct ParameterInfo
{
    std::string tooltip = {}; ///< one sentence; Unity's [Tooltip]
    /// The unit of the number: "pixels", "metres", "degrees"; "" if it has none.
    std::string unit = {};
};

class VolumeComponent;

/// One value of a volume component that volumes override and blend. Declared as a member of its
/// component, with the component as `owner`, it puts itself on the component's list of parameters.
/// Unity: UnityEngine.Rendering.VolumeParameter (URP 14).
class VolumeParameter
{
public:
    VolumeParameter(const VolumeParameter&) = delete;
    VolumeParameter& operator=(const VolumeParameter&) = delete;
    virtual ~VolumeParameter() = default;

    /// Sets this to the blend of `from` and `to`, without looking at any override state; t is not
    /// clamped. `from` may be this parameter.
    /// @throws ContractError unless all three hold the same type of value
    void Interp(const VolumeParameter& from, const VolumeParameter& to, float t)
    {
        InterpValues(from, to, t);
    }

    /// Copies the other's value without clamping it; the override state stays.
    /// @throws ContractError unless both hold the same type of value
    void SetValue(const VolumeParameter& other) { CopyValue(other); }

    /// Sets the value to that of the node; the override state stays.
    /// @param subject  the name of the value in errors: "ScreenSpaceOutline.m_OutlineWidth"
    /// @param context  resolves names of layers and loads references
    /// @return false, with the reason in `diagnostics` and the value untouched, if the node's value
    ///     does not fit this parameter; a number outside range() does not fit
    bool ReadYaml(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                  const ProfileContext& context = {})
    {
        return ReadNode(node, subject, diagnostics, context);
    }

    virtual void SetOverrideState(bool state) { m_OverrideState = state; }

    /// Returns whether its profile sets the parameter or, in a stack, whether a volume overrides
    /// it.
    bool overrideState() const { return m_OverrideState; }
    const std::string& name() const { return m_Name; } ///< Unity's serialised name

    const std::string& tooltip() const { return m_Info.tooltip; }
    const std::string& unit() const { return m_Info.unit; } ///< "pixels"; "" for none

    virtual std::string ValueText() const = 0; ///< the value in limn's YAML, on one line
    /// Returns the value as m_Value of Unity's YAML, on one line.
    virtual std::string UnityText() const = 0;
    virtual std::string_view typeName() const = 0; ///< "ClampedFloat"

    /// Returns the range of numbers that SetValue and files keep to, or nullopt if there is no
    /// limit.
    virtual std::optional<ValueRange> range() const { return std::nullopt; }
    /// Returns the names of an enum's values in the order of their declaration; empty for any other
    /// type.
    virtual std::vector<std::string> valueNames() const { return {}; }
    /// Returns the parameters within the value of an ObjectParameter; empty for any other
    /// parameter.
    virtual std::span<VolumeParameter* const> parameters() const { return {}; }

protected:
    /// @param owner  the component that has this parameter as a member, or null if there is none
    VolumeParameter(VolumeComponent* owner, std::string_view name, bool overrideState,
                    ParameterInfo info = {});

    /// @throws ContractError about two parameters that hold different types of value
    [[noreturn]] void RefuseOtherType(const VolumeParameter& other) const;

private:
    /// Implements ReadYaml.
    virtual bool ReadNode(const YamlNode& node, std::string_view subject,
                          AssetDiagnostics& diagnostics, const ProfileContext& context) = 0;
    virtual void InterpValues(const VolumeParameter& from, const VolumeParameter& to, float t) = 0;
    virtual void CopyValue(const VolumeParameter& other) = 0;

    std::string m_Name;
    ParameterInfo m_Info;
    bool m_OverrideState;
};

/// A parameter whose value is a T. Unless a subclass blends, it switches from one value to the
/// other as soon as t > 0. Unity: VolumeParameter<T>.
template <typename T>
class VolumeParameterT : public VolumeParameter
{
public:
    using ValueType = T;
    using VolumeParameter::Interp;
    using VolumeParameter::SetValue;

    /// Sets the value to the blend of the two; neither t nor the result is clamped.
    virtual void Interp(const T& from, const T& to, float t) { m_Value = t > 0.0f ? to : from; }

    /// Sets the value; a parameter with a range clamps it.
    virtual void SetValue(const T& value) { m_Value = value; }

    /// Sets the override state and the value; the value is not clamped, as in Unity.
    void Override(const T& value)
    {
        SetOverrideState(true);
        m_Value = value;
    }

    const T& value() const { return m_Value; }

protected:
    /// @param value  the initial value, which is not clamped
    VolumeParameterT(VolumeComponent* owner, std::string_view name, T value, bool overrideState,
                     ParameterInfo info = {})
        : VolumeParameter(owner, name, overrideState, std::move(info)), m_Value(std::move(value))
    {
    }

    T m_Value;

private:
    void InterpValues(const VolumeParameter& from, const VolumeParameter& to, float t) final
    {
        Interp(Cast(from).m_Value, Cast(to).m_Value, t);
    }

    void CopyValue(const VolumeParameter& other) final { m_Value = Cast(other).m_Value; }

    const VolumeParameterT& Cast(const VolumeParameter& other) const
    {
        const auto* same = dynamic_cast<const VolumeParameterT*>(&other);
        if (!same)
        {
            RefuseOtherType(other);
        }
        return *same;
    }
};

} // namespace limn

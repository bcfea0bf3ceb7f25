#pragma once

#include <algorithm>
#include <limn/volume/VolumeParameter.h>
#include <span>
#include <string>
#include <vector>

namespace limn
{

/// Returns the parameter with that serialised or plain name ("m_OutlineWidth", "outlineWidth"), or
/// null if there is none.
VolumeParameter* FindParameter(std::span<VolumeParameter* const> parameters, std::string_view name);

/// A group of parameters that belong to one effect. A subclass declares them as members:
///
///     ClampedFloatParameter m_OutlineWidth{this, "m_OutlineWidth", 3.0f, 1.0f, 10.0f};
///
/// A component can be neither copied nor moved, because its list of parameters points at its
/// members. Unity: UnityEngine.Rendering.VolumeComponent (URP 14).
class VolumeComponent
{
public:
    VolumeComponent() = default;
    VolumeComponent(const VolumeComponent&) = delete;
    VolumeComponent& operator=(const VolumeComponent&) = delete;
    virtual ~VolumeComponent() = default;

    bool active = true;      ///< false: ignored altogether
    std::string displayName; ///< for people; "" means the name of the type

    /// Blends every overridden parameter onto the state's parameter and marks that one as
    /// overridden.
    /// @throws ContractError if `state` is of another type
    virtual void Override(VolumeComponent& state, float interpFactor) const;

    /// Sets the override state of all parameters, also of those within ObjectParameters.
    void SetAllOverridesTo(bool state);

    /// Returns whether any parameter is overridden; an ObjectParameter always is, as in Unity.
    bool AnyPropertiesIsOverridden() const
    {
        return std::ranges::any_of(m_Parameters, [](const VolumeParameter* parameter)
                                   { return parameter->overrideState(); });
    }

    /// Returns the parameters in the order of their declaration.
    std::span<VolumeParameter* const> parameters() { return m_Parameters; }
    std::span<const VolumeParameter* const> parameters() const { return m_Parameters; }

    /// Returns one of the parameters as the other FindParameter does.
    VolumeParameter* FindParameter(std::string_view name)
    {
        return limn::FindParameter(m_Parameters, name);
    }
    const VolumeParameter* FindParameter(std::string_view name) const
    {
        return limn::FindParameter(m_Parameters, name);
    }

private:
    friend class VolumeParameter;
    void Register(VolumeParameter& parameter);

    std::vector<VolumeParameter*> m_Parameters;
};

/// The interface of a volume component of a visual effect, asked before its pass is added.
/// Unity: UnityEngine.Rendering.Universal.IPostProcessComponent (URP 14).
class IPostProcessComponent
{
public:
    virtual ~IPostProcessComponent() = default;

    virtual bool IsActive() const = 0; ///< whether the effect shows with the current values
    virtual bool IsTileCompatible() const = 0;
};

} // namespace limn

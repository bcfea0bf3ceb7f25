#pragma once

#include <concepts>
#include <limn/volume/VolumeComponent.h>
#include <memory>
#include <span>
#include <typeinfo>
#include <vector>

namespace limn
{

class VolumeComponentRegistry;

/// The components that a volume applies, at most one of each type. Queries compare exact types
/// unless their documentation says otherwise. Unity: UnityEngine.Rendering.VolumeProfile (URP 14).
class VolumeProfile
{
public:
    VolumeProfile() = default;
    VolumeProfile(VolumeProfile&&) = default;
    VolumeProfile& operator=(VolumeProfile&&) = default;

    std::string name; ///< for people; Unity's m_Name or the file's

    /// Adds a component with the values of its constructor.
    /// @param overrides  the override state of all its parameters
    /// @throws ContractError if there is a component of that type already
    template <std::derived_from<VolumeComponent> T>
    T& Add(bool overrides = false)
    {
        auto component = std::make_unique<T>();
        component->SetAllOverridesTo(overrides);
        return static_cast<T&>(Add(std::move(component)));
    }

    /// @throws ContractError for null, and if there is a component of that type already
    VolumeComponent& Add(std::unique_ptr<VolumeComponent> component);

    /// Removes the component of type T; does nothing if there is none.
    template <std::derived_from<VolumeComponent> T>
    void Remove()
    {
        Remove(typeid(T));
    }

    template <std::derived_from<VolumeComponent> T>
    bool Has() const
    {
        return Find(typeid(T)) != nullptr;
    }

    /// Returns the component of type T, also an inactive one, or null if there is none. It lives
    /// until it is removed.
    template <std::derived_from<VolumeComponent> T>
    T* TryGet()
    {
        return static_cast<T*>(Find(typeid(T)));
    }
    template <std::derived_from<VolumeComponent> T>
    const T* TryGet() const
    {
        return static_cast<const T*>(Find(typeid(T)));
    }

    /// Returns whether there is a component that is a T or derived from it.
    template <std::derived_from<VolumeComponent> T>
    bool HasSubclassOf() const
    {
        return TryGetSubclassOf<T>() != nullptr;
    }

    /// Returns the first component that is a T or derived from it, or null if there is none.
    template <std::derived_from<VolumeComponent> T>
    const T* TryGetSubclassOf() const
    {
        const std::vector<const T*> all = TryGetAllSubclassOf<T>();
        return all.empty() ? nullptr : all.front();
    }

    /// Returns every component that is a T or derived from it, in the order in which they were
    /// added.
    template <std::derived_from<VolumeComponent> T>
    std::vector<const T*> TryGetAllSubclassOf() const
    {
        std::vector<const T*> found;
        for (const std::unique_ptr<VolumeComponent>& component : m_Components)
        {
            if (const T* derived = dynamic_cast<const T*>(component.get()))
            {
                found.push_back(derived);
            }
        }
        return found;
    }

    /// Returns a profile with copies of all components, their values and override states included.
    /// @throws ContractError if the registry lacks the type of a component
    VolumeProfile Clone(const VolumeComponentRegistry& registry) const;

    /// Returns the components in the order in which they were added, which is also the order in
    /// which they are applied.
    std::span<const std::unique_ptr<VolumeComponent>> components() const { return m_Components; }

private:
    VolumeComponent* Find(const std::type_info& type) const;
    void Remove(const std::type_info& type);

    std::vector<std::unique_ptr<VolumeComponent>> m_Components;
};

} // namespace limn

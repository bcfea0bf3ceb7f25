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

/// The components a volume brings, at most one of each type. Queries compare exact types unless
/// they say otherwise.
/// Unity: UnityEngine.Rendering.VolumeProfile (URP 14).
class VolumeProfile
{
public:
    VolumeProfile() = default;
    VolumeProfile(VolumeProfile&&) = default;
    VolumeProfile& operator=(VolumeProfile&&) = default;

    std::string name; ///< for people; Unity's m_Name or the file's

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

    /// Does nothing if there is none.
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

    /// Also an inactive one; null if there is none. Lives until removed.
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

    /// Whether there is a T or something derived from it.
    template <std::derived_from<VolumeComponent> T>
    bool HasSubclassOf() const
    {
        return TryGetSubclassOf<T>() != nullptr;
    }

    /// The first component that is a T or derived from it; null if there is none.
    template <std::derived_from<VolumeComponent> T>
    const T* TryGetSubclassOf() const
    {
        const std::vector<const T*> all = TryGetAllSubclassOf<T>();
        return all.empty() ? nullptr : all.front();
    }

    /// Every component that is a T or derived from it, in the order they were added.
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

    /// A profile with copies of all components, values, override states and all.
    /// @throws ContractError if the registry lacks the type of a component
    VolumeProfile Clone(const VolumeComponentRegistry& registry) const;

    /// In the order they were added, which is the order they are applied in.
    std::span<const std::unique_ptr<VolumeComponent>> components() const { return m_Components; }

private:
    VolumeComponent* Find(const std::type_info& type) const;
    void Remove(const std::type_info& type);

    std::vector<std::unique_ptr<VolumeComponent>> m_Components;
};

} // namespace limn

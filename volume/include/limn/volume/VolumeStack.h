#pragma once

#include <concepts>
#include <cstdint>
#include <limn/volume/VolumeComponentRegistry.h>
#include <memory>
#include <vector>

namespace limn
{

/// The blended values that a camera uses: one component of every registered type. A VolumeManager
/// creates and updates it. Unity: UnityEngine.Rendering.VolumeStack (URP 14).
class VolumeStack
{
public:
    VolumeStack(VolumeStack&&) = default;
    VolumeStack& operator=(VolumeStack&&) = default;

    /// Returns the stack of a camera without blended volumes: it has every type of component,
    /// registered or not, with the values of its constructor. (Unity: VolumeManager.instance.stack
    /// before the first camera.)
    static const VolumeStack& Defaults();

    /// Returns the blended component, with its defaults where no volume set anything. Returns null
    /// only if the type was not registered when the stack was created. The component lives as long
    /// as the stack.
    template <std::derived_from<VolumeComponent> T>
    const T* GetComponent() const
    {
        if (this == &Defaults())
        {
            static const T defaults;
            return &defaults;
        }
        return static_cast<const T*>(Find(typeid(T)));
    }

    const VolumeComponent* GetComponent(std::type_index type) const { return Find(type); }

    /// Returns whether the next Update without any volume must restore the defaults.
    bool requiresReset() const { return m_RequiresReset || m_DefaultsSeen != *m_Defaults; }

private:
    friend class VolumeManager;

    struct Slot
    {
        std::type_index type;
        std::unique_ptr<VolumeComponent> state;
        const VolumeComponent* defaults; ///< in the registry
    };

    VolumeStack(const VolumeComponentRegistry& registry,
                std::shared_ptr<const std::uint64_t> defaults);

    VolumeComponent* Find(std::type_index type) const;
    void Reset();

    std::vector<Slot> m_Slots; ///< ordered by type
    bool m_RequiresReset = true;
    /// The manager's count of the changes of its defaults.
    std::shared_ptr<const std::uint64_t> m_Defaults;
    std::uint64_t m_DefaultsSeen;
};

} // namespace limn

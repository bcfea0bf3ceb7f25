#pragma once

#include <concepts>
#include <cstdint>
#include <limn/volume/VolumeComponentRegistry.h>
#include <memory>
#include <vector>

namespace limn
{

/// The blended values a camera sees: one component of every registered type. Created and updated by
/// a VolumeManager. Unity: UnityEngine.Rendering.VolumeStack (URP 14).
class VolumeStack
{
public:
    VolumeStack(VolumeStack&&) = default;
    VolumeStack& operator=(VolumeStack&&) = default;

    /// The stack of a camera that nobody blended volumes for: every type of component with the
    /// values of its constructor, registered or not. (Unity: VolumeManager.instance.stack before
    /// the first camera.)
    static const VolumeStack& Defaults();

    /// The blended component, with its defaults where no volume set anything; null only if the type
    /// was not registered when the stack was created. Lives as long as the stack.
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

    /// Whether the next Update without any volume has to bring the defaults back.
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
    std::shared_ptr<const std::uint64_t> m_Defaults; ///< the manager's count of their changes
    std::uint64_t m_DefaultsSeen;
};

} // namespace limn

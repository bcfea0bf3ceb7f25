#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <limn/volume/Collider.h>
#include <limn/volume/VolumeProfile.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace limn
{

class VolumeManager;

namespace detail
{

/// Lets managers follow a volume that moves, for example in a vector that grows, and notice its
/// destruction. A copy is another volume.
class VolumePlace
{
public:
    VolumePlace() = default;
    VolumePlace(const VolumePlace&) noexcept {}
    VolumePlace(VolumePlace&& other) noexcept { Take(other); }
    VolumePlace& operator=(const VolumePlace&) noexcept { return *this; }
    VolumePlace& operator=(VolumePlace&& other) noexcept
    {
        Take(other);
        return *this;
    }
    ~VolumePlace() { Leave(); }

private:
    friend class limn::VolumeManager;

    void Take(VolumePlace& other) noexcept
    {
        const auto address = std::move(other.m_Address);
        Leave();
        m_Address = address;
        if (m_Address)
        {
            *m_Address = this;
        }
    }
    void Leave() noexcept
    {
        if (m_Address)
        {
            *m_Address = nullptr;
        }
        m_Address.reset();
    }

    /// The volume's present address; the pointer is null until the volume is registered, its target
    /// is null once the volume is gone.
    mutable std::shared_ptr<const VolumePlace*> m_Address;
};

} // namespace detail

/// A profile placed in a scene: everywhere, or where its colliders are. A volume takes part from
/// its registration with a VolumeManager until it is unregistered or destroyed. A moved volume
/// stays registered; a copy is not registered. Fields may change at any time; the manager looks at
/// them in every Update. Unity: UnityEngine.Rendering.Volume (URP 14).
struct Volume : detail::VolumePlace
{
    std::string name;      ///< for people
    bool enabled = true;   ///< true if both the component and its GameObject are enabled
    bool isGlobal = true;  ///< true: applies everywhere and ignores colliders and blendDistance
    float priority = 0.0f; ///< higher is applied later and wins
    /// The distance from the colliders within which the effect fades, in metres, >= 0. It fades
    /// with the square of the distance: three quarters of it are left half-way out.
    float blendDistance = 0.0f;
    float weight = 1.0f; ///< the weight of the whole volume; clamped to [0, 1] where it is used
    int layer = 0;       ///< 0...31; the camera's volume layer mask must contain it
    std::shared_ptr<const VolumeProfile> sharedProfile; ///< null: the volume does nothing

    glm::vec3 position{0.0f};       ///< world, metres
    glm::quat rotation{1, 0, 0, 0}; ///< world, unit length
    glm::vec3 scale{1.0f};          ///< world
    /// The shapes of a local volume; the closest enabled one counts.
    std::vector<Collider> colliders;

    /// Returns the volume's own copy of the shared profile. The first call makes it (an empty
    /// profile if there is no shared one); from then on it counts in place of the shared one,
    /// changed or not. Copies of the volume share it. It lives until SetProfile. Unity: the getter
    /// of Volume.profile.
    /// @throws ContractError if the registry lacks the type of a component
    VolumeProfile& profile(const VolumeComponentRegistry& registry);

    /// Replaces the private copy with another profile. With null the shared profile counts again.
    void SetProfile(std::shared_ptr<VolumeProfile> profile) { m_Profile = std::move(profile); }

    bool HasInstantiatedProfile() const { return m_Profile != nullptr; }

    /// Returns the profile that counts, private or shared; it may be null.
    const VolumeProfile* profileRef() const
    {
        return m_Profile ? m_Profile.get() : sharedProfile.get();
    }

private:
    std::shared_ptr<VolumeProfile> m_Profile;
};

} // namespace limn

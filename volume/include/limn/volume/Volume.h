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

/// Lets managers find a volume that moves, as in a vector that grows, and see that it is gone. A
/// copy is another volume.
class VolumePlace
{
public:
    VolumePlace() = default;
    VolumePlace(const VolumePlace&) noexcept {}
    VolumePlace(VolumePlace&& other) noexcept { Take(other); }
    VolumePlace& operator=(const VolumePlace&) noexcept { return *this; }
    VolumePlace& operator=(VolumePlace&& other) noexcept
    {
        if (this != &other)
        {
            Leave();
            Take(other);
        }
        return *this;
    }
    ~VolumePlace() { Leave(); }

private:
    friend class limn::VolumeManager;

    void Take(VolumePlace& other) noexcept
    {
        m_Address = std::move(other.m_Address);
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

    /// Null until the volume is registered; its target is null once the volume is gone.
    mutable std::shared_ptr<const VolumePlace*> m_Address;
};

} // namespace detail

/// A profile put into a scene: everywhere, or where its colliders are. Takes part once it is
/// registered with a VolumeManager, until it is unregistered or destroyed; moved, it stays
/// registered, and a copy of it is not. Fields may change at any time; the manager looks at them in
/// every Update. Unity: UnityEngine.Rendering.Volume (URP 14).
struct Volume : detail::VolumePlace
{
    std::string name;      ///< for people
    bool enabled = true;   ///< of the component and its GameObject together
    bool isGlobal = true;  ///< true: applies everywhere, colliders and blendDistance ignored
    float priority = 0.0f; ///< higher is applied later and wins
    /// Metres outside the colliders where the effect fades, >= 0: with the square of the distance,
    /// so that half-way out three quarters of it are left.
    float blendDistance = 0.0f;
    float weight = 1.0f; ///< of the whole volume; used clamped to [0, 1]
    int layer = 0;       ///< 0...31; the camera's volume layer mask must have it
    std::shared_ptr<const VolumeProfile> sharedProfile; ///< null: the volume does nothing

    glm::vec3 position{0.0f};        ///< world, metres
    glm::quat rotation{1, 0, 0, 0};  ///< world, unit length
    glm::vec3 scale{1.0f};           ///< world
    std::vector<Collider> colliders; ///< of a local volume; the closest enabled one counts

    /// The volume's own copy of the shared profile, made by the first call (an empty profile where
    /// there is none); from then on it counts in place of the shared one, changed or not. Copies
    /// of the volume share it. Lives until SetProfile. Unity: the getter of Volume.profile.
    /// @throws ContractError if the registry lacks the type of a component
    VolumeProfile& profile(const VolumeComponentRegistry& registry);

    /// Puts another profile in place of the private copy; null: the shared one counts again.
    void SetProfile(std::shared_ptr<VolumeProfile> profile) { m_Profile = std::move(profile); }

    bool HasInstantiatedProfile() const { return m_Profile != nullptr; }

    /// The profile that counts, private or shared; may be null.
    const VolumeProfile* profileRef() const
    {
        return m_Profile ? m_Profile.get() : sharedProfile.get();
    }

private:
    std::shared_ptr<VolumeProfile> m_Profile;
};

} // namespace limn

#pragma once

#include <concepts>
#include <glm/vec3.hpp>
#include <limn/core/LayerMask.h>
#include <limn/core/RenderingData.h>
#include <limn/volume/Volume.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <limn/volume/VolumeStack.h>
#include <limn/volume/VolumeTrace.h>
#include <optional>
#include <span>
#include <typeinfo>
#include <vector>

namespace limn
{

/// Blends the volumes registered with it into stacks. It is no singleton: two managers never see
/// each other's volumes. Unity: UnityEngine.Rendering.VolumeManager (URP 14).
class VolumeManager
{
public:
    /// @lifetime  keeps `registry` by reference, and so do the stacks
    explicit VolumeManager(const VolumeComponentRegistry& registry) : m_Registry(registry) {}
    VolumeManager(const VolumeManager&) = delete;
    VolumeManager& operator=(const VolumeManager&) = delete;

    /// Creates a stack with one component of every type registered so far, all at their defaults.
    /// These are the constructors' values with the default profiles on top.
    VolumeStack CreateStack() const;

    /// Sets what stacks show where no volume counts: the constructors' values, then the active
    /// components' overridden parameters of the global profile, of the quality profile and of the
    /// custom ones in this order, with full weight. Null stands for no profile. Stacks change in
    /// their next Update. Unity: URP 17; URP 14 has only the constructors' values.
    void SetGlobalDefaultProfile(std::shared_ptr<const VolumeProfile> profile);
    void SetQualityDefaultProfile(std::shared_ptr<const VolumeProfile> profile);
    /// Sets the custom default profiles; null ones are ignored.
    void SetCustomDefaultProfiles(std::vector<std::shared_ptr<const VolumeProfile>> profiles);

    /// Must be called after an edit to a default profile if no volume is registered, because Update
    /// would not notice the edit. Does nothing for other profiles.
    void OnVolumeProfileChanged(const VolumeProfile& profile);

    /// Returns the stack of the camera that this thread renders, for helpers that are given no
    /// RenderingData. Returns the stack of the defaults while no camera is rendered.
    /// Unity: VolumeManager.instance.stack.
    static VolumeStackPointer stack();
    /// Lets code ported from C# keep `VolumeManager.instance.stack`; limn has no global manager.
    struct Instance
    {
        VolumeStackPointer stack() const { return VolumeManager::stack(); }
    };
    static Instance instance() { return {}; }

    /// Registers a volume. Volumes of equal priority are applied in the order of registration.
    /// @return false if it is registered already
    /// @throws ContractError for null and for a layer outside 0...31
    /// @lifetime  follows the volume when it is moved and forgets it when it is destroyed
    bool Register(const Volume* volume);

    /// Unregisters a volume; does nothing if it is not registered.
    void Unregister(const Volume* volume);

    /// Brings the stack to its defaults and applies the volumes in the mask's layers, by ascending
    /// priority. Changed layers and priorities are noticed here; a volume whose layer changed
    /// counts as registered last, and one whose priority changes back to that of others keeps the
    /// place it had, as in Unity.
    /// @param trigger  the world position from which local volumes measure (Unity's volume
    ///     trigger); without one only global volumes count
    /// @throws ContractError for a volume whose layer is outside 0...31
    void Update(VolumeStack& stack, const std::optional<glm::vec3>& trigger, LayerMask layerMask);

    /// Returns where every overridden value that Update would give comes from, by the same rules.
    /// Unlike Update it allocates.
    /// @throws ContractError like Update, and if the registry lacks the type of a component
    VolumeTrace Trace(const std::optional<glm::vec3>& trigger, LayerMask layerMask);

    /// Returns the registered volumes in the mask's layers, enabled or not, by ascending priority.
    /// The result is valid until the next call of any other member, or until one of them is moved
    /// or destroyed.
    std::span<const Volume* const> GetVolumes(LayerMask layerMask);

    /// Returns whether an enabled volume has an active T in its profile, whatever its weight and
    /// place. As in Unity only a mask that Update, Trace or GetVolumes was called with is known;
    /// returns false for any other.
    template <std::derived_from<VolumeComponent> T>
    bool IsComponentActiveInMask(LayerMask layerMask) const
    {
        return IsComponentActiveInMask(typeid(T), layerMask);
    }

private:
    /// A volume and its last known state, to notice changes.
    struct Registration
    {
        std::shared_ptr<const detail::VolumePlace*> address;
        const Volume* volume; ///< the address that FollowMoves saw last
        int layer;
        float priority;
    };

    /// The volumes of one mask, kept sorted between updates.
    struct SortedList
    {
        LayerMask mask;
        std::vector<const Volume*> volumes;
        bool isDirty;
    };

    template <typename Visitor>
    void ForEachDefaultProfile(Visitor&& visit) const;
    void ResetToDefaults(VolumeStack& stack) const;
    bool IsComponentActiveInMask(const std::type_info& type, LayerMask layerMask) const;
    std::vector<Registration>::iterator FindRegistration(const Volume* volume);
    void Fill(SortedList& list) const;
    /// Updates the registrations of volumes that were moved or destroyed.
    void FollowMoves();
    void NoticeChanges();
    void AddToLists(const Registration& registration);
    void RemoveFromLists(const Registration& registration);
    void MarkDirty(int layer);

    const VolumeComponentRegistry& m_Registry;
    std::shared_ptr<const VolumeProfile> m_GlobalDefaults;
    std::shared_ptr<const VolumeProfile> m_QualityDefaults;
    std::vector<std::shared_ptr<const VolumeProfile>> m_CustomDefaults;
    std::shared_ptr<std::uint64_t> m_DefaultsChanges = std::make_shared<std::uint64_t>(0);
    std::vector<Registration> m_Registrations; ///< in the order of registration
    std::vector<SortedList> m_Lists;           ///< one per mask asked for so far
};

} // namespace limn

#pragma once

#include "unity/UnityReader.h"

#include <limn/core/Scene.h>
#include <unordered_map>

namespace limn
{

/// A GameObject of an expanded scene with its components and children.
struct UnityGameObject
{
    const UnityInstance* object = nullptr;
    const UnityInstance* transform = nullptr;
    std::vector<const UnityInstance*> components; ///< in the order of the files
    std::vector<UnityGameObject*> children;       ///< in the order of the hierarchy
    UnityGameObject* parent = nullptr;
    std::string path;            ///< "Props/Workbench/Jigsaw"
    bool isActive = true;        ///< true if it and all of its ancestors are active
    GameObject* drawn = nullptr; ///< the object in the scene, once it is made

    const UnityInstance* Find(UnityClass classID) const;
    /// Returns the component of a script, by the script's guid.
    const UnityInstance* FindScript(std::string_view guid) const;
};

/// The GameObjects of a scene, parents before their children.
class UnityHierarchy
{
public:
    UnityHierarchy(const UnityExpansion& expansion, UnityNotes& notes);

    const std::vector<UnityGameObject*>& objects() const { return m_Order; }
    /// Returns the GameObject that has a component or that is `object` itself, or null if there is
    /// none.
    UnityGameObject* Find(const UnityInstance* object) const;

private:
    void Collect(const UnityExpansion& expansion, UnityNotes& notes);
    void Connect(UnityNotes& notes);
    void Sort(UnityNotes& notes);
    void NoteLost(UnityNotes& notes) const;

    std::deque<UnityGameObject> m_Objects;
    std::unordered_map<const UnityInstance*, UnityGameObject*> m_ByInstance;
    std::vector<UnityGameObject*> m_Roots;
    std::vector<UnityGameObject*> m_Order;
};

} // namespace limn

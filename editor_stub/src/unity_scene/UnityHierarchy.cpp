#include "unity_scene/UnityHierarchy.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Deeper ones cost more time than they are worth: a chain's matrices are multiplied for each
/// object.
constexpr std::size_t k_DeepestObject = 1000;

} // namespace

const UnityInstance* UnityGameObject::Find(UnityClass classID) const
{
    const auto found = std::ranges::find(components, classID, &UnityInstance::classID);
    return found == components.end() ? nullptr : *found;
}

const UnityInstance* UnityGameObject::FindScript(std::string_view guid) const
{
    const auto found =
        std::ranges::find_if(components,
                             [guid](const UnityInstance* component)
                             {
                                 return component->classID == UnityClass::MonoBehaviour &&
                                        component->fields["m_Script"]["guid"].text() == guid;
                             });
    return found == components.end() ? nullptr : *found;
}

UnityHierarchy::UnityHierarchy(const UnityExpansion& expansion, UnityNotes& notes)
{
    Collect(expansion, notes);
    Connect(notes);
    Sort(notes);
    NoteLost(notes);
}

void UnityHierarchy::Collect(const UnityExpansion& expansion, UnityNotes& notes)
{
    for (const UnityInstance* object : expansion.objects())
    {
        if (object->classID == UnityClass::GameObject)
        {
            UnityGameObject& added = m_Objects.emplace_back();
            added.object = object;
            m_ByInstance[object] = &added;
        }
    }
    for (const UnityInstance* object : expansion.objects())
    {
        if (object->classID == UnityClass::GameObject || !object->fields["m_GameObject"])
        {
            continue;
        }
        const UnityReader reader(*object, NameOf(object->classID), notes);
        UnityGameObject* owner = Find(reader.Reference("m_GameObject").object);
        if (owner == nullptr)
        {
            continue;
        }
        owner->components.push_back(object);
        owner->transform = object->isTransform() ? object : owner->transform;
        m_ByInstance[object] = owner;
    }
}

void UnityHierarchy::Connect(UnityNotes& notes)
{
    for (UnityGameObject& object : m_Objects)
    {
        if (object.transform == nullptr)
        {
            continue;
        }
        const UnityReader reader(*object.transform, "Transform", notes);
        object.parent = Find(reader.Reference("m_Father").object);
        (object.parent != nullptr ? object.parent->children : m_Roots).push_back(&object);
    }
}

/// Puts children in the order that their parent's list has, then by m_RootOrder.
void UnityHierarchy::Sort(UnityNotes& notes)
{
    const auto sort = [&](std::vector<UnityGameObject*>& objects, const UnityInstance* parent)
    {
        std::unordered_map<const UnityInstance*, int> places;
        if (parent != nullptr)
        {
            const UnityReader reader(*parent, "Transform", notes);
            int place = 0;
            for (const UnityNode child : parent->fields["m_Children"])
            {
                places[parent->scope->Find(ReadUnityReference(child).fileID)] = place++;
            }
        }
        const auto placeOf = [&](const UnityGameObject* object)
        {
            const auto listed = places.find(object->transform);
            int order = 1'000'000;
            UnityReader(*object->transform, "Transform", notes).Read("m_RootOrder", order);
            return listed != places.end() ? listed->second : order;
        };
        std::ranges::stable_sort(objects, {}, placeOf);
    };
    sort(m_Roots, nullptr);
    std::vector<std::pair<UnityGameObject*, std::size_t>> open;
    for (auto root = m_Roots.rbegin(); root != m_Roots.rend(); ++root)
    {
        open.emplace_back(*root, 0);
    }
    while (!open.empty())
    {
        const auto [object, depth] = open.back();
        open.pop_back();
        std::string name;
        bool isActive = true;
        const UnityReader reader(*object->object, "GameObject", notes);
        reader.Read("m_Name", name);
        reader.Read("m_IsActive", isActive);
        object->path = object->parent != nullptr ? object->parent->path + "/" + name : name;
        object->isActive = isActive && (object->parent == nullptr || object->parent->isActive);
        m_Order.push_back(object);
        if (depth == k_DeepestObject)
        {
            notes.Add(object->object->scope->file->name(), object->object->line,
                      object->path.substr(0, 80) + "…: its children are left out; objects lie at "
                                                   "most 1000 levels deep");
            continue;
        }
        sort(object->children, object->transform);
        for (auto child = object->children.rbegin(); child != object->children.rend(); ++child)
        {
            open.emplace_back(*child, depth + 1);
        }
    }
}

/// Adds a note if there are objects that no root leads to.
void UnityHierarchy::NoteLost(UnityNotes& notes) const
{
    const std::size_t lost = m_Objects.size() - m_Order.size();
    if (lost > 0)
    {
        const UnityInstance& first = *m_Objects.front().object;
        notes.Add(first.scope->file->name(), 0,
                  std::to_string(lost) + " objects are left out: they have no Transform, or their "
                                         "parents form a circle");
    }
}

UnityGameObject* UnityHierarchy::Find(const UnityInstance* object) const
{
    const auto found = m_ByInstance.find(object);
    return found == m_ByInstance.end() ? nullptr : found->second;
}

} // namespace limn

#include <algorithm>
#include <limn/core/Camera.h>
#include <limn/editor_stub/SelectController.h>
#include <unordered_map>
#include <unordered_set>

namespace limn
{

namespace
{

using ObjectsOfTransforms = std::unordered_map<const Transform*, GameObject*>;

/// A transform's parent may be no object's.
ObjectsOfTransforms FindObjects(const Scene& scene)
{
    ObjectsOfTransforms objects;
    for (const std::unique_ptr<GameObject>& object : scene.objects())
    {
        objects[&object->transform] = object.get();
    }
    return objects;
}

auto FindTarget(std::vector<Selected>& targets, const GameObject* object)
{
    return std::ranges::find_if(targets, [object](const Selected& target)
                                { return target.object == object; });
}

} // namespace

SelectController::SelectController(Scene& scene, SelectSettings settings)
    : m_Scene(scene), m_Settings(std::move(settings))
{
    AdoptMarked();
}

void SelectController::Click(GameObject* hit, bool isCtrl, double time)
{
    const auto target = FindTarget(m_Targets, hit);
    const bool isTarget = target != m_Targets.end();
    if (hit && isCtrl && isTarget)
    {
        m_Targets.erase(target);
    }
    else if (hit && isCtrl)
    {
        m_Targets.push_back({hit, time});
    }
    else if (hit)
    {
        m_Targets = {isTarget ? *target : Selected{hit, time}};
    }
    else
    {
        m_Targets.clear();
    }
    DrawOutline();
}

GameObject* SelectController::GetHitObj(const Camera& camera, int width, int height, int x, int y)
{
    const std::optional<RaycastHit> hit = Raycast(camera, width, height, x, y);
    const bool counts =
        hit && LayerMask::FromIndex(hit->gameObject->layer).Intersects(m_Settings.selectableLayers);
    return counts ? WholeOf(*hit->gameObject) : nullptr;
}

std::optional<RaycastHit> SelectController::Raycast(const Camera& camera, int width, int height,
                                                    int x, int y)
{
    const Ray ray = PixelToRay(camera, width, height, x, y);
    RaycastSettings settings = m_Settings.raycast;
    settings.layerMask = settings.layerMask & camera.cullingMask;
    settings.maxDistance = std::min(settings.maxDistance, DistanceToFarPlane(camera, ray));
    return m_Raycaster.Raycast(m_Scene, ray, settings);
}

void SelectController::Select(std::span<GameObject* const> objects, double time)
{
    std::vector<Selected> targets;
    for (GameObject* object : objects)
    {
        const auto before = FindTarget(m_Targets, object);
        if (FindTarget(targets, object) == targets.end())
        {
            targets.push_back(before == m_Targets.end() ? Selected{object, time} : *before);
        }
    }
    m_Targets = std::move(targets);
    DrawOutline();
}

GameObject* SelectController::WholeOf(GameObject& part) const
{
    if (m_Settings.unit == SelectUnit::Part)
    {
        return &part;
    }
    const ObjectsOfTransforms objects = FindObjects(m_Scene);
    GameObject* whole = &part;
    for (const Transform* above = part.transform.parent; above; above = above->parent)
    {
        const auto found = objects.find(above);
        whole = found == objects.end() ? whole : found->second;
    }
    return whole;
}

void SelectController::AdoptMarked()
{
    struct Renderers
    {
        int marked = 0;
        int all = 0;
        bool AreMarked() const { return marked > 0 && marked == all; }
    };
    std::unordered_map<const Transform*, Renderers> below; // with the object's own
    for (const std::unique_ptr<GameObject>& object : m_Scene.objects())
    {
        const Transform* place = object->renderer ? &object->transform : nullptr;
        for (; place; place = place->parent)
        {
            Renderers& renderers = below[place];
            ++renderers.all;
            renderers.marked +=
                object->renderer->renderingLayerMask.Intersects(m_Settings.renderingLayers);
        }
    }
    const ObjectsOfTransforms objects = FindObjects(m_Scene);
    for (const std::unique_ptr<GameObject>& object : m_Scene.objects())
    {
        bool isBelowMarked = false;
        for (const Transform* above = object->transform.parent; above; above = above->parent)
        {
            isBelowMarked = isBelowMarked || (objects.count(above) > 0 && below[above].AreMarked());
        }
        if (!isBelowMarked && below[&object->transform].AreMarked())
        {
            m_Targets.push_back({object.get(), 0.0});
        }
    }
}

void SelectController::DrawOutline()
{
    std::unordered_set<const Transform*> targets;
    for (const Selected& target : m_Targets)
    {
        targets.insert(&target.object->transform);
    }
    const RenderingLayerMask layers = m_Settings.renderingLayers;
    for (const std::unique_ptr<GameObject>& object : m_Scene.objects())
    {
        if (!object->renderer)
        {
            continue;
        }
        bool isSelected = false;
        for (const Transform* place = &object->transform; place && !isSelected;
             place = place->parent)
        {
            isSelected = targets.count(place) > 0;
        }
        RenderingLayerMask& mask = object->renderer->renderingLayerMask;
        mask = isSelected ? mask | layers : mask & ~layers;
    }
}

} // namespace limn

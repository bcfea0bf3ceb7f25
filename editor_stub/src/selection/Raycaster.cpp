#include "selection/MeshTree.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <stdexcept>

namespace limn
{

/// The trees of meshes that live.
struct Raycaster::Meshes
{
    struct Entry
    {
        std::weak_ptr<const Mesh> mesh;
        std::unique_ptr<MeshTree> tree;
    };

    Meshes() : device(rtcNewDevice(nullptr))
    {
        if (!device)
        {
            throw std::runtime_error("Embree cannot be used: error " +
                                     std::to_string(rtcGetDeviceError(nullptr)));
        }
    }
    ~Meshes()
    {
        trees.clear();
        rtcReleaseDevice(device);
    }
    Meshes(const Meshes&) = delete;
    Meshes& operator=(const Meshes&) = delete;

    const MeshTree& TreeOf(const std::shared_ptr<const Mesh>& mesh)
    {
        const auto found = trees.find(mesh->id());
        if (found != trees.end())
        {
            return *found->second.tree;
        }
        std::erase_if(trees, [](const auto& entry) { return entry.second.mesh.expired(); });
        Entry& entry = trees[mesh->id()];
        entry = {mesh, std::make_unique<MeshTree>(device, *mesh)};
        return *entry.tree;
    }

    RTCDevice device;
    std::map<std::uint64_t, Entry> trees; ///< by mesh id
};

namespace
{

/// Sub-mesh i is drawn with material i, the last one also with all further ones.
std::vector<bool> DrawnSubMeshes(const MeshRenderer& renderer, const RenderQueueRange& queues)
{
    std::vector<bool> drawn(static_cast<std::size_t>(renderer.mesh->subMeshCount()));
    std::size_t subMesh = 0;
    for (const std::shared_ptr<const Material>& material : renderer.sharedMaterials)
    {
        const bool isDrawn = material && queues.Contains(material->renderQueue());
        drawn[subMesh] = drawn[subMesh] || isDrawn;
        subMesh = std::min(subMesh + 1, drawn.size() - 1);
    }
    return drawn;
}

bool CanBeHit(const GameObject& object, const RaycastSettings& settings)
{
    return object.activeSelf && object.renderer && object.renderer->enabled &&
           object.renderer->mesh &&
           LayerMask::FromIndex(object.layer).Intersects(settings.layerMask);
}

/// Returns whether the ray meets the sphere around the object's mesh, or nearly so.
bool IsNear(const Mesh& mesh, const glm::dmat3& axes, const glm::dvec3& position, const Ray& ray,
            double maxDistance)
{
    const glm::dvec3 center = position + axes * glm::dvec3(mesh.bounds().center) - ray.origin;
    const double scale = std::sqrt(glm::dot(axes[0], axes[0]) + glm::dot(axes[1], axes[1]) +
                                   glm::dot(axes[2], axes[2]));
    const double radius = static_cast<double>(mesh.boundingRadius()) * scale * (1.0 + 1e-5);
    const double along = glm::dot(center, ray.direction);
    const glm::dvec3 aside = center - along * ray.direction;
    return along > -radius && along - radius <= maxDistance &&
           glm::dot(aside, aside) <= radius * radius;
}

/// Flat objects have no space of their own that a ray could be taken to; there, triangle by
/// triangle in the world.
std::optional<MeshHit> RaycastFlat(const Mesh& mesh, const glm::dmat3& axes, const MeshRay& ray)
{
    std::optional<MeshHit> nearest;
    for (int subMesh = 0; subMesh < mesh.subMeshCount(); ++subMesh)
    {
        const SubMesh& run = mesh.subMesh(subMesh);
        const std::uint32_t count =
            ray.subMeshes[static_cast<std::size_t>(subMesh)] ? run.indexCount : 0;
        for (std::uint32_t i = run.indexStart; i < run.indexStart + count; i += 3)
        {
            Triangle triangle = TriangleOf(mesh, i);
            triangle = {axes * triangle.a, axes * triangle.b, axes * triangle.c};
            const glm::dvec3 ab = triangle.b - triangle.a;
            const glm::dvec3 ac = triangle.c - triangle.a;
            const glm::dvec3 p = glm::cross(ray.direction, ac);
            const double determinant = glm::dot(ab, p);
            const glm::dvec3 toOrigin = ray.origin - triangle.a;
            const glm::dvec3 q = glm::cross(toOrigin, ab);
            const double u = glm::dot(toOrigin, p) / determinant;
            const double v = glm::dot(ray.direction, q) / determinant;
            const double t = glm::dot(ac, q) / determinant;
            // With a determinant of 0 no comparison holds.
            if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 && t <= ray.maxT &&
                (!nearest || t < nearest->t) && MeetsFace(triangle, ray.direction, ray.faces))
            {
                nearest = MeshHit{subMesh, i, t};
            }
        }
    }
    return nearest;
}

bool IsFlat(const glm::dmat3& axes)
{
    const double lengths = glm::length(axes[0]) * glm::length(axes[1]) * glm::length(axes[2]);
    return std::abs(glm::determinant(axes)) <= 1e-12 * lengths || !(lengths > 0.0);
}

void Expect(const Ray& ray)
{
    const double length = glm::length(ray.direction);
    const double place = glm::dot(ray.origin, ray.origin);
    if (!std::isfinite(place) || !(std::abs(length - 1.0) < 1e-6))
    {
        throw ContractError("a ray's origin must be finite and its direction of unit length, not " +
                            std::to_string(length));
    }
}

} // namespace

Raycaster::Raycaster() : m_Meshes(std::make_unique<Meshes>()) {}
Raycaster::~Raycaster() = default;

// One ray after another, and anything may have moved between two: a tree over the objects would
// take as long to build as asking each.
std::optional<RaycastHit> Raycaster::Raycast(const Scene& scene, const Ray& ray,
                                             const RaycastSettings& settings)
{
    Expect(ray);
    std::optional<RaycastHit> nearest;
    double maxDistance = settings.maxDistance;
    for (const std::unique_ptr<GameObject>& object : scene.objects())
    {
        if (!CanBeHit(*object, settings))
        {
            continue;
        }
        const std::shared_ptr<const Mesh>& mesh = object->renderer->mesh;
        const glm::dmat4 world = object->transform.worldMatrix();
        const glm::dmat3 axes(world);
        const glm::dvec3 position(world[3]);
        if (!IsNear(*mesh, axes, position, ray, maxDistance))
        {
            continue;
        }
        MeshRay local{ray.origin - position, ray.direction, maxDistance, settings.faces,
                      DrawnSubMeshes(*object->renderer, settings.renderQueueRange)};
        std::optional<MeshHit> hit;
        if (IsFlat(axes))
        {
            hit = RaycastFlat(*mesh, axes, local);
        }
        else
        {
            const glm::dmat3 toMesh = glm::inverse(axes);
            local.origin = toMesh * local.origin;
            local.direction = toMesh * local.direction;
            hit = m_Meshes->TreeOf(mesh).Raycast(*mesh, local);
        }
        const bool isNearer =
            hit && hit->t >= 0.0 && (nearest ? hit->t < maxDistance : hit->t <= maxDistance);
        if (isNearer)
        {
            maxDistance = hit->t;
            nearest = RaycastHit{object.get(), hit->subMesh, static_cast<int>(hit->firstIndex / 3),
                                 hit->t, ray.origin + hit->t * ray.direction};
        }
    }
    return nearest;
}

} // namespace limn

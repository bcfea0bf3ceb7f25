#include <algorithm>
#include <cmath>
#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limn/base/NumberText.h>
#include <limn/editor_stub/Raycast.h>
#include <map>
#include <new>
#include <stdexcept>

namespace limn
{

struct ReleaseEmbree
{
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using MeshTree = std::unique_ptr<RTCSceneTy, ReleaseEmbree>;

namespace
{

/// More than what floats round off near 1.
constexpr double k_Margin = 1e-5;

/// The place where a ray meets a mesh.
struct MeshHit
{
    int subMesh = 0;
    std::uint32_t firstIndex = 0; ///< the index in data().triangles at which the triangle begins
    double t = 0.0;               ///< the place is origin + t * direction
};

/// A ray in a mesh's own space, and the triangles that it can meet.
struct MeshRay
{
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0}; ///< any length but 0
    double maxT = 0.0;
    RaycastFaces faces = RaycastFaces::Front;
    std::vector<bool> subMeshes; ///< true for each sub-mesh that it can meet
};

/// The three corners of the triangle that begins at this index.
struct Triangle
{
    glm::dvec3 a, b, c;
};

Triangle TriangleOf(const Mesh& mesh, std::uint32_t firstIndex)
{
    const MeshData& data = mesh.data();
    const auto corner = [&data, firstIndex](std::uint32_t i)
    {
        return glm::dvec3(data.vertices[data.triangles[firstIndex + i]]);
    };
    return {corner(0), corner(1), corner(2)};
}

/// Returns whether a ray of this direction meets the triangle on one of the sides that `faces` has.
bool MeetsFace(const Triangle& triangle, const glm::dvec3& direction, RaycastFaces faces)
{
    // Clockwise triangles face the viewer; left-handed, the cross product then points at him. That
    // holds in the mesh's own space for mirrored objects as well.
    const double facing =
        glm::dot(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a), direction);
    return faces == RaycastFaces::Both ||
           (faces == RaycastFaces::Front ? facing < 0.0 : facing > 0.0);
}

/// The data that Embree passes to the filter.
struct Query
{
    RTCIntersectContext context; ///< first, since that is what Embree knows of it
    const Mesh* mesh = nullptr;
    const MeshRay* ray = nullptr;
};

std::uint32_t FirstIndex(const Mesh& mesh, unsigned subMesh, unsigned triangle)
{
    return mesh.subMesh(static_cast<int>(subMesh)).indexStart + 3 * triangle;
}

void Filter(const RTCFilterFunctionNArguments* args)
{
    const auto& query = *reinterpret_cast<const Query*>(args->context);
    const unsigned subMesh = RTCHitN_geomID(args->hit, args->N, 0);
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, 0);
    const bool counts =
        query.ray->subMeshes[subMesh] &&
        MeetsFace(TriangleOf(*query.mesh, FirstIndex(*query.mesh, subMesh, triangle)),
                  query.ray->direction, query.ray->faces);
    args->valid[0] = counts ? args->valid[0] : 0;
}

RTCGeometry MakeGeometry(RTCDevice device, const std::vector<glm::vec3>& vertices, const Mesh& mesh,
                         const SubMesh& subMesh)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* places = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(glm::vec3), vertices.size());
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(std::uint32_t), subMesh.indexCount / 3);
    if (places && indices)
    {
        std::copy(vertices.begin(), vertices.end(), static_cast<glm::vec3*>(places));
        std::copy_n(mesh.data().triangles.begin() + subMesh.indexStart, subMesh.indexCount,
                    static_cast<std::uint32_t*>(indices));
        rtcSetGeometryIntersectFilterFunction(geometry, &Filter);
        rtcCommitGeometry(geometry);
    }
    return geometry;
}

/// Returns the distance at which the ray meets the plane of the triangle. It is no nearer and no
/// farther than the corners, which matters where the ray grazes the triangle.
double ExactT(const Triangle& triangle, const MeshRay& ray)
{
    const auto along = [&ray](const glm::dvec3& corner)
    {
        return glm::dot(corner - ray.origin, ray.direction) /
               glm::dot(ray.direction, ray.direction);
    };
    const auto [nearest, farthest] =
        std::minmax({along(triangle.a), along(triangle.b), along(triangle.c)});
    const glm::dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const double t = glm::dot(normal, triangle.a - ray.origin) / glm::dot(normal, ray.direction);
    return std::isnan(t) ? nearest : std::clamp(t, nearest, farthest);
}

/// Returns a tree over the triangles of one mesh. Embree computes in float. To keep its numbers
/// near 0 and 1 wherever the vertices are, the tree has them in a sphere of radius 1, and the ray
/// starts there. The distance is computed in double from the mesh's own vertices.
/// @throws std::bad_alloc, std::runtime_error if Embree fails
MeshTree MakeTree(RTCDevice device, const Mesh& mesh)
{
    const glm::dvec3 center(mesh.bounds().center);
    const double radius = mesh.boundingRadius() > 0.0f ? mesh.boundingRadius() : 1.0;
    std::vector<glm::vec3> vertices(mesh.data().vertices.size());
    std::ranges::transform(mesh.data().vertices, vertices.begin(),
                           [&](const glm::vec3& vertex)
                           { return glm::vec3((glm::dvec3(vertex) - center) / radius); });
    MeshTree tree(rtcNewScene(device));
    rtcSetSceneFlags(tree.get(), RTC_SCENE_FLAG_ROBUST);
    for (int i = 0; i < mesh.subMeshCount(); ++i)
    {
        RTCGeometry geometry = MakeGeometry(device, vertices, mesh, mesh.subMesh(i));
        rtcAttachGeometryByID(tree.get(), geometry, static_cast<unsigned>(i));
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(tree.get());
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_OUT_OF_MEMORY)
    {
        throw std::bad_alloc();
    }
    if (error != RTC_ERROR_NONE)
    {
        throw std::runtime_error("mesh '" + mesh.name() + "': Embree fails with error " +
                                 std::to_string(error));
    }
    return tree;
}

/// Returns the nearest triangle of the tree's mesh that the ray meets.
std::optional<MeshHit> RaycastTree(RTCScene tree, const Mesh& mesh, const MeshRay& ray)
{
    const double radius = mesh.boundingRadius();
    if (!(radius > 0.0f))
    {
        return std::nullopt;
    }
    const glm::dvec3 origin = (ray.origin - glm::dvec3(mesh.bounds().center)) / radius;
    const double speed = glm::length(ray.direction) / radius; // of the unit sphere's radii a t
    const glm::dvec3 direction = glm::normalize(ray.direction);
    const double middle = -glm::dot(origin, direction);
    const double begin = std::max(0.0, middle - 1.0 - k_Margin);
    const double end = std::min(ray.maxT * speed, middle + 1.0) + k_Margin;
    const glm::dvec3 offset = origin + middle * direction;
    if (end < begin || glm::dot(offset, offset) > 1.0 + 3.0 * k_Margin)
    {
        return std::nullopt;
    }
    const glm::vec3 start(origin + begin * direction);
    const glm::vec3 along(direction);
    RTCRayHit query{};
    query.ray = {start.x,     start.y, start.z,
                 0.0f,        along.x, along.y,
                 along.z,     0.0f,    static_cast<float>(end - begin),
                 0xFFFFFFFFu, 0,       0};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    Query context{{}, &mesh, &ray};
    rtcInitIntersectContext(&context.context);
    rtcIntersect1(tree, &context.context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    {
        return std::nullopt;
    }
    MeshHit hit{static_cast<int>(query.hit.geomID),
                FirstIndex(mesh, query.hit.geomID, query.hit.primID), 0.0};
    hit.t = ExactT(TriangleOf(mesh, hit.firstIndex), ray);
    return hit;
}

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

Ray ScreenPointToRay(const Camera& camera, int width, int height, const glm::dvec2& point)
{
    if (width < 1 || height < 1 || !std::isfinite(point.x) || !std::isfinite(point.y))
    {
        throw ContractError("ScreenPointToRay: there is no ray through (" + NumberText(point.x) +
                            ", " + NumberText(point.y) + ") of a picture of " +
                            std::to_string(width) + "x" + std::to_string(height) + " pixels");
    }
    // The very matrix that the device draws with.
    const glm::dmat4 toView = glm::inverse(glm::dmat4(
        camera.gpuProjectionMatrix(static_cast<float>(width) / static_cast<float>(height))));
    const glm::dvec4 start =
        toView * glm::dvec4(2.0 * point / glm::dvec2(width, height) - 1.0, 1.0, 1.0);
    // The direction in which the point in view space moves while the depth falls.
    const glm::dvec4 fall = -toView[2];
    const glm::dvec3 along = glm::dvec3(fall) * start.w - glm::dvec3(start) * fall.w;
    // Not the rotation itself, whose quaternion is of unit length as far as floats are.
    const glm::dmat3 toWorld = glm::inverse(glm::dmat3(camera.viewMatrix()));
    const glm::dvec3 position(camera.transform.worldMatrix()[3]);
    return {position + toWorld * (glm::dvec3(start) / start.w), glm::normalize(toWorld * along)};
}

Ray PixelToRay(const Camera& camera, int width, int height, int x, int y)
{
    if (x < 0 || x >= width || y < 0 || y >= height)
    {
        throw ContractError("pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                            ") lies outside of a picture of " + std::to_string(width) + "x" +
                            std::to_string(height) + " pixels");
    }
    return ScreenPointToRay(camera, width, height, {x + 0.5, height - y - 0.5});
}

double DistanceToFarPlane(const Camera& camera, const Ray& ray)
{
    const glm::dmat4 toClip =
        glm::dmat4(camera.gpuProjectionMatrix(1.0f)) * camera.viewMatrix(); // any shape's depth
    const double depth = (toClip * glm::dvec4(ray.origin, 1.0)).z;
    const double fall = -(toClip * glm::dvec4(ray.direction, 0.0)).z;
    return fall > 0.0 ? depth / fall : std::numeric_limits<double>::infinity();
}

/// The trees of meshes that live.
struct Raycaster::Meshes
{
    struct Entry
    {
        std::weak_ptr<const Mesh> mesh;
        MeshTree tree;
    };

    Meshes() : device(rtcNewDevice(nullptr))
    {
        if (!device)
        {
            throw std::runtime_error("Embree cannot be used: error " +
                                     std::to_string(rtcGetDeviceError(nullptr)));
        }
    }

    RTCScene TreeOf(const std::shared_ptr<const Mesh>& mesh)
    {
        auto found = trees.find(mesh->id());
        if (found == trees.end())
        {
            std::erase_if(trees, [](const auto& entry) { return entry.second.mesh.expired(); });
            found = trees.emplace(mesh->id(), Entry{mesh, MakeTree(device.get(), *mesh)}).first;
        }
        return found->second.tree.get();
    }

    std::unique_ptr<RTCDeviceTy, ReleaseEmbree> device;
    std::map<std::uint64_t, Entry> trees; ///< by mesh id
};

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
            hit = RaycastTree(m_Meshes->TreeOf(mesh), *mesh, local);
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

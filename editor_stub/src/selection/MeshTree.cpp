#include "selection/MeshTree.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <new>
#include <stdexcept>

namespace limn
{

namespace
{

/// More than what floats round off near 1.
constexpr double k_Margin = 1e-5;

void ThrowIfFailed(RTCDevice device, const Mesh& mesh)
{
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

} // namespace

Triangle TriangleOf(const Mesh& mesh, std::uint32_t firstIndex)
{
    const MeshData& data = mesh.data();
    const auto corner = [&data, firstIndex](std::uint32_t i)
    {
        return glm::dvec3(data.vertices[data.triangles[firstIndex + i]]);
    };
    return {corner(0), corner(1), corner(2)};
}

bool MeetsFace(const Triangle& triangle, const glm::dvec3& direction, RaycastFaces faces)
{
    // Clockwise triangles face the viewer; left-handed, the cross product then points at him. That
    // holds in the mesh's own space for mirrored objects as well.
    const double facing =
        glm::dot(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a), direction);
    return faces == RaycastFaces::Both ||
           (faces == RaycastFaces::Front ? facing < 0.0 : facing > 0.0);
}

MeshTree::MeshTree(RTCDevice device, const Mesh& mesh)
{
    const glm::dvec3 center(mesh.bounds().center);
    const double radius = mesh.boundingRadius() > 0.0f ? mesh.boundingRadius() : 1.0;
    std::vector<glm::vec3> vertices(mesh.data().vertices.size());
    std::transform(mesh.data().vertices.begin(), mesh.data().vertices.end(), vertices.begin(),
                   [&](const glm::vec3& vertex)
                   { return glm::vec3((glm::dvec3(vertex) - center) / radius); });
    m_Scene = rtcNewScene(device);
    rtcSetSceneFlags(m_Scene, RTC_SCENE_FLAG_ROBUST);
    for (int i = 0; i < mesh.subMeshCount(); ++i)
    {
        RTCGeometry geometry = MakeGeometry(device, vertices, mesh, mesh.subMesh(i));
        rtcAttachGeometryByID(m_Scene, geometry, static_cast<unsigned>(i));
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(m_Scene);
    try
    {
        ThrowIfFailed(device, mesh);
    }
    catch (...)
    {
        rtcReleaseScene(m_Scene);
        throw;
    }
}

MeshTree::~MeshTree()
{
    rtcReleaseScene(m_Scene);
}

std::optional<MeshHit> MeshTree::Raycast(const Mesh& mesh, const MeshRay& ray) const
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
    RTCRayHit query{};
    query.ray = {start.x, start.y, start.z, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0xFFFFFFFFu, 0, 0};
    query.ray.dir_x = static_cast<float>(direction.x);
    query.ray.dir_y = static_cast<float>(direction.y);
    query.ray.dir_z = static_cast<float>(direction.z);
    query.ray.tfar = static_cast<float>(end - begin);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    Query context{{}, &mesh, &ray};
    rtcInitIntersectContext(&context.context);
    rtcIntersect1(m_Scene, &context.context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    {
        return std::nullopt;
    }
    MeshHit hit{static_cast<int>(query.hit.geomID),
                FirstIndex(mesh, query.hit.geomID, query.hit.primID), 0.0};
    hit.t = ExactT(TriangleOf(mesh, hit.firstIndex), ray);
    return hit;
}

} // namespace limn

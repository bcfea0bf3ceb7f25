#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <limn/core/Camera.h>
#include <limn/core/FilteringSettings.h>
#include <limn/core/LayerMask.h>
#include <limn/core/Scene.h>
#include <memory>
#include <optional>

namespace limn
{

/// Returns the ray along which the camera sees a point of its picture. It begins on the near plane.
/// @param width, height  the size of the picture, in pixels
/// @param point  the point in pixels, x to the right and y up from the bottom left corner; whole
///     numbers are corners of pixels
/// @throws ContractError if the picture has no pixel, the point is not finite, or as
///     Camera::gpuProjectionMatrix
/// Unity: Camera.ScreenPointToRay (2022.3).
Ray ScreenPointToRay(const Camera& camera, int width, int height, const glm::dvec2& point);

/// Returns the ray along which the camera sees the middle of a pixel.
/// @param x, y  the column and the row from the top left of the picture, as in image files
/// @throws ContractError if the pixel is outside of the picture, and as ScreenPointToRay
Ray PixelToRay(const Camera& camera, int width, int height, int x, int y);

/// Returns the distance, in metres from its origin, at which a ray of ScreenPointToRay leaves what
/// the camera draws. It is infinite where an oblique projection goes on for ever.
double DistanceToFarPlane(const Camera& camera, const Ray& ray);

/// The sides of triangles that a ray meets. Front is the side that Unity's mesh colliders have, and
/// that a material without `Cull` shows.
enum class RaycastFaces
{
    Front,
    Back,
    Both
};

/// The objects and the triangles that a ray can meet.
struct RaycastSettings
{
    /// The ray passes through objects of other layers.
    LayerMask layerMask = LayerMask::Everything();
    /// The ray passes through materials of other queues.
    RenderQueueRange renderQueueRange = RenderQueueRange::all;
    RaycastFaces faces = RaycastFaces::Front;
    double maxDistance = std::numeric_limits<double>::infinity(); ///< in metres
};

/// The place where a ray meets a triangle. Unity: UnityEngine.RaycastHit (2022.3).
struct RaycastHit
{
    GameObject* gameObject = nullptr; ///< never null
    int subMesh = 0;
    int triangleIndex = 0; ///< its first corner is data().triangles[3 * triangleIndex]
    double distance = 0.0; ///< from the ray's origin, in metres
    glm::dvec3 point{0.0}; ///< in world space
};

/// Finds where rays meet the triangles that a scene draws. A tree over the triangles of each mesh
/// is built when a ray first comes near one of its objects, and is kept while the mesh lives.
/// Objects may move, come and go between two rays.
/// Unity: Physics.Raycast, with what renderers draw in place of colliders.
class Raycaster
{
public:
    Raycaster();
    ~Raycaster();
    Raycaster(const Raycaster&) = delete;
    Raycaster& operator=(const Raycaster&) = delete;

    /// Returns the nearest triangle that an active object's enabled renderer draws with one of its
    /// materials. The result is exact to float rounding relative to the mesh's size, wherever in
    /// the world the mesh is and whatever its scale. Among equally near triangles the first
    /// object's is returned.
    /// @throws ContractError if the ray is not finite or its direction is not of unit length
    std::optional<RaycastHit> Raycast(const Scene& scene, const Ray& ray,
                                      const RaycastSettings& settings = {});

private:
    struct Meshes;
    std::unique_ptr<Meshes> m_Meshes;
};

} // namespace limn

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

/// What the camera sees at a point of its picture, from the near plane on.
/// @param width, height  of the picture, pixels
/// @param point  pixels, x to the right and y up from the bottom left corner; whole numbers are
///     corners of pixels
/// @throws ContractError if the picture has no pixel, the point is not finite, or as
///     Camera::gpuProjectionMatrix
/// Unity: Camera.ScreenPointToRay (2022.3).
Ray ScreenPointToRay(const Camera& camera, int width, int height, const glm::dvec2& point);

/// What the camera sees in the middle of a pixel.
/// @param x, y  column and row from the top left of the picture, as in image files
/// @throws ContractError outside of the picture, and as ScreenPointToRay
Ray PixelToRay(const Camera& camera, int width, int height, int x, int y);

/// How far from its origin a ray of ScreenPointToRay leaves what the camera draws, metres; infinite
/// where an oblique projection goes on for ever.
double DistanceToFarPlane(const Camera& camera, const Ray& ray);

/// Which sides of triangles a ray meets. Front is what Unity's mesh colliders have, and what a
/// material without `Cull` shows.
enum class RaycastFaces
{
    Front,
    Back,
    Both
};

/// What a ray meets.
struct RaycastSettings
{
    LayerMask layerMask = LayerMask::Everything(); ///< it passes through objects of other layers
    RenderQueueRange renderQueueRange = RenderQueueRange::all; ///< and through other materials
    RaycastFaces faces = RaycastFaces::Front;
    double maxDistance = std::numeric_limits<double>::infinity(); ///< metres
};

/// The place where a ray meets a triangle. Unity: UnityEngine.RaycastHit (2022.3).
struct RaycastHit
{
    GameObject* gameObject = nullptr; ///< never null
    int subMesh = 0;
    int triangleIndex = 0; ///< its first corner is data().triangles[3 * triangleIndex]
    double distance = 0.0; ///< from the ray's origin, metres
    glm::dvec3 point{0.0}; ///< world
};

/// Rays against the triangles that a scene draws. A tree over the triangles of each mesh is built
/// when a ray first comes near one of its objects, and kept while the mesh lives; objects may move,
/// come and go between two rays.
/// Unity: Physics.Raycast, with what renderers draw in place of colliders.
class Raycaster
{
public:
    Raycaster();
    ~Raycaster();
    Raycaster(const Raycaster&) = delete;
    Raycaster& operator=(const Raycaster&) = delete;

    /// The nearest triangle that an active object's enabled renderer draws with one of its
    /// materials. Exact to float rounding relative to the mesh's size, wherever in the world it is
    /// and whatever its scale; of equally near ones the first object's.
    /// @throws ContractError if the ray is not finite or its direction is not of unit length
    std::optional<RaycastHit> Raycast(const Scene& scene, const Ray& ray,
                                      const RaycastSettings& settings = {});

private:
    struct Meshes;
    std::unique_ptr<Meshes> m_Meshes;
};

} // namespace limn

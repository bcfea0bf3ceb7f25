#include <limn/base/Diagnostic.h>
#include <limn/core/Camera.h>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

namespace limn
{

namespace
{

float AspectOf(const glm::ivec2& size)
{
    if (size.x <= 0 || size.y <= 0)
    {
        throw ContractError("camera: the screen has " + std::to_string(size.x) + " x " +
                            std::to_string(size.y) + " pixels; both must be positive");
    }
    return static_cast<float>(size.x) / static_cast<float>(size.y);
}

/// Returns the point in view space at that distance in front of the camera.
glm::dvec3 ViewPoint(const Camera& camera, const glm::dvec2& viewport, double distance,
                     float aspect)
{
    const glm::dmat4 projection = camera.projectionMatrixFor(aspect);
    const double z = -distance;
    const double w = projection[2][3] * z + projection[3][3];
    // Two lines of `projection * (x, y, z, 1) = clip`, solved for x and y.
    const glm::dvec2 clip = (viewport * 2.0 - 1.0) * w;
    const glm::dvec2 rest = glm::dvec2(projection[2]) * z + glm::dvec2(projection[3]);
    const glm::dmat2 scale{glm::dvec2(projection[0]), glm::dvec2(projection[1])};
    return {glm::inverse(scale) * (clip - rest), z};
}

} // namespace

glm::vec3 Camera::WorldToViewportPoint(const glm::vec3& position, float aspect) const
{
    const glm::dvec4 view = viewMatrix() * glm::dvec4(position, 1.0);
    const glm::dvec4 clip = projectionMatrixFor(aspect) * view;
    return {glm::dvec2(clip) / clip.w * 0.5 + 0.5, -view.z};
}

glm::vec3 Camera::ViewportToWorldPoint(const glm::vec3& position, float aspect) const
{
    const glm::dvec3 view =
        ViewPoint(*this, glm::dvec2(position), static_cast<double>(position.z), aspect);
    return glm::vec3(glm::inverse(viewMatrix()) * glm::dvec4(view, 1.0));
}

Ray Camera::ViewportPointToRay(const glm::vec2& position, float aspect) const
{
    const auto nearest = static_cast<double>(nearClipPlane);
    const glm::dmat4 toWorld = glm::inverse(viewMatrix());
    const glm::dvec3 first(
        toWorld * glm::dvec4(ViewPoint(*this, glm::dvec2(position), nearest, aspect), 1.0));
    const glm::dvec3 second(
        toWorld * glm::dvec4(ViewPoint(*this, glm::dvec2(position), nearest + 1.0, aspect), 1.0));
    return {first, glm::normalize(second - first)};
}

glm::vec3 Camera::WorldToScreenPoint(const glm::vec3& position, const glm::ivec2& size) const
{
    return ViewportToScreenPoint(WorldToViewportPoint(position, AspectOf(size)), size);
}

glm::vec3 Camera::ScreenToWorldPoint(const glm::vec3& position, const glm::ivec2& size) const
{
    return ViewportToWorldPoint(ScreenToViewportPoint(position, size), AspectOf(size));
}

Ray Camera::ScreenPointToRay(const glm::vec2& position, const glm::ivec2& size) const
{
    return ViewportPointToRay(position / glm::vec2(size), AspectOf(size));
}

glm::vec3 Camera::ScreenToViewportPoint(const glm::vec3& position, const glm::ivec2& size)
{
    AspectOf(size);
    return {glm::vec2(position) / glm::vec2(size), position.z};
}

glm::vec3 Camera::ViewportToScreenPoint(const glm::vec3& position, const glm::ivec2& size)
{
    AspectOf(size);
    return {glm::vec2(position) * glm::vec2(size), position.z};
}

std::array<glm::vec3, 4> Camera::CalculateFrustumCorners(const glm::vec4& viewport, float z,
                                                         float aspect) const
{
    const auto corner = [&](float x, float y)
    {
        const glm::vec2 place =
            glm::vec2(viewport) + glm::vec2(viewport.z, viewport.w) * glm::vec2(x, y);
        const glm::dvec3 view = ViewPoint(*this, glm::dvec2(place), static_cast<double>(z), aspect);
        return glm::vec3(view.x, view.y, -view.z);
    };
    return {corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)};
}

} // namespace limn

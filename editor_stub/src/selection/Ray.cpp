#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <limn/base/NumberText.h>
#include <limn/core/Camera.h>
#include <limn/editor_stub/Raycast.h>

namespace limn
{

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

} // namespace limn

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limn/core/Camera.h>
#include <limn/editor_stub/Raycast.h>

namespace limn
{

Ray ScreenPointToRay(const Camera& camera, int width, int height, const glm::dvec2& point)
{
    if (width < 1 || height < 1 || !std::isfinite(point.x) || !std::isfinite(point.y))
    {
        throw ContractError("a ray through (" + std::to_string(point.x) + ", " +
                            std::to_string(point.y) + ") of a picture of " + std::to_string(width) +
                            "x" + std::to_string(height) + " pixels");
    }
    // The very matrix that the device draws with.
    const glm::mat4 projection =
        camera.gpuProjectionMatrix(static_cast<float>(width) / static_cast<float>(height));
    const glm::dvec2 inClip = 2.0 * point / glm::dvec2(width, height) - 1.0;
    const glm::dvec2 across =
        inClip / glm::dvec2(static_cast<double>(projection[0][0]), projection[1][1]);
    const double near = static_cast<double>(camera.nearClipPlane);
    // Not the rotation itself, whose quaternion is of unit length as far as floats are.
    const glm::dmat3 toWorld = glm::inverse(glm::dmat3(camera.viewMatrix()));
    const glm::dvec3 position(camera.transform.worldMatrix()[3]);
    const glm::dvec3 slope =
        camera.orthographic ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(across, -1.0);
    const glm::dvec3 start = camera.orthographic ? glm::dvec3(across, -near) : slope * near;
    return {position + toWorld * start, glm::normalize(toWorld * slope)};
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
    const double depth =
        static_cast<double>(camera.farClipPlane) - static_cast<double>(camera.nearClipPlane);
    return -depth / (glm::dmat3(camera.viewMatrix()) * ray.direction).z;
}

} // namespace limn

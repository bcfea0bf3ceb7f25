#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <limn/base/Diagnostic.h>
#include <limn/base/NumberText.h>
#include <limn/core/Camera.h>
#include <limn/core/TargetOrientation.h>
#include <string>

namespace limn
{

namespace
{

void Expect(bool condition, const char* field, double value, const char* range)
{
    if (!condition || !std::isfinite(value))
    {
        throw ContractError("camera: " + std::string(field) + " is " + NumberText(value) +
                            "; it must be " + range);
    }
}

/// Between z from -w to w (OpenGL) and from w to 0 (reversed).
/// @param scale  2 from reversed to OpenGL, 1/2 back
glm::dmat4 TurnDepth(const glm::dmat4& projection, double scale)
{
    const glm::dvec4 w = glm::row(projection, 3);
    const glm::dvec4 z = glm::row(projection, 2);
    return glm::row(projection, 2, scale > 1.0 ? w - scale * z : scale * (w - z));
}

/// Returns the camera's own projection matrix after checking it.
glm::dmat4 CheckedProjection(const Camera& camera)
{
    const glm::dmat4 projection = TurnDepth(*camera.projectionMatrix, 0.5);
    for (int column = 0; column < 4; ++column)
    {
        for (int row = 0; row < 4; ++row)
        {
            const double value = (*camera.projectionMatrix)[column][row];
            if (!(std::abs(value) <= std::numeric_limits<float>::max()))
            {
                throw ContractError("camera: projectionMatrix has " + NumberText(value) +
                                    " in row " + std::to_string(row) + ", column " +
                                    std::to_string(column) + "; it must be a finite float");
            }
        }
    }
    const glm::dvec4 last = camera.orthographic ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(0, 0, -1, 0);
    if (glm::row(projection, 3) != last)
    {
        throw ContractError("camera: projectionMatrix must have the last row " +
                            std::string(camera.orthographic ? "(0, 0, 0, 1)" : "(0, 0, -1, 0)") +
                            ", as the camera has " +
                            (camera.orthographic ? "no perspective" : "perspective"));
    }
    if (!(std::abs(glm::determinant(glm::dmat4(glm::mat4(projection)))) > 0.0))
    {
        throw ContractError("camera: projectionMatrix is singular in float precision: it takes "
                            "away a dimension");
    }
    return projection;
}

glm::dmat4 OrthographicProjection(const Camera& camera, double aspect)
{
    const double n = camera.nearClipPlane;
    const double f = camera.farClipPlane;
    Expect(camera.orthographicSize > 0.0f, "orthographicSize", camera.orthographicSize,
           "greater than 0");
    glm::dmat4 projection(0.0);
    projection[0][0] = 1.0 / (static_cast<double>(camera.orthographicSize) * aspect);
    projection[1][1] = 1.0 / static_cast<double>(camera.orthographicSize);
    projection[2][2] = 1.0 / (f - n);
    projection[3][2] = f / (f - n);
    projection[3][3] = 1.0;
    return projection;
}

glm::dmat4 PerspectiveProjection(const Camera& camera, double aspect)
{
    const double n = camera.nearClipPlane;
    const double f = camera.farClipPlane;
    Expect(camera.fieldOfView > 0.0f && camera.fieldOfView < 180.0f, "fieldOfView",
           camera.fieldOfView, "between 0 and 180 degrees");
    const double cotangent =
        1.0 / std::tan(glm::radians(static_cast<double>(camera.fieldOfView)) * 0.5);
    glm::dmat4 projection(0.0);
    projection[0][0] = cotangent / aspect;
    projection[1][1] = cotangent;
    projection[2][2] = n / (f - n);
    projection[2][3] = -1.0;
    projection[3][2] = f * n / (f - n);
    return projection;
}

/// z from w at the near plane to 0 at the far one.
glm::dmat4 ReversedProjection(const Camera& camera, float aspect)
{
    const double n = camera.nearClipPlane;
    const double f = camera.farClipPlane;
    Expect(aspect > 0.0f, "aspect", aspect, "greater than 0");
    Expect(camera.orthographic || n > 0.0, "nearClipPlane", n,
           camera.orthographic ? "finite" : "greater than 0");
    Expect(f > n, "farClipPlane", f, "greater than nearClipPlane");
    if (camera.projectionMatrix)
    {
        return CheckedProjection(camera);
    }
    return camera.orthographic ? OrthographicProjection(camera, aspect)
                               : PerspectiveProjection(camera, aspect);
}

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

glm::mat4 GpuProjection(const glm::dmat4& projection, bool usesReversedZBuffer,
                        bool renderIntoTexture)
{
    const glm::dmat4 reversed = TurnDepth(projection, 0.5);
    const glm::mat4 upright(usesReversedZBuffer ? reversed : WithTurnedDepth(reversed));
    return renderIntoTexture ? WithFlippedY(upright) : upright;
}

glm::dmat4 Camera::viewMatrix() const
{
    // Rotation and position only, as in Unity: a camera's scale does not matter.
    const glm::dvec3 position(transform.worldMatrix()[3]);
    const glm::dmat3 axes = glm::mat3_cast(transform.worldRotation());
    const glm::dmat3 turn = glm::transpose(glm::dmat3(axes[0], axes[1], -axes[2]));
    glm::dmat4 view(turn);
    view[3] = glm::dvec4(-(turn * position), 1.0);
    return view;
}

glm::mat4 Camera::cameraToWorldMatrix() const
{
    return glm::mat4(glm::inverse(viewMatrix()));
}

glm::dvec3 Camera::renderOrigin() const
{
    constexpr double k_Near = 1024.0;
    constexpr double k_Step = 8.0;
    const glm::dvec3 position(transform.worldMatrix()[3]);
    return glm::all(glm::lessThanEqual(glm::abs(position), glm::dvec3(k_Near)))
               ? glm::dvec3(0.0)
               : glm::round(position / k_Step) * k_Step;
}

glm::mat4 Camera::gpuProjectionMatrix(float aspect, bool usesReversedZBuffer) const
{
    const glm::dmat4 reversed = ReversedProjection(*this, aspect);
    return glm::mat4(usesReversedZBuffer ? reversed : WithTurnedDepth(reversed));
}

glm::dmat4 Camera::projectionMatrixFor(float aspect) const
{
    return TurnDepth(ReversedProjection(*this, aspect), 2.0);
}

glm::dmat4 Camera::CalculateObliqueMatrix(const glm::dvec4& clipPlane, float aspect) const
{
    glm::dmat4 projection = projectionMatrixFor(aspect);
    // The corner of the frustum that is farthest on the plane's kept side stays on the far plane.
    const glm::dmat4 toView = glm::inverse(projection);
    const glm::dvec4 inClip = glm::transpose(toView) * clipPlane;
    const glm::dvec4 corner =
        toView * glm::dvec4(glm::sign(inClip.x), glm::sign(inClip.y), 1.0, 1.0);
    const glm::dvec4 last = glm::row(projection, 3);
    const double unit = 2.0 * glm::dot(last, corner) / glm::dot(clipPlane, corner);
    const bool isBehind = orthographic || !(clipPlane.w > 0.0);
    if (!isBehind || !(unit > 0.0) || !std::isfinite(unit))
    {
        throw ContractError("camera: the oblique near plane has the camera on its visible side, or "
                            "cuts everything away");
    }
    projection = glm::row(projection, 2, unit * clipPlane - last);
    return projection;
}

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

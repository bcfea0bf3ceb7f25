#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <limn/base/Diagnostic.h>
#include <limn/base/NumberText.h>
#include <limn/core/Camera.h>
#include <limn/core/TargetOrientation.h>

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
    if (camera.orthographic)
    {
        Expect(std::isfinite(n), "nearClipPlane", n, "finite");
    }
    else
    {
        Expect(n > 0.0, "nearClipPlane", n, "greater than 0");
    }
    Expect(f > n, "farClipPlane", f, "greater than nearClipPlane");
    if (camera.projectionMatrix)
    {
        return CheckedProjection(camera);
    }
    return camera.orthographic ? OrthographicProjection(camera, aspect)
                               : PerspectiveProjection(camera, aspect);
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

glm::mat4 Camera::worldToCameraMatrix() const
{
    return glm::mat4(viewMatrix());
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

} // namespace limn

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vector_relational.hpp>
#include <limn/core/Camera.h>
#include <limn/shaderlab/Diagnostic.h>

namespace limn
{

namespace
{

void Expect(bool condition, const char* field, double value, const char* range)
{
    if (!condition || !std::isfinite(value))
    {
        throw ContractError("camera: " + std::string(field) + " is " + std::to_string(value) +
                            ", it must be " + range);
    }
}

} // namespace

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
    const double n = nearClipPlane;
    const double f = farClipPlane;
    Expect(aspect > 0.0f, "aspect", aspect, "greater than 0");
    if (orthographic)
    {
        Expect(std::isfinite(n), "nearClipPlane", n, "finite");
    }
    else
    {
        Expect(n > 0.0, "nearClipPlane", n, "greater than 0");
    }
    Expect(f > n, "farClipPlane", f, "greater than nearClipPlane");
    const auto inDirection = [&](const glm::dmat4& reversed)
    {
        return glm::mat4(usesReversedZBuffer ? reversed : WithTurnedDepth(reversed));
    };
    glm::dmat4 projection(0.0);
    if (orthographic)
    {
        Expect(orthographicSize > 0.0f, "orthographicSize", orthographicSize, "greater than 0");
        projection[0][0] = 1.0 / (static_cast<double>(orthographicSize) * aspect);
        projection[1][1] = 1.0 / static_cast<double>(orthographicSize);
        projection[2][2] = 1.0 / (f - n);
        projection[3][2] = f / (f - n);
        projection[3][3] = 1.0;
        return inDirection(projection);
    }
    Expect(fieldOfView > 0.0f && fieldOfView < 180.0f, "fieldOfView", fieldOfView,
           "between 0 and 180 degrees");
    const double cotangent = 1.0 / std::tan(glm::radians(static_cast<double>(fieldOfView)) * 0.5);
    projection[0][0] = cotangent / aspect;
    projection[1][1] = cotangent;
    projection[2][2] = n / (f - n);
    projection[2][3] = -1.0;
    projection[3][2] = f * n / (f - n);
    return inDirection(projection);
}

} // namespace limn

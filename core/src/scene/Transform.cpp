#include <glm/gtc/matrix_transform.hpp>
#include <limn/core/Transform.h>
#include <limn/shaderlab/Diagnostic.h>

namespace limn
{

glm::quat EulerToRotation(const glm::vec3& degrees)
{
    const glm::vec3 r = glm::radians(degrees);
    const glm::quat x = glm::angleAxis(r.x, glm::vec3(1, 0, 0));
    const glm::quat y = glm::angleAxis(r.y, glm::vec3(0, 1, 0));
    const glm::quat z = glm::angleAxis(r.z, glm::vec3(0, 0, 1));
    return y * x * z;
}

glm::quat LookRotation(const glm::vec3& forward, const glm::vec3& up)
{
    const float length = glm::length(forward);
    if (!(length > 0.0f))
    {
        throw ContractError("LookRotation: the forward direction is zero");
    }
    const glm::vec3 z = forward / length;
    glm::vec3 x = glm::cross(up, z);
    if (!(glm::length(x) > 1e-6f * glm::length(up)))
    {
        x = glm::cross(std::abs(z.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -z.y), z);
    }
    x = glm::normalize(x);
    return glm::quat_cast(glm::mat3(x, glm::cross(z, x), z));
}

glm::mat4 Transform::localToParentMatrix() const
{
    return glm::scale(
        glm::translate(glm::mat4(1.0f), localPosition) * glm::mat4_cast(localRotation), localScale);
}

glm::mat4 Transform::localToWorldMatrix() const
{
    return parent != nullptr ? parent->localToWorldMatrix() * localToParentMatrix()
                             : localToParentMatrix();
}

glm::vec3 Transform::position() const
{
    return glm::vec3(localToWorldMatrix()[3]);
}

glm::quat Transform::rotation() const
{
    return parent != nullptr ? parent->rotation() * localRotation : localRotation;
}

glm::vec3 Transform::forward() const
{
    return rotation() * glm::vec3(0, 0, 1);
}

} // namespace limn

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <limn/core/Transform.h>
#include <limn/shaderlab/Diagnostic.h>
#include <vector>

namespace limn
{

namespace
{

/// From the one without a parent down to `transform` itself: rounded in this order, a world matrix
/// is the parent's world matrix times its own, whoever asks.
/// @throws ContractError if the parents form a circle
std::vector<const Transform*> FromTheRoot(const Transform& transform)
{
    std::vector<const Transform*> chain;
    // Floyd: who goes half as fast is met again in a circle only.
    const Transform* slow = &transform;
    for (const Transform* t = &transform; t != nullptr; t = t->parent)
    {
        if (t == slow && !chain.empty())
        {
            throw ContractError("transform: it is among its own parents, or they go round in a "
                                "circle; a parent must lead to one without a parent");
        }
        slow = chain.size() % 2 == 1 ? slow->parent : slow;
        chain.push_back(t);
    }
    std::reverse(chain.begin(), chain.end());
    return chain;
}

} // namespace

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
    if (parent == nullptr)
    {
        return localToParentMatrix();
    }
    const std::vector<const Transform*> chain = FromTheRoot(*this);
    glm::mat4 matrix = chain.front()->localToParentMatrix();
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
        matrix = matrix * chain[i]->localToParentMatrix();
    }
    return matrix;
}

glm::vec3 Transform::position() const
{
    return glm::vec3(localToWorldMatrix()[3]);
}

glm::quat Transform::rotation() const
{
    if (parent == nullptr)
    {
        return localRotation;
    }
    const std::vector<const Transform*> chain = FromTheRoot(*this);
    glm::quat turned = chain.front()->localRotation;
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
        turned = turned * chain[i]->localRotation;
    }
    return turned;
}

glm::vec3 Transform::forward() const
{
    return rotation() * glm::vec3(0, 0, 1);
}

} // namespace limn

#include "scene/WorldMatrices.h"

#include <cmath>
#include <limn/base/Diagnostic.h>
#include <limn/core/Transform.h>

namespace limn
{

namespace
{

/// Follows a chain of parents and meets it again if it is a circle. Floyd: who goes half as fast is
/// met in a circle only.
class CircleGuard
{
public:
    explicit CircleGuard(const Transform& first) : m_Slow(&first) {}

    /// @param t  the next parent
    /// @throws ContractError if the parents form a circle
    void Pass(const Transform* t)
    {
        if (t == m_Slow)
        {
            throw ContractError("transform: its parents form a circle; the chain of parents must "
                                "end at a transform without a parent");
        }
        m_Slow = m_Odd ? m_Slow->parent : m_Slow;
        m_Odd = !m_Odd;
    }

private:
    const Transform* m_Slow;
    bool m_Odd = false;
};

} // namespace

glm::dmat4 LocalMatrix(const Transform& transform)
{
    glm::dmat4 matrix(glm::mat3_cast(glm::dquat(transform.localRotation)));
    for (int axis = 0; axis < 3; ++axis)
    {
        matrix[axis] *= static_cast<double>(transform.localScale[axis]);
    }
    matrix[3] = glm::dvec4(transform.localPosition, 1.0);
    return matrix;
}

glm::dmat4 WorldMatrices::Of(const Transform& transform)
{
    return transform.parent == nullptr ? LocalMatrix(transform)
                                       : OfParent(transform) * LocalMatrix(transform);
}

const glm::dmat4& WorldMatrices::OfParent(const Transform& transform)
{
    CircleGuard guard(transform);
    const glm::dmat4* known = nullptr;
    m_Climbed.clear();
    for (const Transform* t = transform.parent; t != nullptr && known == nullptr; t = t->parent)
    {
        guard.Pass(t);
        known = FindParent(t);
        if (known == nullptr)
        {
            m_Climbed.push_back(t);
        }
    }
    for (; !m_Climbed.empty(); m_Climbed.pop_back())
    {
        const Transform& top = *m_Climbed.back();
        const glm::dmat4 local = LocalMatrix(top);
        Parent& parent = m_Parents[&top];
        parent = {known != nullptr ? *known * local : local, m_Round};
        known = &parent.world;
        ++m_Known;
    }
    return *known;
}

void WorldMatrices::Clear()
{
    if (m_Parents.size() > 2 * m_Known)
    {
        m_Parents.clear(); // most of them are parents no more
    }
    m_Known = 0;
    ++m_Round;
}

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
    const glm::dvec3 ahead(forward); // in double: no float's square is 0 or infinite
    const glm::dvec3 above(up);
    const double length = glm::length(ahead);
    if (!(length > 0.0))
    {
        throw ContractError("LookRotation: the forward direction is zero");
    }
    const glm::dvec3 z = ahead / length;
    glm::dvec3 x = glm::cross(above, z);
    if (!(glm::length(x) > 1e-6 * glm::length(above)))
    {
        x = glm::cross(std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -z.y), z);
    }
    x = glm::normalize(x);
    return glm::quat(glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z)));
}

glm::mat4 Transform::localToParentMatrix() const
{
    return glm::mat4(LocalMatrix(*this));
}

glm::dmat4 Transform::worldMatrix() const
{
    return WorldMatrices().Of(*this);
}

glm::dquat Transform::worldRotation() const
{
    CircleGuard guard(*this);
    glm::dquat turned(localRotation);
    for (const Transform* t = parent; t != nullptr; t = t->parent)
    {
        guard.Pass(t);
        turned = glm::dquat(t->localRotation) * turned;
    }
    return turned;
}

} // namespace limn

#include <limn/volume/CapsuleCollider.h>

#include "shapes/RoundShape.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limn/shaderlab/Diagnostic.h>
#include <string>

namespace limn
{

glm::vec3 CapsuleCollider::ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                                        const glm::quat& rotation, const glm::vec3& scale) const
{
    if (direction < 0 || direction > 2)
    {
        throw ContractError("a capsule collider's direction is " + std::to_string(direction) +
                            "; it must be 0 (x), 1 (y) or 2 (z)");
    }
    const glm::vec3 lengths = glm::abs(scale);
    const float across = std::max(lengths[(direction + 1) % 3], lengths[(direction + 2) % 3]);
    const float scaledRadius = std::abs(radius) * across;
    const float halfHeight = std::abs(height) * lengths[direction] * 0.5f;
    const float reach = std::max(halfHeight - scaledRadius, 0.0f);

    glm::vec3 axis(0.0f);
    axis[direction] = 1.0f;
    axis = rotation * axis;
    const glm::vec3 middle = position + rotation * (scale * center);
    const float along = glm::clamp(glm::dot(point - middle, axis), -reach, reach);
    return ClosestPointAround(middle + axis * along, scaledRadius, point);
}

} // namespace limn

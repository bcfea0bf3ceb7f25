#include <limn/volume/SphereCollider.h>

#include "shapes/RoundShape.h"

#include <algorithm>
#include <glm/common.hpp>

namespace limn
{

glm::vec3 SphereCollider::ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                                       const glm::quat& rotation, const glm::vec3& scale) const
{
    const glm::vec3 lengths = glm::abs(scale);
    const float scaledRadius =
        std::abs(radius) * std::max(lengths.x, std::max(lengths.y, lengths.z));
    return ClosestPointAround(position + rotation * (scale * center), scaledRadius, point);
}

} // namespace limn

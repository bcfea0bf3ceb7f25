#include <limn/volume/BoxCollider.h>

#include <glm/common.hpp>

namespace limn
{

glm::vec3 BoxCollider::ClosestPoint(const glm::vec3& point, const glm::vec3& position,
                                    const glm::quat& rotation, const glm::vec3& scale) const
{
    const glm::vec3 middle = position + rotation * (scale * center);
    const glm::vec3 halfSize = glm::abs(size * scale) * 0.5f;
    const glm::vec3 inBox = glm::conjugate(rotation) * (point - middle);
    const glm::vec3 clamped = glm::clamp(inBox, -halfSize, halfSize);
    // Inside, the point itself: turning it there and back would not give it exactly.
    return clamped == inBox ? point : middle + rotation * clamped;
}

} // namespace limn

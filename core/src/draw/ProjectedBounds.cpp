#include "draw/ProjectedBounds.h"

#include <algorithm>
#include <glm/ext/matrix_double4x4.hpp>
#include <limits>

namespace limn
{

std::optional<TargetRegion> ProjectBounds(const Bounds& bounds, const glm::mat4& localToWorld,
                                          const glm::mat4& viewProjection)
{
    // Nearer than this, float and double may not agree about what is behind the camera.
    constexpr double k_LeastW = 1e-4;
    constexpr double k_Infinity = std::numeric_limits<double>::infinity();
    const glm::dmat4 matrix = glm::dmat4(viewProjection) * glm::dmat4(localToWorld);
    TargetRegion region{k_Infinity, k_Infinity, -k_Infinity, -k_Infinity};
    for (int corner = 0; corner < 8; ++corner)
    {
        const glm::vec3 side((corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f,
                             (corner & 4) != 0 ? 1.0f : -1.0f);
        const glm::dvec4 clip =
            matrix * glm::dvec4(glm::dvec3(bounds.center + side * bounds.extents), 1.0);
        if (!(clip.w > k_LeastW))
        {
            return std::nullopt;
        }
        const double x = 0.5 + 0.5 * clip.x / clip.w;
        const double y = 0.5 - 0.5 * clip.y / clip.w;
        region = Union(region, {x, y, x, y});
    }
    return region;
}

TargetRegion Union(const TargetRegion& a, const TargetRegion& b)
{
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
            std::max(a.bottom, b.bottom)};
}

} // namespace limn

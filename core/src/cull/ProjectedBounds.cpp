#include "cull/ProjectedBounds.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_double4x4.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace limn
{

namespace
{

// Nearer than this, float and double may not agree about what is behind the camera.
constexpr double k_LeastW = 1e-4;

std::optional<TargetRegion> ProjectBox(const Bounds& bounds, const glm::dmat4& matrix)
{
    constexpr double k_Infinity = std::numeric_limits<double>::infinity();
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

/// The sphere's silhouette, exactly, whatever ellipsoid the matrix makes of it: the planes
/// axis = k * w that touch it are the two roots of a quadratic equation, since plane^T Q plane = 0
/// for all planes that touch it, with Q = radius^2 A A^T - p p^T, A the matrix without its last
/// column and p the centre in clip space.
std::optional<TargetRegion> ProjectSphere(const glm::dvec3& center, double radius,
                                          const glm::dmat4& matrix)
{
    const glm::dvec4 p = matrix * glm::dvec4(center, 1.0);
    const auto row = [&](int i)
    {
        return radius * glm::dvec3(matrix[0][i], matrix[1][i], matrix[2][i]);
    };
    const glm::dvec3 w = row(3);
    const double ww = p.w * p.w - glm::dot(w, w);
    if (!(p.w - glm::length(w) > k_LeastW))
    {
        return std::nullopt;
    }
    const auto limits = [&](int i)
    {
        const glm::dvec3 x = row(i);
        const double xw = p[i] * p.w - glm::dot(x, w);
        // The discriminant, written so that large numbers do not cancel out.
        const glm::dvec3 across = p.w * x - p[i] * w;
        const glm::dvec3 area = glm::cross(x, w);
        const double root =
            std::sqrt(std::max(glm::dot(across, across) - glm::dot(area, area), 0.0));
        return std::pair((xw - root) / ww, (xw + root) / ww);
    };
    const auto [left, right] = limits(0);
    const auto [bottom, top] = limits(1);
    return TargetRegion{0.5 + 0.5 * left, 0.5 - 0.5 * top, 0.5 + 0.5 * right, 0.5 - 0.5 * bottom};
}

} // namespace

std::optional<TargetRegion> ProjectBounds(const Bounds& bounds, float radius,
                                          const glm::mat4& localToWorld,
                                          const glm::mat4& viewProjection)
{
    const glm::dmat4 matrix = glm::dmat4(viewProjection) * glm::dmat4(localToWorld);
    const auto box = ProjectBox(bounds, matrix);
    const auto sphere = std::isfinite(radius) ? ProjectSphere(glm::dvec3(bounds.center),
                                                              static_cast<double>(radius), matrix)
                                              : std::nullopt;
    return box && sphere
               ? TargetRegion{std::max(box->left, sphere->left), std::max(box->top, sphere->top),
                              std::min(box->right, sphere->right),
                              std::min(box->bottom, sphere->bottom)}
           : box ? box
                 : sphere;
}

TargetRegion Union(const TargetRegion& a, const TargetRegion& b)
{
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
            std::max(a.bottom, b.bottom)};
}

} // namespace limn

#pragma once

#include "report/truth/BoxTree.h"

#include <array>
#include <glm/vec2.hpp>
#include <vector>

namespace limn
{
struct Camera;
struct Transform;
class Mesh;
} // namespace limn

namespace limn::study
{

/// Triangles of the picture, in pixels, with corners in either order. (0, 0) is the upper left
/// corner of the upper left pixel, and y counts downwards.
using ScreenTriangles = std::vector<std::array<glm::dvec2, 3>>;

inline constexpr double k_Touching = 1e-9; ///< in pixels; points that are nearer count as the same

/// Returns twice the area of the triangle between two vectors, positive if `b` is clockwise of `a`.
inline double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// Returns whether a point is in a triangle with an area, or on its edge.
bool IsInTriangle(const std::array<glm::dvec2, 3>& corners, const glm::dvec2& point);

/// Returns a regular polygon in place of a disc. It has the disc's area, and its border is off by
/// at most 5e-5 pixels.
ScreenTriangles DiscTriangles(const glm::dvec2& center, double radius);
/// Returns a disc with a round hole.
ScreenTriangles RingTriangles(const glm::dvec2& center, double innerRadius, double outerRadius);
/// @param turn  the angle of the first tip in radians, from the right towards the bottom
ScreenTriangles StarTriangles(const glm::dvec2& center, int tips, double innerRadius,
                              double outerRadius, double turn = 0.0);
/// Returns a rectangle around the line from `from` to `to`.
ScreenTriangles NeedleTriangles(const glm::dvec2& from, const glm::dvec2& to, double thickness);
/// Returns the part of a mesh that is between the camera's near and far plane, front and back
/// faces, as a picture of that size shows it. Triangles outside of the picture are in the result
/// too.
ScreenTriangles MeshTriangles(const Mesh& mesh, const Transform& transform, const Camera& camera,
                              int width, int height);
ScreenTriangles Together(std::initializer_list<ScreenTriangles> parts);
ScreenTriangles Moved(ScreenTriangles triangles, const glm::dvec2& offset);

/// The union of triangles, with its true border: edges inside the union are no border.
class Silhouette
{
public:
    /// Makes the union of the triangles. Triangles without an area are ignored.
    explicit Silhouette(const ScreenTriangles& triangles);

    /// Returns whether the point is in a triangle or on its edge.
    bool Contains(const glm::dvec2& point) const;
    /// Returns the distance to the border in pixels, negative inside, or +-limit if the border is
    /// not nearer than that.
    /// @param nearest  if it is not null and the border is nearer than limit, receives the nearest
    ///     point of the border
    double SignedDistance(const glm::dvec2& point, double limit,
                          glm::dvec2* nearest = nullptr) const;

    const Box& bounds() const { return m_Bounds; }
    const std::vector<std::array<glm::dvec2, 2>>& border() const { return m_Border; }

private:
    ScreenTriangles m_Triangles;
    std::vector<std::array<glm::dvec2, 2>> m_Border;
    BoxTree m_TriangleTree;
    BoxTree m_BorderTree;
    Box m_Bounds;
};

} // namespace limn::study

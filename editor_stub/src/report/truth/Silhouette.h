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

/// Triangles of the picture, either way round, in pixels: (0, 0) is the upper left corner of the
/// upper left pixel, y counts downwards.
using ScreenTriangles = std::vector<std::array<glm::dvec2, 3>>;

inline constexpr double k_Touching = 1e-9; ///< pixels; nearer points are the same

/// Returns twice the area of the triangle between two vectors, positive if `b` is clockwise of `a`.
inline double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// A regular polygon as good as a disc: it has the disc's area, and is off by at most 5e-5 pixels.
ScreenTriangles DiscTriangles(const glm::dvec2& center, double radius);
/// A disc with a round hole.
ScreenTriangles RingTriangles(const glm::dvec2& center, double innerRadius, double outerRadius);
/// @param turn  radians, of the first tip from the right towards the bottom
ScreenTriangles StarTriangles(const glm::dvec2& center, int tips, double innerRadius,
                              double outerRadius, double turn = 0.0);
/// A rectangle around the line from `from` to `to`.
ScreenTriangles NeedleTriangles(const glm::dvec2& from, const glm::dvec2& to, double thickness);
/// What of a mesh is between the camera's near and far plane, front and back, as a picture of that
/// size shows it; what is outside the picture is there too.
ScreenTriangles MeshTriangles(const Mesh& mesh, const Transform& transform, const Camera& camera,
                              int width, int height);
ScreenTriangles Together(std::initializer_list<ScreenTriangles> parts);
ScreenTriangles Moved(ScreenTriangles triangles, const glm::dvec2& offset);

/// The union of triangles, with its true border: edges inside it count for nothing.
class Silhouette
{
public:
    /// Triangles without an area are passed over.
    explicit Silhouette(const ScreenTriangles& triangles);

    /// Whether the point is in a triangle, or on its edge.
    bool Contains(const glm::dvec2& point) const;
    /// How far the border is away, pixels, negative inside; +-limit if it is not nearer.
    /// @param nearest  if not null and the border is nearer, becomes its nearest point
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

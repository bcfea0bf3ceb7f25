#pragma once

#include "report/truth/BoxTree.h"

#include <array>
#include <glm/vec3.hpp>
#include <limn/core/Camera.h>
#include <limn/core/Mesh.h>
#include <limn/core/PipelineState.h>

namespace limn::study
{

/// Triangles of the picture, in pixels, with corners in either order. (0, 0) is the upper left
/// corner of the upper left pixel, and y counts downwards.
using ScreenTriangles = std::vector<std::array<glm::dvec2, 3>>;

/// A triangle of the picture. x and y are in pixels, as in ScreenTriangles. z is the nearness, from
/// 1 at the near plane to 0 at the far one. The nearness is a linear function of x and y.
using DepthTriangle = std::array<glm::dvec3, 3>;

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
/// Returns the part of one sub-mesh that is between the camera's near and far plane, as
/// MeshTriangles does.
/// @param cull  the faces that are left out
std::vector<DepthTriangle> MeshDepths(const Mesh& mesh, int subMesh, const Transform& transform,
                                      const Camera& camera, int width, int height, CullMode cull);
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

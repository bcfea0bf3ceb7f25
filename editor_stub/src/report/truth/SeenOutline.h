#pragma once

#include "report/truth/OutlineReference.h"

#include <glm/vec3.hpp>
#include <limn/core/PipelineState.h>
#include <limn/features/Technique.h>

namespace limn::study
{

/// A triangle of the picture. x and y are in pixels, as in ScreenTriangles. z is the nearness, from
/// 1 at the near plane to 0 at the far one. The nearness is a linear function of x and y.
using DepthTriangle = std::array<glm::dvec3, 3>;

/// Returns the part of one sub-mesh that is between the camera's near and far plane, as
/// MeshTriangles does.
/// @param cull  the faces that are left out
std::vector<DepthTriangle> MeshDepths(const Mesh& mesh, int subMesh, const Transform& transform,
                                      const Camera& camera, int width, int height, CullMode cull);

/// The surfaces of several objects, asked for the nearest one at a place of the picture.
class Surfaces
{
public:
    static constexpr std::size_t k_NoOwner = ~std::size_t{0};
    struct Hit
    {
        double nearness = 0.0;
        std::size_t owner = k_NoOwner; ///< k_NoOwner where there is no surface
    };

    /// Adds triangles of the object `owner`. Triangles without an area are passed over.
    void Add(const std::vector<DepthTriangle>& triangles, std::size_t owner);
    /// Must be called after the last Add and before the first NearestAt.
    void Finish();
    Hit NearestAt(const glm::dvec2& point) const;
    bool isEmpty() const { return m_Triangles.empty(); }

private:
    std::vector<DepthTriangle> m_Triangles;
    std::vector<std::size_t> m_Owners;
    BoxTree m_Tree;
};

/// The part of an outline that nothing hides.
struct SeenOutline
{
    Coverage seen;
    std::vector<std::size_t> hiding; ///< the owners that hide something, each once, in order
};

/// Divides each pixel of an outline by 4 x 4 places in it. Something hides the outline if it is
/// nearer to the camera than the object by more than a thousandth of the nearness: what touches the
/// object hides nothing.
/// @param whole   the outline of `width` pixels around the silhouette, whatever stands in front
/// @param own     the surfaces of the silhouette's objects
/// @param others  the surfaces that may stand in front
SeenOutline SeenOutlineCoverage(const Coverage& whole, const Silhouette& silhouette, double width,
                                const Surfaces& own, const Surfaces& others, HiddenAt where);

} // namespace limn::study

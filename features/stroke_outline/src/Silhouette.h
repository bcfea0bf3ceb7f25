#pragma once

#include "WeldedMesh.h"

#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <vector>

namespace limn
{

/// A silhouette edge on the screen; the object is on its right when looking from a to b with y
/// down.
struct Stroke
{
    glm::dvec2 a; ///< pixels of the picture
    glm::dvec2 b;
    double depthA = 0.0; ///< 1 near ... 0 far
    double depthB = 0.0;
    /// The cosine of the angle by which the silhouette turns at a and at b; -1 where it branches or
    /// ends.
    double turnA = -1.0;
    double turnB = -1.0;
};

/// Finds the edges of meshes that can be on their silhouette: those that do not have faces on both
/// sides on the screen, and those where the near or far plane cuts through a face. The winding of
/// the faces does not matter, nor how many faces meet at an edge. It may find additional edges
/// inside of the silhouette, but misses none.
///
/// The sign of a face's area on the screen tells on which side of its edges it lies. It is computed
/// once per face in double precision; a face without area lies on neither side.
class SilhouetteFinder
{
public:
    class StrokeMaker;

    /// Appends the silhouette edges of a sub-mesh.
    /// @param objectToClip  has reversed z
    /// @param picture       the size of the picture in pixels
    void Append(const std::shared_ptr<const Mesh>& mesh, int subMesh,
                const glm::dmat4& objectToClip, const glm::dvec2& picture,
                std::vector<Stroke>& strokes);

private:
    /// The strokes that end at a point.
    struct Ends
    {
        int count = 0;
        std::pair<std::size_t, bool> strokes[2]; ///< and whether it is b
    };
    struct Entry
    {
        std::weak_ptr<const Mesh> mesh;
        WeldedMesh welded;
    };
    const WeldedMesh& Find(const std::shared_ptr<const Mesh>& mesh, int subMesh);

    std::map<std::pair<std::uint64_t, int>, Entry> m_Meshes; ///< by Mesh::id
    std::vector<glm::dvec4> m_Clip;                          ///< the points in clip space
    std::vector<signed char> m_Areas;                        ///< the signs of the faces' areas
    std::vector<Ends> m_Ends;
    std::vector<std::uint32_t> m_EndsOfPoint; ///< indices in m_Ends, or k_NoPoint
};

} // namespace limn

#pragma once

#include "WeldedMesh.h"

#include <glm/mat4x4.hpp>
#include <limn/core/Mesh.h>
#include <map>
#include <memory>
#include <vector>

namespace limn
{

/// A silhouette edge on the screen; the object is on its right, seen along from a to b with y down.
struct Stroke
{
    glm::dvec2 a; ///< pixels of the picture
    glm::dvec2 b;
    double depthA = 0.0; ///< 1 near ... 0 far
    double depthB = 0.0;
    /// Lines that go on from a and b where the silhouette does not branch or end: the cosine of the
    /// angle by which it turns there; -1 otherwise.
    double turnA = -1.0;
    double turnB = -1.0;
};

/// The edges of meshes at which what is seen of them can end: those that do not have faces on both
/// of their sides on the screen, and where the near or far plane cuts through a face. Which way
/// round the corners of a face go does not matter, nor how many faces meet at an edge. There may be
/// more of these edges, inside of what is seen; there are not fewer.
///
/// On which side of its edges a face lies is the sign of its area on the screen in double
/// precision, worked out once a face; a face without area lies on neither.
class SilhouetteFinder
{
public:
    /// Appends those of a sub-mesh.
    /// @param objectToClip  reversed z
    /// @param picture       its size in pixels
    void Append(const std::shared_ptr<const Mesh>& mesh, int subMesh,
                const glm::dmat4& objectToClip, const glm::dvec2& picture,
                std::vector<Stroke>& strokes);

private:
    struct Entry
    {
        std::weak_ptr<const Mesh> mesh;
        WeldedMesh welded;
    };
    const WeldedMesh& Find(const std::shared_ptr<const Mesh>& mesh, int subMesh);

    std::map<std::pair<std::uint64_t, int>, Entry> m_Meshes; ///< by Mesh::id
    std::vector<glm::dvec4> m_Clip;                          ///< of the points
    std::vector<signed char> m_Areas;                        ///< their signs, of the faces
};

} // namespace limn

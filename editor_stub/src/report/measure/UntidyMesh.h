#pragma once

#include <limn/core/Mesh.h>
#include <memory>
#include <string>
#include <vector>

namespace limn::study
{

/// These are faults of real meshes. All but the last two leave the look of the tidy mesh.
enum class Untidiness
{
    None,
    OneTriangleTurned, ///< its corners go round the other way
    OneFaceTurned,     ///< two neighbours
    TurnedAtRandom,    ///< half of all triangles
    Doubled,           ///< each triangle is there twice
    DoubleSided,       ///< twice, once the other way round
    TwoObjects,        ///< at the same place; the mesh itself is tidy
    Soup,              ///< no triangle shares a vertex with another, half of them are turned
    TJunctions,        ///< every other triangle has a corner in the middle of its neighbour's side
    NoArea,            ///< beside every other triangle lie two that are a line and a point
    Open,              ///< the first third of all triangles is missing
    Fins               ///< three faces meet at some edges, the third one standing off the mesh
};

/// "tidy", "one triangle turned", ... in the order of Untidiness.
const std::vector<std::string>& UntidinessNames();

/// A copy with vertices and normals only.
/// @param tidy  one list of triangles; with normals
std::shared_ptr<const Mesh> MakeUntidy(const Mesh& tidy, Untidiness untidiness);

} // namespace limn::study

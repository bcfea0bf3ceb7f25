#pragma once

#include <array>
#include <limn/core/Mesh.h>
#include <memory>

namespace limn::study
{

/// These are faults of real meshes. All but the last two leave the look of the tidy mesh.
enum class Untidiness
{
    None,
    OneTriangleTurned, ///< one triangle's corners go round the other way
    OneFaceTurned,     ///< two neighbour triangles are turned
    TurnedAtRandom,    ///< half of all triangles are turned
    Doubled,           ///< each triangle is there twice
    DoubleSided,       ///< each triangle is there twice, once the other way round
    TwoObjects,        ///< two objects are at the same place; the mesh itself is tidy
    Soup,              ///< no triangle shares a vertex with another, half of them are turned
    TJunctions,        ///< every other triangle has a corner in the middle of its neighbour's side
    NoArea,            ///< beside every other triangle lie two that are a line and a point
    Open,              ///< the first third of all triangles is missing
    Fins               ///< three faces meet at some edges, the third one standing off the mesh
};

/// The names, in the order of Untidiness.
inline constexpr std::array k_UntidinessNames{"tidy",
                                              "one triangle turned",
                                              "one face turned",
                                              "turned at random",
                                              "doubled",
                                              "double-sided",
                                              "two objects",
                                              "soup",
                                              "T-junctions",
                                              "no area",
                                              "open",
                                              "fins"};

/// Returns an untidy copy of a mesh, with vertices and normals only.
/// @param tidy  must have one list of triangles, and normals
std::shared_ptr<const Mesh> MakeUntidy(const Mesh& tidy, Untidiness untidiness);

} // namespace limn::study

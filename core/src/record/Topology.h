#pragma once

#include <limn/core/Material.h>
#include <limn/core/Mesh.h>

namespace limn
{

/// @throws DrawError if the geometry function of the material's shader takes other primitives
void ExpectTopology(MeshTopology drawn, GeometryInput taken, const Material& material);

/// Returns the indices that draw quads of four vertices as triangles. All vertices are at 0, since
/// draws of MeshTopology::Quads have no other data than SV_VertexID.
std::shared_ptr<const Mesh> MakeQuads(std::uint32_t count);

} // namespace limn

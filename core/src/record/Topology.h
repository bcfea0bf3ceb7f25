#pragma once

#include <limn/core/Material.h>
#include <limn/core/Mesh.h>

namespace limn
{

/// @throws DrawError if the geometry function of the material's shader takes something else
void ExpectTopology(MeshTopology drawn, GeometryInput taken, const Material& material);

/// The indices that draw quads of four vertices as triangles. The vertices are all at 0: draws of
/// MeshTopology::Quads have no other data than SV_VertexID.
std::shared_ptr<const Mesh> MakeQuads(std::uint32_t count);

} // namespace limn

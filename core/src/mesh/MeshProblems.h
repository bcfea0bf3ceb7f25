#pragma once

#include <limn/core/Mesh.h>

namespace limn
{

/// Returns what keeps `data` from being a mesh, one sentence per problem; empty if nothing does.
/// For a Mesh that is its caller's mistake, for a loader its file's.
std::vector<std::string> MeshProblems(const MeshData& data);

} // namespace limn

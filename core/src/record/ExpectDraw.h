#pragma once

#include <limn/core/Material.h>
#include <limn/core/Mesh.h>

namespace limn
{

inline constexpr int k_AllPasses = -1;

// What can be seen wrong in a draw when it is recorded. All throw ContractError.

void ExpectMaterial(const std::shared_ptr<const Material>& material);
/// A material, this pass of it, and a finite matrix.
void ExpectDrawable(const std::shared_ptr<const Material>& material, int shaderPass,
                    const glm::mat4& matrix);
void ExpectSubMesh(const Mesh& mesh, int subMesh);

} // namespace limn

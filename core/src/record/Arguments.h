#pragma once

#include <limn/core/GraphicsBuffer.h>
#include <limn/core/Material.h>
#include <limn/core/Mesh.h>

namespace limn
{

inline constexpr int k_AllPasses = -1;

// These check a draw or dispatch when it is recorded. All throw ContractError. `call` is the name
// of the command, for messages.

void ExpectMaterial(const char* call, const std::shared_ptr<const Material>& material);
/// Requires this pass of the material, which must not be null, and a finite matrix.
void ExpectDrawable(const std::shared_ptr<const Material>& material, int shaderPass,
                    const glm::mat4& matrix);
void ExpectSubMesh(const Mesh& mesh, int subMesh);

/// Returns the place of an indirect command's arguments.
/// @param count  the number of uint
/// @throws ContractError if the buffer is null or made for something else, or they do not lie in it
///     at a multiple of 4 bytes
BufferRange ArgumentsRange(const char* call, std::shared_ptr<const GraphicsBuffer> buffer,
                           std::int64_t offset, std::uint32_t count);

} // namespace limn

#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace limn
{

// GLM's vectors by the names that a line of C# has, so that `Vector4(1, 1, 0, 0)` goes over as it
// is; their members are GLM's. Unity: UnityEngine.Vector2 ... (2022.3).

using Vector2 = glm::vec2;
using Vector3 = glm::vec3;
using Vector4 = glm::vec4;
using Vector2Int = glm::ivec2;
using Vector3Int = glm::ivec3;

} // namespace limn

#pragma once

#include <limn/core/Mesh.h>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace limn
{

/// The built-in shapes of Unity (UnityEngine.PrimitiveType), with its sizes, and a torus.
enum class PrimitiveType
{
    Sphere,   ///< diameter 1
    Capsule,  ///< diameter 1, height 2, along y
    Cylinder, ///< diameter 1, height 2, along y
    Cube,     ///< side 1
    Plane,    ///< 10 x 10 in xz, facing +y, 10 x 10 cells
    Quad,     ///< 1 x 1 in xy, facing -z
    Torus     ///< ring diameter 1, tube diameter 0.25, around y; limn's own
};

/// Makes a mesh with normals, tangents and uv, centred at the origin. Objects that are to be drawn
/// as instances must share one mesh. Texture v is 0 at the top of a shape, where Unity's is 1.
std::shared_ptr<const Mesh> CreatePrimitive(PrimitiveType type);

/// Returns the type of a name as scene files write it ("cube", case-insensitive), if there is one.
std::optional<PrimitiveType> PrimitiveTypeFromName(std::string_view name);

/// Returns all names in lower case, for messages.
std::vector<std::string_view> PrimitiveTypeNames();

} // namespace limn

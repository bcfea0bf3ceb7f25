#pragma once

#include "scene/WorldMatrices.h"

#include <cstdint>
#include <limn/core/Scene.h>

namespace limn
{

/// Of all that an object's rows in a RendererTable are made from, but what its materials and meshes
/// hold.
/// @param matrices  gets those of its parents
std::uint64_t HashOf(const GameObject& object, WorldMatrices& matrices);

} // namespace limn

#pragma once

#include "scene/WorldMatrices.h"

#include <cstdint>
#include <limn/core/Scene.h>

namespace limn
{

/// Tells whether an object's rows in a RendererTable are still what they were made from. It does
/// not look at the contents of materials and meshes.
struct ObjectHash
{
    std::uint64_t place = 0; ///< of the world matrix
    std::uint64_t rest = 0;

    bool operator==(const ObjectHash&) const = default;
};

/// @param matrices  receives those of its parents
ObjectHash HashOf(const GameObject& object, WorldMatrices& matrices);

} // namespace limn

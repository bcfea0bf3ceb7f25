#pragma once

#include <limn/volume/BoxCollider.h>
#include <limn/volume/CapsuleCollider.h>
#include <limn/volume/MeshCollider.h>
#include <limn/volume/SphereCollider.h>
#include <variant>

namespace limn
{

/// A shape of a local volume: those that Unity's Collider.ClosestPoint knows.
/// Unity: UnityEngine.Collider (2022.3).
using Collider = std::variant<BoxCollider, SphereCollider, CapsuleCollider, MeshCollider>;

} // namespace limn

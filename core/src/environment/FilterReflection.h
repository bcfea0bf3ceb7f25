#pragma once

#include "environment/CubeLight.h"

namespace limn
{

/// The mip level that surfaces of perceptual roughness 1 mirror: UNITY_SPECCUBE_LOD_STEPS.
inline constexpr int k_RoughestLevel = 6;

/// Returns the perceptual roughness whose mip level this is: the inverse of the ShaderLibrary's
/// PerceptualRoughnessToMipmapLevel.
double PerceptualRoughnessOfLevel(int level);

/// Returns what surfaces that are rougher and rougher mirror of a light, seen straight on: level 0
/// is the light itself, each next one half as wide, down to k_RoughestLevel or one texel. Each is
/// the mean by the GGX distribution and the cosine, so that what is the same from all sides stays
/// so.
/// @param light  of a width that is a power of two
/// @source B. Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013; J. Krivanek, M. Colbert,
///         "Real-Time Shading with Filtered Importance Sampling", EGSR 2008
std::vector<CubeLight> FilterReflection(const CubeLight& light);

} // namespace limn

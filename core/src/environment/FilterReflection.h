#pragma once

#include "environment/CubeLight.h"

namespace limn
{

/// The mip level that surfaces of perceptual roughness 1 mirror: UNITY_SPECCUBE_LOD_STEPS.
inline constexpr int k_RoughestLevel = 6;

/// Returns the perceptual roughness whose mip level this is: the inverse of the ShaderLibrary's
/// PerceptualRoughnessToMipmapLevel.
double PerceptualRoughnessOfLevel(int level);

/// Returns the reflections of a light in increasingly rough surfaces, seen straight on: level 0 is
/// the light itself; each next one is half as wide, down to k_RoughestLevel or one texel. Each is
/// the mean weighted by the GGX distribution and the cosine, so that light that is the same from
/// all sides stays so.
/// @param light  its width must be a power of two
/// @source B. Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013; J. Krivanek, M. Colbert,
///     "Real-Time Shading with Filtered Importance Sampling", EGSR 2008
std::vector<CubeLight> FilterReflection(const CubeLight& light);

} // namespace limn

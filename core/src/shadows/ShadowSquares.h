#pragma once

#include <limn/core/FrameCommands.h>
#include <span>
#include <vector>

namespace limn
{

/// A light's request for squares of a shadow map that it shares with others.
struct ShadowSquares
{
    int side = 0;  ///< texels
    int least = 8; ///< texels: smaller ones do not look like shadows
    int count = 1; ///< number of squares
};

/// Places squares next to each other, the largest first; among equal ones, those of earlier
/// requests come first. All of them are halved as often as needed until they fit. Requests whose
/// squares would become smaller than their least get none; the smallest are dropped first.
/// @param size    texels along a side of the map, of which a power of two is used
/// @param result  receives each request's squares in turn; of width 0 if there is no room
/// @source Unity: AdditionalLightsShadowCasterPass's layout of its atlas (URP 14)
void PlaceShadowSquares(std::span<const ShadowSquares> requests, int size,
                        std::vector<ViewportRect>& result);

} // namespace limn

#pragma once

#include <limn/core/FrameCommands.h>
#include <span>
#include <vector>

namespace limn
{

/// What a light asks for of a shadow map that it shares with others.
struct ShadowSquares
{
    int side = 0;  ///< texels
    int least = 8; ///< texels: smaller ones do not look like shadows
    int count = 1; ///< of squares
};

/// Puts squares next to each other, the largest first, those of earlier requests before equal ones
/// of later ones; all of them halved as often as it takes for them to fit. Requests whose squares
/// would be smaller than their least get none, the smallest of them first.
/// @param size    texels along a side of the map, of which a power of two is used
/// @param result  gets each request's squares in turn; of width 0 where there is no room
/// @source Unity: AdditionalLightsShadowCasterPass's layout of its atlas (URP 14)
void PlaceShadowSquares(std::span<const ShadowSquares> requests, int size,
                        std::vector<ViewportRect>& result);

} // namespace limn

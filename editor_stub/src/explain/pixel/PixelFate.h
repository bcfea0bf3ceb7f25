#pragma once

#include "explain/pixel/PassProbe.h"
#include "explain/pixel/PixelHistory.h"

namespace limn
{

/// Finds the reason for which a draw that reaches the texel leaves it as it was: the first test
/// that rejects it.
/// @param which    of PassProbe::reaching
/// @param before   what the targets hold before it
/// @param isEmpty  whether the frame is known to have nothing there for it to show
std::pair<PixelFate, std::string> WhyUnchanged(const PassProbe& probe, std::size_t which,
                                               const TargetTexels& before, bool isEmpty);

/// "(0.25, 0, 1)", or "0.25".
std::string NumbersText(const std::vector<float>& numbers);

} // namespace limn

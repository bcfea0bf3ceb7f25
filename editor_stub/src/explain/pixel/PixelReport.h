#pragma once

#include "console/Json.h"
#include "explain/pixel/PixelHistory.h"

namespace limn
{

/// Writes the history for a person, in lines of about 80 columns.
/// @param isLong  names also what does not cover the pixel
std::string PixelText(const PixelHistory& history, bool isLong);

/// Writes all of it for programs.
Json PixelJson(const PixelHistory& history);

} // namespace limn

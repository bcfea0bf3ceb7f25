#pragma once

#include "report/truth/twins/Field.h"

#include <array>

namespace limn::study
{

/// The article's stencil colour at so many seconds, of an object selected at others, as an 8-bit
/// texture stores it.
std::array<double, 4> StencilColorReference(double time, double start);

/// The article's blur: the largest colour and the mean alpha of four bilinear taps.
/// @param offset  texels along both axes
Field BlurReference(const Field& source, double offset);
/// All blurs of the image effect, rounded to 8 bits behind each. The mean of four 8-bit numbers is
/// half way between two such as often as not, and float decides which it becomes.
/// @param tie  1: the higher one, -1: the lower one; what is drawn lies in between
Field BlurredReference(Field stencil, double offset, int iterate, int tie);

/// The article's composite of a picture of four channels.
Field CompositeReference(const Field& source, const Field& stencil, const Field& blur,
                         double strength);

/// How far a field is from what lies between two others, in units of 1/255.
struct Outside
{
    double largest = 0.0;
    double shareWithinTwo = 1.0; ///< of all channel values
};
Outside CompareBetween(const Field& drawn, const Field& a, const Field& b);

} // namespace limn::study

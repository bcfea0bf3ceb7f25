#pragma once

#include <limn/core/Image.h>
#include <string>

namespace limn::test
{

/// Compares a picture with tests/golden/<name>.png. Rasterisers differ in the last bit and on
/// edges: up to 0.1 % of the pixels may be off by more than 3/255 in some channel. Where more are,
/// the test fails, and actual.png and diff.png (absolute difference times 8) are left in
/// golden_failures/<name>/ of the working directory. LIMN_UPDATE_GOLDEN=1 writes the golden instead
/// and fails, so that nobody forgets to look at it.
/// @param mayMove  the device places corners less finely than the one that drew the golden: what
///                 moves by a part of a pixel shows in each one what lies between those that the
///                 golden shows in it and the eight around it
void ExpectGolden(const std::string& name, const Image& actual, bool mayMove = false);

} // namespace limn::test

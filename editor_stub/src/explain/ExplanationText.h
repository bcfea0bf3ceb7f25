#pragma once

#include "explain/Explanation.h"

namespace limn
{

/// What a frame draws and why on about a screen: what is odd, volume values, passes with counts by
/// verdict, what the device runs, what is left out, the textures that are drawn into.
std::string ShortText(const Explanation& explanation);

/// All that is known: besides ShortText each volume's part in each value, textures, variants, and
/// of each object what each pass does with it.
std::string LongText(const Explanation& explanation);

/// Only what became of the explanation's objects, which are `name` and what hangs below it.
/// @param isLong  of each of them; else one by one only if they are few
std::string ObjectText(const Explanation& explanation, const std::string& name, bool isLong);

} // namespace limn

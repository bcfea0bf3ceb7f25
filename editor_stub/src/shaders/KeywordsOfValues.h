#pragma once

#include <limn/core/Material.h>

namespace limn
{

/// Sets a material's keywords by its values, as Unity's inspector does: the keywords of the
/// attributes Toggle, ToggleOff and KeywordEnum, and for a shader of URP also those of its maps and
/// of emission.
void SetKeywordsOfValues(Material& material);

} // namespace limn

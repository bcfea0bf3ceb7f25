#pragma once

#include <limn/core/Material.h>

namespace limn
{

/// Sets a material's keywords by its values, as Unity's inspector does: those of the attributes
/// Toggle, ToggleOff and KeywordEnum, and with a shader of URP those of its maps and of emission.
void SetKeywordsOfValues(Material& material);

} // namespace limn

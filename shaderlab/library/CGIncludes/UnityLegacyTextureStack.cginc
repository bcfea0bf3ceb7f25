// There is no streaming virtual texturing, which VT would ask for: shaders include this beside
// textures that need none.
#pragma once
#include "HLSLSupport.cginc"

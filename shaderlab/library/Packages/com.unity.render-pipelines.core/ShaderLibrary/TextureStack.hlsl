// There is no streaming virtual texturing; shaders include this beside textures that need none.
#pragma once

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Texture.hlsl"

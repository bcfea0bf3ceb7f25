// The textures that 2D lights are drawn into. limn has no 2D lights: nothing draws them, and
// CombinedShapeLightShared.hlsl does not read them.
#pragma once
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

#define SHAPE_LIGHT(index) \
    TEXTURE2D(_ShapeLightTexture##index); \
    SAMPLER(sampler_ShapeLightTexture##index); \
    half2 _ShapeLightBlendFactors##index; \
    half4 _ShapeLightMaskFilter##index; \
    half4 _ShapeLightInvertedFilter##index;

#define NORMALS_LIGHTING_VARIABLES
#define NORMALS_LIGHTING_COORDS(TEXCOORDA, TEXCOORDB)
#define TRANSFER_NORMALS_LIGHTING(output, worldSpacePos, lightPosition, lightZDistance)
#define APPLY_NORMALS_LIGHTING(input, lightColor, lightPosition, lightZDistance)
#define SHADOW_VARIABLES
#define SHADOW_COORDS(TEXCOORDA)
#define TRANSFER_SHADOWS(output)
#define APPLY_SHADOWS(input, color, intensity)

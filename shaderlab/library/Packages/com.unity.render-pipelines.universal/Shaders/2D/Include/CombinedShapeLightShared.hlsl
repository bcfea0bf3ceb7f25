// The colour of a sprite under 2D lights.
#pragma once
#ifndef COMBINED_SHAPE_LIGHT_PASS
#define COMBINED_SHAPE_LIGHT_PASS
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/SurfaceData2D.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Debug/Debugging2D.hlsl"
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/ShapeLightVariables.hlsl"

#if defined(USE_SHAPE_LIGHT_TYPE_0) || defined(USE_SHAPE_LIGHT_TYPE_1) || \
    defined(USE_SHAPE_LIGHT_TYPE_2) || defined(USE_SHAPE_LIGHT_TYPE_3)
[limn_Lacks("2D lights", "sprites are drawn unlit")]
#endif
half4 CombinedShapeLightShared(in SurfaceData2D surfaceData, in InputData2D inputData)
{
    if (surfaceData.alpha == 0.0)
    {
        discard;
    }
    return max(0.0, half4(surfaceData.albedo, surfaceData.alpha));
}
// Of older versions
half4 CombinedShapeLightShared(half4 color, half4 mask, half2 lightingUV)
{
    SurfaceData2D surfaceData;
    InputData2D inputData;
    InitializeSurfaceData(color.rgb, color.a, mask, surfaceData);
    InitializeInputData(lightingUV, lightingUV, inputData);
    return CombinedShapeLightShared(surfaceData, inputData);
}
#endif

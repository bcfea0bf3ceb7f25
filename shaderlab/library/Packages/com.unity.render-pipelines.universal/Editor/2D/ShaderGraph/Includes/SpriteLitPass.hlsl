// Entry points of a generated pass of a sprite under 2D lights.
#pragma once
#include "limn/GraphSprite.hlsl"
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/LightingUtility.hlsl"
#include "Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/CombinedShapeLightShared.hlsl"

half4 frag(PackedVaryings packedInput) : SV_TARGET
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription surface = BuildSurfaceDescription(unpacked);
    half4 color = limn_GraphSpriteColor(unpacked, surface);
    float4 onScreen = unpacked.screenPosition;
    half2 lightingUV = onScreen.xy / onScreen.w;
    InputData2D inputData;
    InitializeInputData(unpacked.texCoord0.xy, lightingUV, inputData);
    SurfaceData2D surfaceData;
    InitializeSurfaceData(color.rgb, color.a, surface.SpriteMask, surfaceData);
    return CombinedShapeLightShared(surfaceData, inputData);
}

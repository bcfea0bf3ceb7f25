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
    SurfaceData2D surfaceData;
    InitializeSurfaceData(color.rgb, color.a, surface.SpriteMask, surfaceData);
    InputData2D inputData;
    InitializeInputData(unpacked.texCoord0.xy,
                        half2(unpacked.screenPosition.xy / unpacked.screenPosition.w), inputData);
    return CombinedShapeLightShared(surfaceData, inputData);
}

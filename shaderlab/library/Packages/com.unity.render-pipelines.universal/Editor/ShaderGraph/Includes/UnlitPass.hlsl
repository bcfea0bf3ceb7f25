// Entry points of a generated unlit pass.
#pragma once

#include "limn/GraphSurface.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Unlit.hlsl"

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

void frag(PackedVaryings packedInput, out float4 outColor : SV_Target0)
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription surface = BuildSurfaceDescription(unpacked);
    float alpha = limn_GraphAlpha(surface);
    InputData inputData = (InputData)0;
    inputData.positionCS = unpacked.positionCS;
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(unpacked.positionCS);
    outColor = UniversalFragmentUnlit(inputData, AlphaModulate(surface.BaseColor, alpha), alpha);
#ifdef VARYINGS_NEED_POSITION_WS
    float fog = InitializeInputDataFog(float4(unpacked.positionWS, 1.0), 0.0);
    outColor.rgb = MixFog(outColor.rgb, fog);
#endif
}

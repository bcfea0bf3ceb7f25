// Entry points of a generated unlit surface's deferred pass.
#pragma once
#include "limn/GraphSurface.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Unlit.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

FragmentOutput frag(PackedVaryings packedInput)
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription description = BuildSurfaceDescription(unpacked);
    SurfaceData surface = (SurfaceData)0;
    surface.alpha = limn_GraphAlpha(description);
    surface.albedo = AlphaModulate(description.BaseColor, surface.alpha);
    surface.occlusion = 1.0;
    InputData data = (InputData)0;
    data.normalWS = NormalizeNormalPerPixel(unpacked.normalWS);
    return SurfaceDataToGbuffer(surface, data, float3(0, 0, 0), kLightingInvalid);
}

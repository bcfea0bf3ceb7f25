// Entry points of a generated lit surface's deferred pass.
#pragma once
#include "limn/GraphLit.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/UnityGBuffer.hlsl"

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

FragmentOutput frag(PackedVaryings packedInput)
{
    Varyings unpacked = UnpackVaryings(packedInput);
    SurfaceDescription description = BuildSurfaceDescription(unpacked);
    SurfaceData surface = limn_GraphSurfaceData(description, limn_GraphAlpha(description));
    InputData data = limn_GraphInputData(unpacked, description);
    BRDFData brdf;
    InitializeBRDFData(surface, brdf);
    float3 light = GlobalIllumination(brdf, data.bakedGI, surface.occlusion, data.positionWS,
                                      data.normalWS, data.viewDirectionWS);
    return BRDFDataToGbuffer(brdf, data, surface.smoothness, surface.emission + light,
                             surface.occlusion);
}

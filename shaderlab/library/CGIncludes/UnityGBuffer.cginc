#pragma once
#ifndef UNITY_GBUFFER_INCLUDED
#define UNITY_GBUFFER_INCLUDED

struct UnityStandardData
{
    half3 diffuseColor;
    half occlusion;
    half3 specularColor;
    half smoothness;
    float3 normalWorld;
};

UnityStandardData limn_StandardData(half3 diffuse, half occlusion, half3 specular, half smoothness,
                                    float3 normal)
{
    UnityStandardData data;
    data.diffuseColor = diffuse;
    data.occlusion = occlusion;
    data.specularColor = specular;
    data.smoothness = smoothness;
    data.normalWorld = normal;
    return data;
}

void UnityStandardDataToGbuffer(UnityStandardData data, out half4 outGBuffer0,
                                out half4 outGBuffer1, out half4 outGBuffer2)
{
    half3 storedNormal = 0.5 * data.normalWorld + 0.5;
    outGBuffer2 = half4(storedNormal, 1.0);
    outGBuffer1 = half4(data.specularColor, data.smoothness);
    outGBuffer0 = half4(data.diffuseColor, data.occlusion);
}
UnityStandardData UnityStandardDataFromGbuffer(half4 inGBuffer0, half4 inGBuffer1,
                                               half4 inGBuffer2)
{
    float3 normal = normalize(2.0 * (float3)inGBuffer2.rgb - 1.0);
    return limn_StandardData(inGBuffer0.rgb, inGBuffer0.a, inGBuffer1.rgb, inGBuffer1.a, normal);
}
// Terrains blend their layers in G-buffers: weight times what each holds.
void UnityStandardDataApplyWeightToGbuffer(inout half4 inOutGBuffer0, inout half4 inOutGBuffer1,
                                           inout half4 inOutGBuffer2, half alpha)
{
    inOutGBuffer0.rgb *= alpha;
    inOutGBuffer1 *= alpha;
    inOutGBuffer2.rgb *= alpha;
}
#endif

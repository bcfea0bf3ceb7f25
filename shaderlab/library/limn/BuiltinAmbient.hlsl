// Ambient light and lights that are added up per vertex.
#pragma once
#include "limn/SphericalHarmonics.hlsl"

// normal.w is 1.
half3 SHEvalLinearL0L1(half4 normal)
{
    return limn_ShLinear(normal, unity_SHAr, unity_SHAg, unity_SHAb);
}
half3 SHEvalLinearL2(half4 normal)
{
    return limn_ShQuadratic(normal.xyz, unity_SHBr, unity_SHBg, unity_SHBb, unity_SHC);
}
// Light of harmonics, which are linear, in the colour space of the process, and back.
half3 limn_BuiltinAmbient(half3 light)
{
#ifdef UNITY_COLORSPACE_GAMMA
    return LinearToGammaSpace(light);
#else
    return light;
#endif
}
half3 limn_LinearAmbient(half3 light)
{
#ifdef UNITY_COLORSPACE_GAMMA
    return GammaToLinearSpace(light);
#else
    return light;
#endif
}
half3 ShadeSH9(half4 normal)
{
    return limn_BuiltinAmbient(SHEvalLinearL0L1(normal) + SHEvalLinearL2(normal));
}
half3 ShadeSH3Order(half4 normal) { return limn_BuiltinAmbient(SHEvalLinearL2(normal)); }
half3 ShadeSH12Order(half4 normal)
{
    return limn_BuiltinAmbient(max(SHEvalLinearL0L1(normal), 0.0));
}

// There are no volumes of light probes.
half3 SHEvalLinearL0L1_SampleProbeVolume(half4 normal, float3 worldPos)
{
    return SHEvalLinearL0L1(normal);
}
half4 LPPV_SampleProbeOcclusion(float3 worldPos) { return half4(1, 1, 1, 1); }

// Lambert with four lights at once; a component of each argument belongs to one light.
// Falloff: 1 / (1 + distance^2 * lightAttenSq).
float3 Shade4PointLights(float4 lightPosX, float4 lightPosY, float4 lightPosZ, float3 lightColor0,
                         float3 lightColor1, float3 lightColor2, float3 lightColor3,
                         float4 lightAttenSq, float3 pos, float3 normal)
{
    float4 x = lightPosX - pos.x;
    float4 y = lightPosY - pos.y;
    float4 z = lightPosZ - pos.z;
    float4 distanceSq = max(x * x + y * y + z * z, 0.000001);
    float4 cosine = (x * normal.x + y * normal.y + z * normal.z) * rsqrt(distanceSq);
    float4 weight = max(cosine, 0.0) / (1.0 + distanceSq * lightAttenSq);
    return lightColor0 * weight.x + lightColor1 * weight.y + lightColor2 * weight.z +
           lightColor3 * weight.w;
}

// The four lights that vertices of forward passes are lit by.
float3 limn_FourVertexLights(float3 worldPos, float3 normal)
{
    return Shade4PointLights(unity_4LightPosX0, unity_4LightPosY0, unity_4LightPosZ0,
                             unity_LightColor[0].rgb, unity_LightColor[1].rgb,
                             unity_LightColor[2].rgb, unity_LightColor[3].rgb,
                             unity_4LightAtten0, worldPos, normal);
}

// Ambient light and the first lightCount of the lights of vertex-lit passes, in view space.
float3 ShadeVertexLightsFull(float4 vertex, float3 normal, int lightCount, bool spotLight)
{
    float3 viewPos = UnityObjectToViewPos(vertex.xyz);
    float3 viewNormal = normalize(mul((float3x3)UNITY_MATRIX_IT_MV, normal));
    float3 sum = UNITY_LIGHTMODEL_AMBIENT.xyz;
    for (int i = 0; i < lightCount; ++i)
    {
        float3 toLight = unity_LightPosition[i].xyz - viewPos * unity_LightPosition[i].w;
        float distanceSq = max(dot(toLight, toLight), 0.000001);
        toLight *= rsqrt(distanceSq);
        float falloff = 1.0 / (1.0 + distanceSq * unity_LightAtten[i].z);
        if (spotLight)
        {
            float rho = max(0.0, dot(toLight, unity_SpotDirection[i].xyz));
            falloff *= saturate((rho - unity_LightAtten[i].x) * unity_LightAtten[i].y);
        }
        sum += unity_LightColor[i].rgb * (max(0.0, dot(viewNormal, toLight)) * falloff);
    }
    return sum;
}
float3 ShadeVertexLights(float4 vertex, float3 normal)
{
    return ShadeVertexLightsFull(vertex, normal, 4, false);
}

#pragma once
#ifndef UNITY_STANDARD_META_INCLUDED
#define UNITY_STANDARD_META_INCLUDED
#include "UnityCG.cginc"
#include "UnityStandardInput.cginc"
#include "UnityMetaPass.cginc"
#include "UnityStandardCore.cginc"

struct v2f_meta
{
    float4 pos : SV_POSITION;
    float4 uv : TEXCOORD0;
};

v2f_meta vert_meta(VertexInput v)
{
    v2f_meta o;
#if defined(DYNAMICLIGHTMAP_ON) || defined(UNITY_PASS_META)
    float2 uv2 = v.uv2;
#else
    float2 uv2 = v.uv1;
#endif
    o.pos = UnityMetaVertexPosition(v.vertex, v.uv1, uv2, unity_LightmapST, unity_DynamicLightmapST);
    o.uv = TexCoords(v);
    return o;
}

// Rough metals scatter much of what they mirror.
half3 UnityLightmappingAlbedo(half3 diffuse, half3 specular, half smoothness)
{
    return diffuse + specular * SmoothnessToRoughness(smoothness) * 0.5;
}

float4 frag_meta(v2f_meta i) : SV_Target
{
    FragmentCommonData surface = UNITY_SETUP_BRDF_INPUT(i.uv);
    UnityMetaInput light;
    UNITY_INITIALIZE_OUTPUT(UnityMetaInput, light);
    light.Emission = Emission(i.uv.xy);
    light.SpecularColor = surface.specColor;
    light.Albedo =
        UnityLightmappingAlbedo(surface.diffColor, surface.specColor, surface.smoothness);
    return UnityMetaFragment(light);
}
#endif

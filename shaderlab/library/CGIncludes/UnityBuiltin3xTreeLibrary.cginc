// Trees of the Tree Creator: bark and leaves that wind moves, light that shines through leaves.
#pragma once
#ifndef UNITY_BUILTIN_3X_TREE_LIBRARY_INCLUDED
#define UNITY_BUILTIN_3X_TREE_LIBRARY_INCLUDED
#include "UnityCG.cginc"
#include "Lighting.cginc"
#include "TerrainEngine.cginc"

fixed4 _Color;
fixed3 _TranslucencyColor;
fixed _TranslucencyViewDependency; // 0: by the side that is lit, 1: by looking into the light
half _ShadowStrength;

struct LeafSurfaceOutput
{
    fixed3 Albedo;
    fixed3 Normal;
    fixed3 Emission;
    fixed Translucency;
    half Specular; // exponent of the highlight over 128
    fixed Gloss;
    fixed Alpha;
};

// Light from behind, and light that wraps around the edge.
fixed limn_LeafBack(float nl, float3 lightDir, float3 viewDir)
{
    return lerp(saturate(-nl), saturate(dot(viewDir, -lightDir)), _TranslucencyViewDependency);
}
float limn_LeafFront(float nl) { return max(0.0, nl * 0.6 + 0.4); }

half4 LightingTreeLeaf(LeafSurfaceOutput s, half3 lightDir, half3 viewDir, half atten)
{
    half nl = dot(s.Normal, lightDir);
    half nh = max(0.0, dot(s.Normal, normalize(lightDir + viewDir)));
    half spec = pow(nh, s.Specular * 128.0) * s.Gloss;
    fixed3 through =
        limn_LeafBack(nl, lightDir, viewDir) * s.Translucency * 2.0 * _TranslucencyColor;
    fixed3 color = s.Albedo * (through + limn_LeafFront(nl)) * _LightColor0.rgb + spec;
#if defined(DIRECTIONAL) || defined(DIRECTIONAL_COOKIE)
    atten = lerp(1.0, atten, _ShadowStrength);
#endif
    return half4(color * atten, s.Alpha);
}

// Per vertex: the main light, and all that is not the main light.
fixed3 ShadeTranslucentMainLight(float4 vertex, float3 normal)
{
    float3 viewDir = normalize(WorldSpaceViewDir(vertex));
    float3 lightDir = normalize(WorldSpaceLightDir(vertex));
    float nl = dot(normal, lightDir);
    return _LightColor0.rgb *
           (limn_LeafFront(nl) + limn_LeafBack(nl, lightDir, viewDir) * _TranslucencyColor);
}

float3 limn_LeafAmbient(float3 worldPos, float3 normal)
{
    float3 light = ShadeSH9(float4(normal, 1.0));
#ifdef VERTEXLIGHT_ON
    light += limn_FourVertexLights(worldPos, normal);
#endif
    return light;
}
fixed3 ShadeTranslucentLights(float4 vertex, float3 normal)
{
    float3 worldPos = mul(unity_ObjectToWorld, vertex).xyz;
    float3 viewDir = normalize(WorldSpaceViewDir(vertex));
    float3 mainLightDir = normalize(WorldSpaceLightDir(vertex));
    float3 back = limn_LeafAmbient(worldPos, -normal) *
                  lerp(1.0, saturate(dot(viewDir, -mainLightDir)), _TranslucencyViewDependency);
    // Half, as light from all around is counted and not that of one side.
    return 0.5 * (limn_LeafAmbient(worldPos, normal) + back * _TranslucencyColor);
}

// color.xy, texcoord1.xy: what AnimateVertex takes
void TreeVertBark(inout appdata_full v)
{
    float4 animation = float4(v.color.xy, v.texcoord1.xy);
    float4 grown = float4(_TreeInstanceScale.xyz * v.vertex.xyz, v.vertex.w);
    v.vertex = Squash(AnimateVertex(grown, v.normal, animation));
    v.tangent.xyz = normalize(v.tangent.xyz);
    v.normal = normalize(v.normal);
    v.color.rgb = _Color.rgb * _TreeInstanceColor.rgb; // a is kept: the ambient occlusion
}
void TreeVertLeaf(inout appdata_full v)
{
    ExpandBillboard(UNITY_MATRIX_IT_MV, v.vertex, v.normal, v.tangent);
    TreeVertBark(v);
}

// A threshold out of an 8x8 pattern in which neighbours differ most (Bayer's matrix, 11 more), at
// pixel (x, y): coverage for a fade of c0.
float limn_Bayer8(uint x, uint y)
{
    uint value = 0u;
    for (uint bit = 0u; bit < 3u; ++bit)
    {
        uint across = (x >> bit) & 1u;
        uint down = (y >> bit) & 1u;
        value |= ((across ^ down) << (5u - 2u * bit)) | (down << (4u - 2u * bit));
    }
    return value;
}
float ScreenDitherToAlpha(float x, float y, float c0)
{
    float limit = (limn_Bayer8(uint(fmod(x, 8.0)), uint(fmod(y, 8.0))) + 11.0) / 64.0;
    return lerp(limit * c0, 1.0, c0);
}
float ComputeAlphaCoverage(float4 screenPos, float fadeAmount)
{
    float2 pixel = screenPos.xy / (screenPos.w + 0.00001) * _ScreenParams.xy;
    return ScreenDitherToAlpha(pixel.x, pixel.y, fadeAmount);
}
#endif

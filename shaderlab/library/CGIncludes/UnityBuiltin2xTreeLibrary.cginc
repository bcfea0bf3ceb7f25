// Trees of Unity 2 ("Nature/Tree Soft Occlusion"): lit per vertex by four lights, with the shade that
// the mesh carries. tangent: which way is open (xyz), how open it is (w).
#pragma once
#include "HLSLSupport.cginc"
#include "UnityCG.cginc"
#include "TerrainEngine.cginc"

float _Occlusion, _AO, _BaseLight;
fixed4 _Color;
float _HalfOverCutoff; // 0.5 / cutoff

// Scripts give the lights where USE_CUSTOM_LIGHT_DIR says so, as the editor's terrain does.
#ifdef USE_CUSTOM_LIGHT_DIR
cbuffer UnityTerrainImposter
{
    float3 _TerrainTreeLightDirections[4];
    float4 _TerrainTreeLightColors[4];
};
#endif
#define _CameraToWorld unity_CameraToWorld

struct v2f
{
    float4 pos : SV_POSITION;
    float4 uv : TEXCOORD0;
    half4 color : TEXCOORD1;
    UNITY_FOG_COORDS(2)
    UNITY_VERTEX_OUTPUT_STEREO
};

// What light i sends to a place in view space, and from where in the world.
float3 limn_TreeLight(int i, float3 viewPos, out float3 direction)
{
#ifdef USE_CUSTOM_LIGHT_DIR
    direction = _TerrainTreeLightDirections[i];
    return _TerrainTreeLightColors[i].rgb;
#else
    float3 toLight = unity_LightPosition[i].xyz - viewPos * unity_LightPosition[i].w;
    toLight.z *= -1.0; // unity_CameraToWorld looks along z, view space against it
    direction = mul((float3x3)_CameraToWorld, normalize(toLight));
    return unity_LightColor[i].rgb / (1.0 + dot(toLight, toLight) * unity_LightAtten[i].z);
#endif
}

v2f limn_TreeVertex(inout appdata_tree v)
{
    TerrainAnimateTree(v.vertex, v.color.w);
    v2f o;
    UNITY_INITIALIZE_OUTPUT(v2f, o);
    o.uv = v.texcoord;
    o.pos = UnityObjectToClipPos(v.vertex);
    UNITY_TRANSFER_FOG(o, o.pos);
    return o;
}

v2f leaves(appdata_tree v)
{
    v2f o = limn_TreeVertex(v);
    float3 viewPos = UnityObjectToViewPos(v.vertex.xyz);
    float3 light = UNITY_LIGHTMODEL_AMBIENT.rgb;
    for (int i = 0; i < 4; ++i)
    {
        float3 direction;
        float3 color = limn_TreeLight(i, viewPos, direction);
        float open = dot(v.tangent, float4(direction * _Occlusion, _AO));
        light += color * (max(0.0, open) + _BaseLight);
    }
    o.color = half4(light * _Color.rgb * _TreeInstanceColor.rgb, 0.5 * _HalfOverCutoff);
    return o;
}

v2f bark(appdata_tree v)
{
    v2f o = limn_TreeVertex(v);
    float3 viewPos = UnityObjectToViewPos(v.vertex.xyz);
    float3 light = UNITY_LIGHTMODEL_AMBIENT.rgb;
    for (int i = 0; i < 4; ++i)
    {
        float3 direction;
        float3 color = limn_TreeLight(i, viewPos, direction);
        float open = _AO * v.tangent.w + _BaseLight;
        light += color * (max(0.0, dot(v.normal, direction)) * open);
    }
    o.color = half4(light, 1.0) * _Color * _TreeInstanceColor;
#ifdef WRITE_ALPHA_1
    o.color.a = 1.0;
#endif
    return o;
}

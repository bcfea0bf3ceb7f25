// Depth, and world-space normals of grass in a colour target; those of its flat faces.
#pragma once
#define UNIVERSAL_WAVING_GRASS_DEPTH_NORMAL_PASSE_INCLUDED

struct GrassVertexDepthNormalInput
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    half4 color : COLOR;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};
struct GrassVertexDepthNormalOutput
{
    float2 uv : TEXCOORD0;
    half3 normal : TEXCOORD1;
    half4 color : TEXCOORD2;
    float3 viewDirWS : TEXCOORD3;
    float4 clipPos : SV_POSITION;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

GrassVertexDepthNormalOutput limn_GrassDepthNormal(GrassVertexDepthNormalInput v, float waveAmount)
{
    GrassVertexDepthNormalOutput o = (GrassVertexDepthNormalOutput)0;
    o.color = TerrainWaveGrass(v.vertex, waveAmount, v.color);
    o.normal = TransformObjectToWorldNormal(v.normal);
    o.uv = v.texcoord;
    VertexPositionInputs place = GetVertexPositionInputs(v.vertex.xyz);
    o.clipPos = place.positionCS;
    o.viewDirWS = GetCameraPositionWS() - place.positionWS;
    return o;
}
GrassVertexDepthNormalOutput DepthNormalOnlyVertex(GrassVertexDepthNormalInput v)
{
    return limn_GrassDepthNormal(v, v.color.a * _WaveAndDistance.z);
}
GrassVertexDepthNormalOutput DepthNormalOnlyBillboardVertex(GrassVertexDepthNormalInput v)
{
    TerrainBillboardGrass(v.vertex, v.tangent.xy);
    return limn_GrassDepthNormal(v, v.tangent.y);
}

half4 DepthNormalOnlyFragment(GrassVertexDepthNormalOutput input) : SV_TARGET
{
    float4 texel = SampleAlbedoAlpha(input.uv, TEXTURE2D_ARGS(_MainTex, sampler_MainTex));
    Alpha(texel.a, input.color, _Cutoff);
    return half4(normalize(cross(ddy(input.viewDirWS), ddx(input.viewDirWS))), 0.0);
}

// Particles of the built-in pipeline that are not shaded: their texture, or two frames of it.
#pragma once

half _Cutoff;
sampler2D _MainTex;
float4 _MainTex_ST;

struct VertexInput
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    fixed4 color : COLOR;
#ifdef _FLIPBOOK_BLENDING
    float4 texcoords : TEXCOORD0; // zw: in the next frame
    float texcoordBlend : TEXCOORD1;
#else
    float2 texcoords : TEXCOORD0;
#endif
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

#ifdef _FLIPBOOK_BLENDING
#define limn_FLIPBOOK_COORDS(first, second) \
    float2 texcoord : TEXCOORD##first; \
    float3 texcoord2AndBlend : TEXCOORD##second;
#define limn_TRANSFER_FLIPBOOK(v, o) \
    o.texcoord = v.texcoords.xy; \
    o.texcoord2AndBlend = float3(v.texcoords.zw, v.texcoordBlend);
#define limn_FLIPBOOK_ALPHA(i) \
    (lerp(tex2D(_MainTex, i.texcoord).a, tex2D(_MainTex, i.texcoord2AndBlend.xy).a, \
          i.texcoord2AndBlend.z) * i.color.a)
#else
#define limn_FLIPBOOK_COORDS(first, second) float2 texcoord : TEXCOORD##first;
#define limn_TRANSFER_FLIPBOOK(v, o) o.texcoord = TRANSFORM_TEX(v.texcoords.xy, _MainTex);
#define limn_FLIPBOOK_ALPHA(i) (tex2D(_MainTex, i.texcoord).a * i.color.a)
#endif

#pragma once
#ifndef UNITY_SPRITES_INCLUDED
#define UNITY_SPRITES_INCLUDED
#include "UnityCG.cginc"

CBUFFER_START(UnityPerDrawSprite)
fixed4 _RendererColor;
fixed2 _Flip;
float _EnableExternalAlpha;
CBUFFER_END

fixed4 _Color;
sampler2D _MainTex;
sampler2D _AlphaTex;

struct appdata_t
{
    float4 vertex : POSITION;
    float4 color : COLOR;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct v2f
{
    float4 vertex : SV_POSITION;
    fixed4 color : COLOR;
    float2 texcoord : TEXCOORD0;
    UNITY_VERTEX_OUTPUT_STEREO
};

float4 UnityFlipSprite(float3 pos, fixed2 flip) { return float4(pos.xy * flip, pos.z, 1.0); }

v2f SpriteVert(appdata_t IN)
{
    float4 clipPos = UnityObjectToClipPos(UnityFlipSprite(IN.vertex.xyz, _Flip));
#ifdef PIXELSNAP_ON
    clipPos = UnityPixelSnap(clipPos);
#endif
    v2f OUT;
    UNITY_INITIALIZE_OUTPUT(v2f, OUT);
    OUT.vertex = clipPos;
    OUT.color = _RendererColor * _Color * IN.color;
    OUT.texcoord = IN.texcoord;
    return OUT;
}

fixed4 SampleSpriteTexture(float2 uv)
{
    fixed4 color = tex2D(_MainTex, uv);
#if ETC1_EXTERNAL_ALPHA
    color.a = lerp(color.a, tex2D(_AlphaTex, uv).r, _EnableExternalAlpha);
#endif
    return color;
}

fixed4 SpriteFrag(v2f IN) : SV_Target
{
    fixed4 tinted = IN.color * SampleSpriteTexture(IN.texcoord);
    return fixed4(tinted.rgb * tinted.a, tinted.a);
}
#endif

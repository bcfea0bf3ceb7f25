// Text of the editor's IMGUI from signed distance fields, sharp by how fast the coordinates change on
// the screen.
#pragma once
#include "UnityCG.cginc"
#include "TextCore_Properties.cginc"

#if UNDERLAY_ON || UNDERLAY_INNER
#define limn_HAS_UNDERLAY 1
#endif

// texcoord0.w: 0 or less of bold letters
struct vertex_t
{
    float4 position : POSITION;
    float3 normal : NORMAL;
    float4 color : COLOR;
    float4 texcoord0 : TEXCOORD0;
    float2 texcoord1 : TEXCOORD1;
};

struct pixel_t
{
    float4 position : SV_POSITION;
    float4 faceColor : COLOR;
    float4 outlineColor : COLOR1;
    float2 texcoord0 : TEXCOORD0;
    float4 param : TEXCOORD1; // edge, texels times distance, half the outline's width
    float2 clipUV : TEXCOORD2;
#ifdef limn_HAS_UNDERLAY
    float4 texcoord2 : TEXCOORD3; // z: opacity
    float4 underlayColor : COLOR2;
#endif
};

sampler2D _GUIClipTexture;
float4x4 unity_GUIClipTextureMatrix;
float4 _MainTex_TexelSize;

float4 SRGBToLinear(float4 rgba)
{
    float3 low = rgba.rgb / 12.92;
    float3 high = pow(abs(rgba.rgb + 0.055) / 1.055, 2.4);
    return float4(lerp(low, high, step(0.04045, rgba.rgb)), rgba.a);
}

float4 limn_Premultiplied(float4 color) { return float4(color.rgb * color.a, color.a); }

pixel_t VertShader(vertex_t input)
{
    float4 color = input.color;
#if FORCE_LINEAR && !UNITY_COLORSPACE_GAMMA
    color = SRGBToLinear(color);
#endif
    float4 at = input.position + float4(_VertexOffsetX, _VertexOffsetY, 0, 0);
    float2 eye = UnityObjectToViewPos(input.position.xyz).xy;
    float weight = (input.texcoord0.w > 0 ? _WeightNormal : _WeightBold) / 4.0 + _FaceDilate;

    pixel_t output = (pixel_t)0;
    output.position = UnityObjectToClipPos(at);
    output.clipUV = mul(unity_GUIClipTextureMatrix, float4(eye, 0, 1)).xy;
    output.texcoord0 = input.texcoord0.xy;
    output.param.x = 0.5 - weight * _ScaleRatioA * 0.5;
    output.param.y = 1.3333 * _GradientScale * (1 + _Sharpness) / _MainTex_TexelSize.z;
    output.param.z = _OutlineWidth * _ScaleRatioA * 0.5;
#ifdef limn_HAS_UNDERLAY
    float2 shift = float2(_UnderlayOffsetX, _UnderlayOffsetY) * (_ScaleRatioC * _GradientScale);
    output.texcoord2 = float4(input.texcoord0.xy - shift / _MainTex_TexelSize.zw, color.a, 0);
    output.texcoord2.z = input.color.a;
    output.underlayColor = limn_Premultiplied(_UnderlayColor);
    color.a = 1; // all layers fade together, later
#endif
    output.faceColor = limn_Premultiplied(color * _FaceColor);
    output.outlineColor = limn_Premultiplied(_OutlineColor * float4(1, 1, 1, color.a));
    return output;
}

// How much of a pixel lies inside, where the edge is at `edge`.
float limn_TextCoverage(float distance, float edge, float scale)
{
    return saturate((distance - edge) * scale + 0.5);
}

#ifdef limn_HAS_UNDERLAY
float4 limn_TextUnderlay(pixel_t input, float distance, float scale, float sharp, float seen)
{
    scale /= 1 + _UnderlaySoftness * _ScaleRatioC * scale;
    float edge = input.param.x - _UnderlayDilate * _ScaleRatioC * 0.5;
    float under = limn_TextCoverage(tex2D(_MainTex, input.texcoord2.xy).a, edge, scale);
    float amount = 0;
#if UNDERLAY_ON
    amount += under;
#endif
#if UNDERLAY_INNER
    amount += (1 - under) * saturate((distance - input.param.x) * sharp + 0.5 - input.param.z);
#endif
    return limn_Premultiplied(_UnderlayColor) * (amount * (1 - seen));
}
#endif

float4 PixShader(pixel_t input) : SV_Target
{
    float2 uv = input.texcoord0;
    float distance = tex2D(_MainTex, uv).a;
    float area = abs(determinant(float2x2(ddx(uv), ddy(uv))));
    float scale = rsqrt(area) * input.param.y;
    float sharp = scale / (1 + _OutlineSoftness * _ScaleRatioA * scale);
    float width = input.param.z;

#ifdef OUTLINE_ON
    float4 outline =
        lerp(input.faceColor, input.outlineColor, sqrt(min(1.0, 2 * width * sharp)));
    float4 color = lerp(outline, input.faceColor,
                        limn_TextCoverage(distance, input.param.x + width, sharp));
    color *= limn_TextCoverage(distance, input.param.x - width, sharp);
#else
    float4 color = input.faceColor * limn_TextCoverage(distance, input.param.x, sharp);
#endif
#ifdef limn_HAS_UNDERLAY
    color += limn_TextUnderlay(input, distance, scale, sharp, color.a);
    color *= input.texcoord2.z;
#endif
    return color * tex2D(_GUIClipTexture, input.clipUV).a;
}

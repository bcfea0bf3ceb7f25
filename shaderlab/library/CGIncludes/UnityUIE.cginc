// Shapes, text and pictures of the UI Toolkit, as of Unity 2021 and 2022. Scripts feed it: limn has no
// UI of its own.
#pragma once
#ifndef UNITY_UIE_INCLUDED
#define UNITY_UIE_INCLUDED

#define UIE_SHADER_INFO_IN_VS 1
#define UIE_TEXTURE_SLOT_COUNT 8
#define UIE_FLAT_OPTIM nointerpolation
#ifndef UIE_TEXTURE_SLOT_SIZE
#define UIE_TEXTURE_SLOT_SIZE 1
#endif
#ifndef UIE_COLORSPACE_GAMMA
#define UIE_COLORSPACE_GAMMA 0
#endif
#ifndef UIE_FRAG_SCALAR_T
#define UIE_FRAG_SCALAR_T half
#endif
#ifndef UIE_FRAG_T
#define UIE_FRAG_T half4
#endif
#ifndef UIE_V2F_COLOR_T
#define UIE_V2F_COLOR_T half4
#endif
#ifndef UIE_SKIN_ELEMS_COUNT_MAX_CONSTANTS
#define UIE_SKIN_ELEMS_COUNT_MAX_CONSTANTS 20
#endif

#include "UnityCG.cginc"
#include "UnityUI.cginc"

sampler2D _FontTex;
float4 _FontTex_TexelSize;
float _FontTexSDFScale; // 0: letters are bitmaps
sampler2D _GradientSettingsTex;
float4 _GradientSettingsTex_TexelSize;
sampler2D _ShaderInfoTex; // matrices, rectangles, opacities, colours
float4 _ShaderInfoTex_TexelSize;
float4 _TextureInfo[UIE_TEXTURE_SLOT_COUNT * UIE_TEXTURE_SLOT_SIZE]; // id, size of a texel
sampler2D _Texture0, _Texture1, _Texture2, _Texture3, _Texture4, _Texture5, _Texture6, _Texture7;
float4 _Texture0_ST, _Texture1_ST, _Texture2_ST, _Texture3_ST;
float4 _Texture4_ST, _Texture5_ST, _Texture6_ST, _Texture7_ST;
float4 _ClipSpaceParams; // half width and height in pixels, their inverses

static const float kUIEMeshZ = 0.0;
static const float kUIEMaskZ = 1.0;

// Numbers in bytes: pages and ids say where in _ShaderInfoTex something lies.
struct appdata_t
{
    float4 vertex : POSITION;
    float4 color : COLOR;
    float2 uv : TEXCOORD0;
    float4 xformClipPages : TEXCOORD1;
    float4 ids : TEXCOORD2;   // matrix, rectangle, opacity, colour or text
    float4 flags : TEXCOORD3; // kind, dilation of text, whether round, whether coloured by _ShaderInfoTex
    float4 opacityColorPages : TEXCOORD4;
    float4 circle : TEXCOORD5; // place in the outer circle, in the inner one
    float textureId : TEXCOORD6;
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct v2f
{
    float4 pos : SV_POSITION;
    UIE_V2F_COLOR_T color : COLOR;
    float4 uvClip : TEXCOORD0; // uv, place in the rectangle that clips (-1 to 1)
    UIE_FLAT_OPTIM half4 typeTexSettings : TEXCOORD1; // kind, slot, gradient or opacity, round + 2 coloured
    UIE_FLAT_OPTIM float2 colorUVs : TEXCOORD3;
    half4 circle : TEXCOORD4;
    UNITY_VERTEX_OUTPUT_STEREO
};

#define limn_UIE_SOLID 1
#define limn_UIE_TEXT 2
#define limn_UIE_TEXTURED 3
#define limn_UIE_GRADIENT 4

half3 uie_gamma_to_linear(half3 value) { return UIGammaToLinear(value); }
half3 uie_linear_to_gamma(half3 value)
{
    half3 low = 12.92 * value;
    half3 high = 1.055 * pow(abs(value), 0.4166667) - 0.055;
    return value < (half3)0.0031308 ? low : high;
}

struct TextureInfo
{
    float textureId;
    float2 texelSize;
    float unused;
};
TextureInfo GetTextureInfo(half index)
{
    float4 data = _TextureInfo[(uint)(index * UIE_TEXTURE_SLOT_SIZE)];
    TextureInfo info;
    info.textureId = data.x;
    info.texelSize = data.yz;
    info.unused = data.w;
    return info;
}
// The last slot where none has the texture.
half FindTextureSlot(float textureId)
{
    int slot = 0;
    while (slot < UIE_TEXTURE_SLOT_COUNT - 1 && GetTextureInfo(slot).textureId != textureId)
    {
        ++slot;
    }
    return slot;
}
float4 SampleTextureSlot(half index, float2 uv)
{
    float2 dx = ddx(uv);
    float2 dy = ddy(uv);
    switch ((int)index)
    {
    case 0: return tex2Dgrad(_Texture0, uv, dx, dy);
    case 1: return tex2Dgrad(_Texture1, uv, dx, dy);
    case 2: return tex2Dgrad(_Texture2, uv, dx, dy);
    case 3: return tex2Dgrad(_Texture3, uv, dx, dy);
    case 4: return tex2Dgrad(_Texture4, uv, dx, dy);
    case 5: return tex2Dgrad(_Texture5, uv, dx, dy);
    case 6: return tex2Dgrad(_Texture6, uv, dx, dy);
    default: return tex2Dgrad(_Texture7, uv, dx, dy);
    }
}
float4 SampleShaderInfo(half2 uv) { return tex2Dlod(_ShaderInfoTex, float4(uv, 0, 0)); }
float4 limn_UieInfoAt(float2 texel)
{
    return tex2Dlod(_ShaderInfoTex, float4((texel + 0.5) * _ShaderInfoTex_TexelSize.xy, 0, 0));
}

static float4x4 uie_toWorldMat;

// Letters that are bitmaps stay sharp on whole pixels.
float2 uie_snap_to_integer_pos(float2 clipSpaceXY)
{
    float2 pixel = round((clipSpaceXY + 1) * _ClipSpaceParams.xy + 0.1527);
    return pixel * _ClipSpaceParams.zw - 1;
}
float2 ComputeRelativeClipRectCoords(float2 a, float2 b, float2 pos) { return pos * a + b; }
float uie_fragment_clip(v2f IN)
{
    float2 away = abs(IN.uvClip.zw);
    return max(away.x, away.y) < 1.0001 ? 1.0 : 0.0;
}

// Pages are 32 wide and 8 high; what is stored may take several rows.
float2 uie_decode_shader_info_texel_pos(float2 pageXY, float id, float yStride)
{
    float number = id * 255.0;
    float column = fmod(number, 32.0);
    float row = (number - column) / 32.0;
    return pageXY * 255.0 * float2(32, 8) + float2(column, row * yStride);
}
void uie_vert_load_payload(appdata_t v)
{
    float2 first = uie_decode_shader_info_texel_pos(v.xformClipPages.xy, v.ids.x, 3.0);
    uie_toWorldMat =
        float4x4(limn_UieInfoAt(first), limn_UieInfoAt(first + float2(0, 1)),
                 limn_UieInfoAt(first + float2(0, 2)), float4(0, 0, 0, 1));
}

float2 uie_unpack_float2(fixed4 c) { return float2(c.r, c.b) * 255 + float2(c.g, c.a); }

// Where a ray leaves the unit circle, or enters it from outside.
float2 uie_ray_unit_circle_first_hit(float2 rayStart, float2 rayDir)
{
    float nearest = -dot(rayStart, rayDir);
    float half_ = sqrt(1.0 - dot(rayStart, rayStart) + nearest * nearest);
    return rayStart + rayDir * (nearest < half_ ? nearest + half_ : nearest - half_);
}
// How far from the focus of a radial gradient to its rim.
float uie_radial_address(float2 uv, float2 focus)
{
    float2 from = uv * 2.0 - 1.0 - focus;
    float2 reach = uie_ray_unit_circle_first_hit(focus, normalize(from)) - focus;
    float2 share = from / reach;
    return abs(reach.x) > 0.0001 ? share.x : abs(reach.y) > 0.0001 ? share.y : 0.0;
}

struct GradientLocation
{
    float2 uv;
    float4 location; // place and size in the atlas
};
// Three texels: whether radial, how it goes on, focus; place; size.
GradientLocation uie_sample_gradient_location(float settingIndex, float2 uv, sampler2D settingsTex,
                                              float2 texelSize)
{
    float4 at = float4(float2(0.5, settingIndex + 0.5) * texelSize, 0, 0);
    float4 next = float4(texelSize.x, 0, 0, 0);
    float4 settings = tex2Dlod(settingsTex, at);
    if (settings.x > 0)
    {
        uv = float2(uie_radial_address(uv, settings.zw * 2.0 - 1.0), 0);
    }
    int mode = (int)round(settings.y * 255);
    float folded = fmod(uv.x, 2.0);
    uv.x = mode == 0   ? fmod(uv.x, 1.0)
           : mode == 1 ? saturate(uv.x)
           : mode == 2 ? (folded > 1.0 ? 1.0 - fmod(folded, 1.0) : folded)
                       : uv.x;

    GradientLocation gradient;
    gradient.uv = uv;
    gradient.location.xy = uie_unpack_float2(tex2Dlod(settingsTex, at + next) * 255) + 0.5;
    gradient.location.zw = uie_unpack_float2(tex2Dlod(settingsTex, at + next * 2) * 255);
    return gradient;
}

bool fpEqual(float a, float b) { return a == b; }

// How much of a pixel a letter covers, by its distance field.
float sd_to_coverage(float sd, float2 uv, float sdfSizeRCP, float sdfScale, float isoPerimeter)
{
    float area = abs(determinant(float2x2(ddx(uv), ddy(uv))));
    float texels = (sd - 0.5) * sdfScale + isoPerimeter;
    return saturate(0.5 + 2.0 * texels * rsqrt(area) * sdfSizeRCP);
}
// Of three layers: face, outline, underlay.
float3 sd_to_coverage(float3 sd, float2 uv, float sdfSize, float sdfScale, float3 isoPerimeter,
                      float3 softness)
{
    float3 texels = (sd - 0.5) * sdfScale + isoPerimeter;
    return saturate(0.5 + 2.0 * texels / (sdfSize * fwidth(uv.y) + softness));
}

float4 limn_UiePremultiplied(float4 color, float opacity)
{
    color.a *= opacity;
    return float4(color.rgb * color.a, color.a);
}
// Rows at textCoreUV: colours of face, outline and underlay, then the underlay's place and softness and
// the outline's width.
UIE_FRAG_T uie_textcore(float textAlpha, float2 uv, float2 textCoreUV, float4 vertexColor,
                        half opacity, bool isDynamicColor, float extraDilate)
{
    float4 settings = limn_UieInfoAt(textCoreUV + float2(0, 3)) * _FontTexSDFScale;
    float width = settings.w * 0.25;
    float under = tex2D(_FontTex, uv + settings.xy * _FontTex_TexelSize.x).a;
    float3 covered = sd_to_coverage(float3(textAlpha, textAlpha, under), uv, _FontTex_TexelSize.w,
                                    _FontTexSDFScale, float3(-width, width, 0) + extraDilate,
                                    float3(0, 0, settings.z));
    float4 face = limn_UiePremultiplied(vertexColor, 1.0);
    if (isDynamicColor)
    {
        face = limn_UiePremultiplied(limn_UieInfoAt(textCoreUV), opacity);
    }
    float4 outline = limn_UiePremultiplied(limn_UieInfoAt(textCoreUV + float2(0, 1)), opacity);
    float4 below =
        limn_UiePremultiplied(limn_UieInfoAt(textCoreUV + float2(0, 2)), opacity * covered.z);
    float4 color = face * covered.x +
                   (outline * covered.y + below * (1 - covered.y)) * (1 - covered.x);
    return UIE_FRAG_T(color.rgb / (color.a > 0 ? color.a : 1.0), color.a);
}

void uie_std_vert_shader_info(appdata_t v, out UIE_V2F_COLOR_T color, out float2 clipRectUV,
                              out float2 opacityUV, out float opacity, out float2 colorUV)
{
    float2 texel = _ShaderInfoTex_TexelSize.xy;
    opacityUV =
        (uie_decode_shader_info_texel_pos(v.opacityColorPages.xy, v.ids.z, 1.0) + 0.5) * texel;
    colorUV =
        (uie_decode_shader_info_texel_pos(v.opacityColorPages.zw, v.ids.w, 1.0) + 0.5) * texel;
    clipRectUV =
        (uie_decode_shader_info_texel_pos(v.xformClipPages.zw, v.ids.y, 1.0) + 0.5) * texel;
#if UIE_COLORSPACE_GAMMA
    color = v.color;
#else
    color = UIE_V2F_COLOR_T(uie_gamma_to_linear(v.color.rgb), v.color.a);
#endif
    if (v.flags.w > 0)
    {
        color = SampleShaderInfo(colorUV);
    }
    opacity = SampleShaderInfo(opacityUV).a;
    color.a *= opacity;
}

// From the rim of a circle, in pixels.
float pixelDist(float2 uv)
{
    float beyond = length(uv) - 1.0;
    return beyond / fwidth(beyond);
}
// Between two circles; one that starts below -9999 is not there.
float ComputeCoverage(float2 outer, float2 inner)
{
    float within = saturate(0.5 - pixelDist(outer));
    float without = saturate(0.5 + pixelDist(inner));
    return (outer.x > -9999.0 ? within : 1.0) * (inner.x > -9999.0 ? without : 1.0);
}

v2f uie_std_vert(appdata_t v)
{
    v2f OUT = (v2f)0;
    UNITY_SETUP_INSTANCE_ID(v);
    uie_vert_load_payload(v);
    int kind = (int)round(v.flags.x * 255.0);
    bool isText = kind == 1;
    bool isDynamic = kind == 3; // its uv are texels

    v.vertex.xyz = mul(uie_toWorldMat, v.vertex).xyz;
    OUT.pos = UnityObjectToClipPos(v.vertex);
    if (isText && _FontTexSDFScale == 0)
    {
        OUT.pos.xy = uie_snap_to_integer_pos(OUT.pos.xy);
    }

    half slot = FindTextureSlot(v.textureId);
    OUT.uvClip.xy = v.uv * (isDynamic ? GetTextureInfo(slot).texelSize : float2(1, 1));
    float opacity;
    float2 clipRect, opacityUV;
    uie_std_vert_shader_info(v, OUT.color, clipRect, opacityUV, opacity, OUT.colorUVs);
    if (isText)
    {
        OUT.colorUVs = uie_decode_shader_info_texel_pos(v.opacityColorPages.zw, v.ids.w, 4.0);
    }
    float4 clipping = SampleShaderInfo(clipRect);
    OUT.uvClip.zw = ComputeRelativeClipRectCoords(clipping.xy, clipping.zw, v.vertex.xy);

    half drawn = isText               ? limn_UIE_TEXT
                 : isDynamic || kind == 2 ? limn_UIE_TEXTURED
                 : kind == 4            ? limn_UIE_GRADIENT
                                        : limn_UIE_SOLID;
    float setting = dot(v.opacityColorPages.zw, float2(255.0 * 255.0, 255.0));
    OUT.typeTexSettings = half4(drawn, slot, isText ? opacity : setting,
                                (v.flags.z > 0 ? 1.0 : 0.0) + (v.flags.w > 0 ? 2.0 : 0.0));
    OUT.circle = half4(isText ? v.flags.y : v.circle.x, v.circle.yzw);
    return OUT;
}

UIE_FRAG_T limn_UieText(v2f IN, bool isDynamicColor)
{
    float alpha = tex2D(_FontTex, IN.uvClip.xy).a;
    if (_FontTexSDFScale > 0)
    {
        return uie_textcore(alpha, IN.uvClip.xy, IN.colorUVs, IN.color, IN.typeTexSettings.z,
                            isDynamicColor, IN.circle.x);
    }
    return IN.color * UIE_FRAG_T(1, 1, 1, alpha);
}
UIE_FRAG_T limn_UieGradient(v2f IN)
{
    GradientLocation gradient =
        uie_sample_gradient_location(IN.typeTexSettings.z, IN.uvClip.xy, _GradientSettingsTex,
                                     _GradientSettingsTex_TexelSize.xy);
    gradient.location *= GetTextureInfo(IN.typeTexSettings.y).texelSize.xyxy;
    float2 uv = gradient.uv * gradient.location.zw + gradient.location.xy;
    return SampleTextureSlot(IN.typeTexSettings.y, uv) * IN.color;
}

UIE_FRAG_T uie_std_frag(v2f IN)
{
    int drawn = (int)IN.typeTexSettings.x;
    bool isDynamicColor = IN.typeTexSettings.w >= 2.0;
    bool isRound = IN.typeTexSettings.w - (isDynamicColor ? 2.0 : 0.0) > 0;

    UIE_FRAG_T color = IN.color;
    if (drawn == limn_UIE_TEXT)
    {
        color = limn_UieText(IN, isDynamicColor);
    }
    else if (drawn == limn_UIE_GRADIENT)
    {
        color = limn_UieGradient(IN);
    }
    else if (drawn == limn_UIE_TEXTURED)
    {
        color *= SampleTextureSlot(IN.typeTexSettings.y, IN.uvClip.xy);
    }
    bool isShape = drawn == limn_UIE_SOLID || drawn == limn_UIE_TEXTURED;
    float coverage = isRound && isShape ? ComputeCoverage(IN.circle.xy, IN.circle.zw) : 1.0;
    coverage *= uie_fragment_clip(IN);
    clip(coverage - 0.003);
    color.a *= coverage;
    return color;
}

#ifndef UIE_CUSTOM_SHADER
v2f vert(appdata_t v) { return uie_std_vert(v); }
UIE_FRAG_T frag(v2f IN) : SV_Target { return uie_std_frag(IN); }
#endif
#endif

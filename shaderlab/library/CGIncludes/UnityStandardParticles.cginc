// The vertex and fragment functions of Particles/Standard Unlit, and the parts that shaders which
// vary it use. Each macro works on `albedo`, as Unity's do; the keywords are those of Unity's material.
#pragma once
#ifndef UNITY_STANDARD_PARTICLES_INCLUDED
#define UNITY_STANDARD_PARTICLES_INCLUDED
#include "UnityPBSLighting.cginc"
#include "UnityStandardParticleInstancing.cginc"

#if defined(_REQUIRE_UV2) && !defined(_FLIPBOOK_BLENDING)
#define _FLIPBOOK_BLENDING 1
#endif
#if defined(EFFECT_BUMP) && !defined(_DISTORTION_ON)
#define _DISTORTION_ON 1
#endif
#if defined(SOFTPARTICLES_ON) || defined(_FADING_ON)
#define limn_ParticleFading 1
#endif

struct appdata_particles
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float4 color : COLOR;
#ifdef _FLIPBOOK_BLENDING
    float4 texcoords : TEXCOORD0; // zw: in the next frame
    float texcoordBlend : TEXCOORD1;
#else
    float2 texcoords : TEXCOORD0;
#endif
#ifdef _NORMALMAP
    float4 tangent : TANGENT;
#endif
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct VertexOutput
{
    float4 vertex : SV_POSITION;
    float4 color : COLOR;
    UNITY_FOG_COORDS(0)
    float2 texcoord : TEXCOORD1;
#ifdef _FLIPBOOK_BLENDING
    float3 texcoord2AndBlend : TEXCOORD2;
#endif
#ifdef limn_ParticleFading
    float4 projectedPosition : TEXCOORD3; // z: distance along the view axis
#endif
#ifdef _DISTORTION_ON
    float4 grabPassPosition : TEXCOORD4;
#endif
    UNITY_VERTEX_OUTPUT_STEREO
};

sampler2D _MainTex;
float4 _MainTex_ST;
half4 _Color;
sampler2D _BumpMap;
half _BumpScale;
sampler2D _EmissionMap;
half3 _EmissionColor;
sampler2D _MetallicGlossMap;
half _Metallic;
half _Glossiness;
UNITY_DECLARE_DEPTH_TEXTURE(_CameraDepthTexture);
float4 _SoftParticleFadeParams; // distance before a surface where fading ends, 1 / length of it
float4 _CameraFadeParams;       // the same before the camera
half _Cutoff;
#define SOFT_PARTICLE_NEAR_FADE _SoftParticleFadeParams.x
#define SOFT_PARTICLE_INV_FADE_DISTANCE _SoftParticleFadeParams.y
#define CAMERA_NEAR_FADE _CameraFadeParams.x
#define CAMERA_INV_FADE_DISTANCE _CameraFadeParams.y
#ifdef _DISTORTION_ON
sampler2D _GrabTexture;
half _DistortionStrengthScaled;
half _DistortionBlend;
#endif
#ifdef _COLORADDSUBDIFF_ON
half4 _ColorAddSubDiff; // x: 1 adds, -1 subtracts; y: 1 takes the difference
#endif

// A texture at the frame of the flipbook, or between two.
fixed4 readTexture(sampler2D tex, VertexOutput IN)
{
    fixed4 color = tex2D(tex, IN.texcoord);
#ifdef _FLIPBOOK_BLENDING
    color = lerp(color, tex2D(tex, IN.texcoord2AndBlend.xy), IN.texcoord2AndBlend.z);
#endif
    return color;
}

#ifdef _COLORCOLOR_ON
// Hue in 0...1, saturation, value.
half3 RGBtoHSV(half3 c)
{
    float high = max(c.r, max(c.g, c.b));
    float range = high - min(c.r, min(c.g, c.b));
    float3 apart = (c.gbr - c.brg) / (6.0 * range + 1e-10);
    float hue = high == c.r ? apart.r : high == c.g ? apart.g + 1.0 / 3.0 : apart.b + 2.0 / 3.0;
    return half3(frac(hue), range / (high + 1e-10), high);
}
half3 HSVtoRGB(half3 c)
{
    float3 wheel = abs(frac(c.x + float3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0);
    return c.z * lerp(1.0, saturate(wheel - 1.0), c.y);
}
#endif

// Vertex: `v` is the input, clipPosition where it comes to lie.
#ifdef _FLIPBOOK_BLENDING
#define vertTexcoord(v, o) \
    o.texcoord = v.texcoords.xy; \
    o.texcoord2AndBlend = float3(v.texcoords.zw, v.texcoordBlend);
#else
#define vertTexcoord(v, o) o.texcoord = TRANSFORM_TEX(v.texcoords.xy, _MainTex);
#endif
#ifdef limn_ParticleFading
#define vertFading(o) \
    o.projectedPosition = ComputeScreenPos(clipPosition); \
    COMPUTE_EYEDEPTH(o.projectedPosition.z);
#else
#define vertFading(o)
#endif
#ifdef _DISTORTION_ON
#define vertDistortion(o) o.grabPassPosition = ComputeGrabScreenPos(clipPosition);
#else
#define vertDistortion(o)
#endif

// Fragment: the particle's colour over the texture's.
half3 limn_ParticleOverlay(half3 base, half3 blend)
{
    return lerp(1.0 - 2.0 * (1.0 - base) * (1.0 - blend), 2.0 * base * blend, step(base, 0.5));
}
#if defined(_COLOROVERLAY_ON)
#define fragColorMode(i) \
    albedo = half4(limn_ParticleOverlay(albedo.rgb, i.color.rgb), albedo.a * i.color.a);
#elif defined(_COLORCOLOR_ON)
half3 limn_ParticleTint(half3 base, half3 tint)
{
    return HSVtoRGB(half3(RGBtoHSV(tint).xy, RGBtoHSV(base).z));
}
#define fragColorMode(i) \
    albedo = half4(limn_ParticleTint(albedo.rgb, i.color.rgb), albedo.a * i.color.a);
#elif defined(_COLORADDSUBDIFF_ON)
half3 limn_ParticleSum(half3 base, half3 blend)
{
    half3 sum = base + blend * _ColorAddSubDiff.x;
    return lerp(sum, abs(sum), _ColorAddSubDiff.y);
}
#define fragColorMode(i) \
    albedo = half4(limn_ParticleSum(albedo.rgb, i.color.rgb), albedo.a * i.color.a);
#else
#define fragColorMode(i) albedo *= i.color;
#endif

#ifdef _ALPHAPREMULTIPLY_ON
#define ALBEDO_MUL albedo
#else
#define ALBEDO_MUL albedo.a
#endif

// 1 where a particle is far before what the depth texture holds, 0 where it meets it.
float limn_SoftParticleFade(float sceneZ, float particleZ)
{
    if (SOFT_PARTICLE_NEAR_FADE <= 0.0 && SOFT_PARTICLE_INV_FADE_DISTANCE <= 0.0)
    {
        return 1.0;
    }
    return saturate(SOFT_PARTICLE_INV_FADE_DISTANCE *
                    (sceneZ - SOFT_PARTICLE_NEAR_FADE - particleZ));
}
float limn_CameraFade(float particleZ)
{
    return saturate((particleZ - CAMERA_NEAR_FADE) * CAMERA_INV_FADE_DISTANCE);
}
#if defined(SOFTPARTICLES_ON) && defined(_FADING_ON)
#define fragSoftParticles(i) \
    ALBEDO_MUL *= limn_SoftParticleFade( \
        LinearEyeDepth(SAMPLE_DEPTH_TEXTURE_PROJ(_CameraDepthTexture, i.projectedPosition)), \
        i.projectedPosition.z);
#else
#define fragSoftParticles(i)
#endif
#ifdef _FADING_ON
#define fragCameraFading(i) ALBEDO_MUL *= limn_CameraFade(i.projectedPosition.z);
#else
#define fragCameraFading(i)
#endif

// `normal` shifts what is seen through the particle.
#ifdef _DISTORTION_ON
half3 limn_ParticleGrab(float4 position, half2 normal, half alpha)
{
    position.xy += normal * _DistortionStrengthScaled * alpha;
    return tex2Dproj(_GrabTexture, position).rgb;
}
#define fragDistortion(i) \
    albedo.rgb = lerp(limn_ParticleGrab(i.grabPassPosition, normal.xy, albedo.a), albedo.rgb, \
                      saturate(albedo.a - _DistortionBlend));
#else
#define fragDistortion(i)
#endif

void vertParticleUnlit(appdata_particles v, out VertexOutput o)
{
    float4 clipPosition = UnityObjectToClipPos(v.vertex); // the macros below read it
    UNITY_INITIALIZE_OUTPUT(VertexOutput, o);
    o.color = v.color;
    o.vertex = clipPosition;
    vertTexcoord(v, o)
    vertFading(o)
    vertDistortion(o)
    UNITY_TRANSFER_FOG(o, o.vertex);
}

half4 fragParticleUnlit(VertexOutput IN) : SV_Target
{
    half4 albedo = readTexture(_MainTex, IN) * _Color;
    fragColorMode(IN)
    fragSoftParticles(IN)
    fragCameraFading(IN)

    half3 normal = half3(0, 0, 1);
#ifdef _NORMALMAP
    normal = normalize(UnpackScaleNormal(readTexture(_BumpMap, IN), _BumpScale));
#endif
    fragDistortion(IN)

#if defined(_ALPHABLEND_ON) || defined(_ALPHAPREMULTIPLY_ON) || defined(_ALPHAOVERLAY_ON)
    half4 result = albedo;
#else
    half4 result = half4(albedo.rgb, 1.0);
#endif
#ifdef _ALPHAMODULATE_ON
    result.rgb = lerp(half3(1, 1, 1), albedo.rgb, albedo.a);
#endif
#ifdef _EMISSION
    result.rgb += readTexture(_EmissionMap, IN).rgb * _EmissionColor;
#endif
    UNITY_APPLY_FOG_COLOR(IN.fogCoord, result, fixed4(0, 0, 0, 0));
#ifdef _ALPHATEST_ON
    clip(albedo.a - _Cutoff + 0.0001);
#endif
    return result;
}
#endif

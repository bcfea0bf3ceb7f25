// A particle's colour out of its texture, and how it fades; behind the properties of its material.
// limn_ParticleIsUnlit: what is transparent is multiplied here, not by the lighting.
#pragma once
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Particles.hlsl"

#define SOFT_PARTICLE_NEAR_FADE _SoftParticleFadeParams.x
#define SOFT_PARTICLE_INV_FADE_DISTANCE _SoftParticleFadeParams.y
#define CAMERA_NEAR_FADE _CameraFadeParams.x
#define CAMERA_INV_FADE_DISTANCE _CameraFadeParams.y

half4 limn_ParticleAlbedo(half4 texel, half4 particleColor)
{
    half4 albedo = MixParticleColor(texel, particleColor, _BaseColorAddSubDiff);
    albedo.a = AlphaDiscard(albedo.a, _Cutoff);
#ifdef limn_ParticleIsUnlit
    albedo.rgb = AlphaModulateAndPremultiply(albedo.rgb, albedo.a);
#endif
    return albedo;
}
half4 limn_ParticleFaded(half4 albedo, float soft, float camera)
{
#if defined(_SOFTPARTICLES_ON) && defined(limn_ParticleIsUnlit)
    albedo = SOFT_PARTICLE_MUL_ALBEDO(albedo, soft);
#elif defined(_SOFTPARTICLES_ON)
    ALBEDO_MUL *= soft;
#endif
#ifdef _FADING_ON
    ALBEDO_MUL *= camera;
#endif
    return albedo;
}

half4 SampleAlbedo(float2 uv, float3 blendUv, half4 color, float4 particleColor,
                   float4 projectedPosition, TEXTURE2D_PARAM(albedoMap, sampler_albedoMap))
{
    half4 texel = BlendTexture(TEXTURE2D_ARGS(albedoMap, sampler_albedoMap), uv, blendUv);
    half4 albedo = limn_ParticleAlbedo(texel * color, particleColor);
    float soft = 1.0;
    float camera = 1.0;
#ifdef _SOFTPARTICLES_ON
    soft = SoftParticles(SOFT_PARTICLE_NEAR_FADE, SOFT_PARTICLE_INV_FADE_DISTANCE,
                         projectedPosition);
#endif
#ifdef _FADING_ON
    camera = CameraFade(CAMERA_NEAR_FADE, CAMERA_INV_FADE_DISTANCE, projectedPosition);
#endif
    return limn_ParticleFaded(albedo, soft, camera);
}
half4 SampleAlbedo(TEXTURE2D_PARAM(albedoMap, sampler_albedoMap), ParticleParams params)
{
    half4 texel =
        BlendTexture(TEXTURE2D_ARGS(albedoMap, sampler_albedoMap), params.uv, params.blendUv);
    half4 albedo = limn_ParticleAlbedo(texel * params.baseColor, params.vertexColor);
    float soft = 1.0;
    float camera = 1.0;
#ifdef _SOFTPARTICLES_ON
    soft = SoftParticles(SOFT_PARTICLE_NEAR_FADE, SOFT_PARTICLE_INV_FADE_DISTANCE, params);
#endif
#ifdef _FADING_ON
    camera = CameraFade(CAMERA_NEAR_FADE, CAMERA_INV_FADE_DISTANCE, params.projectedPosition);
#endif
    return limn_ParticleFaded(albedo, soft, camera);
}

float3 limn_ParticleEmission(ParticleParams params)
{
#ifdef _EMISSION
    float2 uv = params.uv;
    float3 blendUv = params.blendUv;
    float4 glow = BlendTexture(TEXTURE2D_ARGS(_EmissionMap, sampler_EmissionMap), uv, blendUv);
    return _EmissionColor.rgb * glow.rgb;
#else
    return float3(0, 0, 0);
#endif
}
float3 limn_ParticleDistorted(float4 albedo, float3 normalTS, ParticleParams params)
{
#ifdef _DISTORTION_ON
    return Distortion(albedo, normalTS, _DistortionStrengthScaled, _DistortionBlend,
                      params.projectedPosition);
#else
    return albedo.rgb;
#endif
}

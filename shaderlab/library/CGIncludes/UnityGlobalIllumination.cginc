// Light that does not come straight from a lamp. Without reflection probes and light maps it is the
// ambient light, from all sides alike.
#pragma once
#ifndef UNITY_GLOBAL_ILLUMINATION_INCLUDED
#define UNITY_GLOBAL_ILLUMINATION_INCLUDED
#include "UnityImageBasedLighting.cginc"
#include "UnityStandardUtils.cginc"
#include "UnityShadowLibrary.cginc"

#if !defined(LIGHTMAP_ON) && !defined(UNITY_PASS_FORWARDADD) && \
    !defined(UNITY_PASS_SHADOWCASTER) && !defined(UNITY_PASS_META)
#define UNITY_SHOULD_SAMPLE_SH 1
#else
#define UNITY_SHOULD_SAMPLE_SH 0
#endif

void ResetUnityLight(out UnityLight outLight)
{
    outLight.dir = half3(0, 1, 0); // of unit length, though nothing shines
    outLight.color = 0;
    outLight.ndotl = 0;
}
void ResetUnityGI(out UnityGI outGI)
{
    ResetUnityLight(outGI.light);
    outGI.indirect.diffuse = half3(0, 0, 0);
    outGI.indirect.specular = half3(0, 0, 0);
}

half3 SubtractMainLightWithRealtimeAttenuationFromLightmap(half3 lightmap, half attenuation,
                                                           half4 bakedColorTex, half3 normalWorld)
{
    half3 shadowed = _LightColor0.rgb * (LambertTerm(normalWorld, _WorldSpaceLightPos0.xyz) *
                                         (1.0 - attenuation));
    half3 darkest = max(lightmap - shadowed, unity_ShadowColor.rgb);
    return min(lightmap, lerp(darkest, lightmap, _LightShadowData.x));
}

UnityGI UnityGI_Base(UnityGIInput data, half occlusion, half3 normalWorld)
{
    UnityGI gi;
    ResetUnityGI(gi);
    gi.light = data.light;
    gi.light.color *= data.atten;
#if UNITY_SHOULD_SAMPLE_SH
    gi.indirect.diffuse = ShadeSHPerPixel(normalWorld, data.ambient, data.worldPos);
#endif
#if defined(LIGHTMAP_ON)
    gi.indirect.diffuse +=
        DecodeLightmap(UNITY_SAMPLE_TEX2D(unity_Lightmap, data.lightmapUV.xy), unity_Lightmap_HDR);
#endif
    gi.indirect.diffuse *= occlusion;
    return gi;
}

#if !defined(_GLOSSYREFLECTIONS_OFF) // without probes it is this colour anywhere
[limn_Lacks("reflection probes", "unity_IndirectSpecColor is what is reflected")]
#endif
half3 UnityGI_IndirectSpecular(UnityGIInput data, half occlusion,
                               Unity_GlossyEnvironmentData glossIn)
{
    return unity_IndirectSpecColor.rgb * occlusion;
}
half3 UnityGI_IndirectSpecular(UnityGIInput data, half occlusion, half3 normalWorld,
                               Unity_GlossyEnvironmentData glossIn)
{
    return UnityGI_IndirectSpecular(data, occlusion, glossIn);
}

UnityGI UnityGlobalIllumination(UnityGIInput data, half occlusion, half3 normalWorld)
{
    return UnityGI_Base(data, occlusion, normalWorld);
}
UnityGI UnityGlobalIllumination(UnityGIInput data, half occlusion, half3 normalWorld,
                                Unity_GlossyEnvironmentData glossIn)
{
    UnityGI gi = UnityGI_Base(data, occlusion, normalWorld);
    gi.indirect.specular = UnityGI_IndirectSpecular(data, occlusion, glossIn);
    return gi;
}
UnityGI UnityGlobalIllumination(UnityGIInput data, half occlusion, half smoothness,
                                half3 normalWorld, bool reflections)
{
    Unity_GlossyEnvironmentData g =
        UnityGlossyEnvironmentSetup(smoothness, data.worldViewDir, normalWorld, half3(0, 0, 0));
    if (reflections)
    {
        return UnityGlobalIllumination(data, occlusion, normalWorld, g);
    }
    return UnityGlobalIllumination(data, occlusion, normalWorld);
}
UnityGI UnityGlobalIllumination(UnityGIInput data, half occlusion, half smoothness,
                                half3 normalWorld)
{
    return UnityGlobalIllumination(data, occlusion, smoothness, normalWorld, true);
}
#endif

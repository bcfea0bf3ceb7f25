#pragma once
#ifndef LIGHTING_INCLUDED
#define LIGHTING_INCLUDED
#include "UnityLightingCommon.cginc"
#include "UnityGBuffer.cginc"
#include "UnityGlobalIllumination.cginc"

struct SurfaceOutput
{
    fixed3 Albedo;
    fixed3 Normal;
    fixed3 Emission;
    half Specular; // exponent of the highlight over 128
    fixed Gloss;   // strength of the highlight
    fixed Alpha;
};

fixed4 UnityLambertLight(SurfaceOutput s, UnityLight light)
{
    fixed diff = max(0, dot(s.Normal, light.dir));
    return fixed4(s.Albedo * light.color * diff, s.Alpha);
}
// What the surface scatters of the light around it.
half3 limn_ReflectedAmbient(SurfaceOutput s, UnityGI gi)
{
#if UNITY_SHOULD_SAMPLE_SH
    return s.Albedo * gi.indirect.diffuse;
#else
    return half3(0, 0, 0);
#endif
}
fixed4 LightingLambert(SurfaceOutput s, UnityGI gi)
{
    fixed4 direct = UnityLambertLight(s, gi.light);
    return fixed4(direct.rgb + limn_ReflectedAmbient(s, gi), direct.a);
}
half3 limn_EmittedAndAmbient(SurfaceOutput s, UnityGI gi)
{
    return s.Emission + limn_ReflectedAmbient(s, gi);
}
half4 LightingLambert_Deferred(SurfaceOutput s, UnityGI gi, out half4 outGBuffer0,
                               out half4 outGBuffer1, out half4 outGBuffer2)
{
    UnityStandardDataToGbuffer(limn_StandardData(s.Albedo, 1, 0, 0, s.Normal), outGBuffer0,
                               outGBuffer1, outGBuffer2);
    return half4(limn_EmittedAndAmbient(s, gi), 1);
}
fixed4 LightingLambert_PrePass(SurfaceOutput s, half4 light)
{
    return fixed4(s.Albedo * light.rgb, s.Alpha);
}
void LightingLambert_GI(SurfaceOutput s, UnityGIInput data, inout UnityGI gi)
{
    gi = UnityGlobalIllumination(data, 1.0, s.Normal);
}

fixed4 UnityBlinnPhongLight(SurfaceOutput s, half3 viewDir, UnityLight light)
{
    float cosine = max(0, dot(normalize(viewDir + light.dir), s.Normal));
    half3 highlight = _SpecColor.rgb * (s.Gloss * pow(cosine, 128.0 * s.Specular));
    half3 matte = s.Albedo * max(0, dot(light.dir, s.Normal));
    return fixed4((matte + highlight) * light.color, s.Alpha);
}
fixed4 LightingBlinnPhong(SurfaceOutput s, half3 viewDir, UnityGI gi)
{
    fixed4 direct = UnityBlinnPhongLight(s, viewDir, gi.light);
    return fixed4(direct.rgb + limn_ReflectedAmbient(s, gi), direct.a);
}
half4 LightingBlinnPhong_Deferred(SurfaceOutput s, half3 viewDir, UnityGI gi,
                                  out half4 outGBuffer0, out half4 outGBuffer1,
                                  out half4 outGBuffer2)
{
    half3 specular = _SpecColor.rgb * s.Gloss * (1 / UNITY_PI);
    UnityStandardDataToGbuffer(limn_StandardData(s.Albedo, 1, specular, s.Specular, s.Normal),
                               outGBuffer0, outGBuffer1, outGBuffer2);
    return half4(limn_EmittedAndAmbient(s, gi), 1);
}
fixed4 LightingBlinnPhong_PrePass(SurfaceOutput s, half4 light)
{
    fixed3 highlight = light.rgb * _SpecColor.rgb * (light.a * s.Gloss);
    return fixed4(s.Albedo * light.rgb + highlight, s.Alpha);
}
void LightingBlinnPhong_GI(SurfaceOutput s, UnityGIInput data, inout UnityGI gi)
{
    gi = UnityGlobalIllumination(data, 1.0, s.Normal);
}
#endif

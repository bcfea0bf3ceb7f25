#pragma once
#define LIGHTING_INCLUDED
#include "UnityLightingCommon.cginc"
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
fixed4 LightingLambert(SurfaceOutput s, UnityGI gi)
{
    fixed4 c = UnityLambertLight(s, gi.light);
#if UNITY_SHOULD_SAMPLE_SH
    c.rgb += s.Albedo * gi.indirect.diffuse;
#endif
    return c;
}
void LightingLambert_GI(SurfaceOutput s, UnityGIInput data, inout UnityGI gi)
{
    gi = UnityGlobalIllumination(data, 1.0, s.Normal);
}

fixed4 UnityBlinnPhongLight(SurfaceOutput s, half3 viewDir, UnityLight light)
{
    half3 h = normalize(light.dir + viewDir);
    fixed diff = max(0, dot(s.Normal, light.dir));
    float spec = pow(max(0, dot(s.Normal, h)), s.Specular * 128.0) * s.Gloss;
    return fixed4(s.Albedo * light.color * diff + light.color * _SpecColor.rgb * spec, s.Alpha);
}
fixed4 LightingBlinnPhong(SurfaceOutput s, half3 viewDir, UnityGI gi)
{
    fixed4 c = UnityBlinnPhongLight(s, viewDir, gi.light);
#if UNITY_SHOULD_SAMPLE_SH
    c.rgb += s.Albedo * gi.indirect.diffuse;
#endif
    return c;
}
void LightingBlinnPhong_GI(SurfaceOutput s, UnityGIInput data, inout UnityGI gi)
{
    gi = UnityGlobalIllumination(data, 1.0, s.Normal);
}

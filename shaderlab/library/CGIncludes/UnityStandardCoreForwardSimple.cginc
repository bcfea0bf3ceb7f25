// The Standard shader on weak devices: its cheapest reflection model. Unity evaluates Fresnel and the
// mirrored view per vertex, limn per pixel.
#pragma once
#define UNITY_STANDARD_CORE_FORWARD_SIMPLE_INCLUDED
#include "UnityStandardCore.cginc"

#define VertexOutputBaseSimple VertexOutputForwardBase
#define VertexOutputForwardAddSimple VertexOutputForwardBase

half MetallicSetup_Reflectivity() { return 1.0 - OneMinusReflectivityFromMetallic(_Metallic); }
half RoughnessSetup_Reflectivity() { return MetallicSetup_Reflectivity(); }
half SpecularSetup_Reflectivity() { return SpecularStrength(_SpecColor.rgb); }

VertexOutputForwardBase vertForwardBaseSimple(VertexInput v) { return vertForwardBase(v); }
half4 fragForwardBaseSimpleInternal(VertexOutputForwardBase i)
{
    FRAGMENT_SETUP(s)
    UNITY_LIGHT_ATTENUATION(atten, i, s.posWorld);
    UnityGI gi =
        FragmentGI(s, Occlusion(i.tex.xy), i.ambientOrLightmapUV, atten, MainLight());
    half4 c = BRDF3_Unity_PBS(s.diffColor, s.specColor, s.oneMinusReflectivity, s.smoothness,
                              s.normalWorld, -s.eyeVec, gi.light, gi.indirect);
    c.rgb += Emission(i.tex.xy);
    UNITY_EXTRACT_FOG_FROM_EYE_VEC(i);
    UNITY_APPLY_FOG(_unity_fogCoord, c);
    return OutputForward(c, s.alpha);
}
half4 fragForwardBaseSimple(VertexOutputForwardBase i) : SV_Target
{
    return fragForwardBaseSimpleInternal(i);
}

VertexOutputForwardBase vertForwardAddSimple(VertexInput v) { return vertForwardBase(v); }
half4 fragForwardAddSimpleInternal(VertexOutputForwardBase i)
{
    FRAGMENT_SETUP(s)
    UNITY_LIGHT_ATTENUATION(atten, i, s.posWorld);
    UnityLight light = AdditiveLight(UnityWorldSpaceLightDir(s.posWorld), atten);
    half4 c = BRDF3_Unity_PBS(s.diffColor, s.specColor, s.oneMinusReflectivity, s.smoothness,
                              s.normalWorld, -s.eyeVec, light, ZeroIndirect());
    UNITY_EXTRACT_FOG_FROM_EYE_VEC(i);
    UNITY_APPLY_FOG_COLOR(_unity_fogCoord, c, half4(0, 0, 0, 0));
    return OutputForward(c, s.alpha);
}
half4 fragForwardAddSimple(VertexOutputForwardBase i) : SV_Target
{
    return fragForwardAddSimpleInternal(i);
}

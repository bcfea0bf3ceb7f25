// The Standard shader's forward passes: main light, ambient light, emission, fog; one pass per
// further light; and its deferred pass.
#pragma once
#ifndef UNITY_STANDARD_CORE_INCLUDED
#define UNITY_STANDARD_CORE_INCLUDED
#include "UnityCG.cginc"
#include "UnityShaderVariables.cginc"
#include "UnityStandardConfig.cginc"
#include "UnityStandardInput.cginc"
#include "UnityPBSLighting.cginc"
#include "UnityStandardUtils.cginc"
#include "UnityGBuffer.cginc"
#include "UnityStandardBRDF.cginc"
#include "AutoLight.cginc"

#ifndef UNITY_SETUP_BRDF_INPUT
#define UNITY_SETUP_BRDF_INPUT SpecularSetup
#endif
#ifndef UNITY_REQUIRE_FRAG_WORLDPOS
#define UNITY_REQUIRE_FRAG_WORLDPOS 1
#endif

struct FragmentCommonData
{
    half3 diffColor;
    half3 specColor;
    half oneMinusReflectivity;
    half smoothness;
    float3 normalWorld;
    float3 eyeVec; // from the camera
    half alpha;
    float3 posWorld;
};

half3 NormalizePerVertexNormal(float3 n) { return normalize(n); }
float3 NormalizePerPixelNormal(float3 n) { return normalize(n); }

UnityLight MainLight()
{
    UnityLight light;
    light.color = _LightColor0.rgb;
    light.dir = _WorldSpaceLightPos0.xyz;
    light.ndotl = 0;
    return light;
}
UnityLight AdditiveLight(half3 lightDir, half atten)
{
    UnityLight light;
    light.color = _LightColor0.rgb * atten;
    light.dir = normalize(lightDir);
    light.ndotl = 0;
    return light;
}
UnityLight DummyLight()
{
    UnityLight light;
    ResetUnityLight(light);
    return light;
}
UnityIndirect ZeroIndirect()
{
    UnityIndirect indirect;
    indirect.diffuse = half3(0, 0, 0);
    indirect.specular = half3(0, 0, 0);
    return indirect;
}

FragmentCommonData SpecularSetup(float4 uv)
{
    half4 specGloss = SpecularGloss(uv.xy);
    FragmentCommonData o = (FragmentCommonData)0;
    o.specColor = specGloss.rgb;
    o.smoothness = specGloss.a;
    o.diffColor = EnergyConservationBetweenDiffuseAndSpecular(Albedo(uv), o.specColor,
                                                              o.oneMinusReflectivity);
    return o;
}
FragmentCommonData limn_MetallicSetup(float4 uv, half metallic, half smoothness)
{
    FragmentCommonData o = (FragmentCommonData)0;
    o.smoothness = smoothness;
    o.diffColor =
        DiffuseAndSpecularFromMetallic(Albedo(uv), metallic, o.specColor, o.oneMinusReflectivity);
    return o;
}
FragmentCommonData MetallicSetup(float4 uv)
{
    half2 metallicGloss = MetallicGloss(uv.xy);
    return limn_MetallicSetup(uv, metallicGloss.x, metallicGloss.y);
}
FragmentCommonData RoughnessSetup(float4 uv)
{
    half2 metallicRough = MetallicRough(uv.xy);
    return limn_MetallicSetup(uv, metallicRough.x, 1.0 - metallicRough.y);
}

// One interface for all variants: the rows of tangentToWorld are there whether a map needs them or
// not.
struct VertexOutputForwardBase
{
    UNITY_POSITION(pos);
    float4 tex : TEXCOORD0;
    float4 eyeVec : TEXCOORD1;             // xyz: from the camera, w: fog
    float4 tangentToWorldAndPackedData[3] : TEXCOORD2; // w: view direction in tangent space
    half4 ambientOrLightmapUV : TEXCOORD5;
    float3 posWorld : TEXCOORD6;
    UNITY_SHADOW_COORDS(7)
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

half4 VertexGIForward(VertexInput v, float3 posWorld, half3 normalWorld)
{
    half4 result = half4(0, 0, 0, 0);
#if defined(LIGHTMAP_ON)
    result.xy = v.uv1.xy * unity_LightmapST.xy + unity_LightmapST.zw;
#elif UNITY_SHOULD_SAMPLE_SH
#ifdef VERTEXLIGHT_ON
    result.rgb = limn_FourVertexLights(posWorld, normalWorld);
#endif
    result.rgb = ShadeSHPerVertex(normalWorld, result.rgb);
#endif
    return result;
}

VertexOutputForwardBase vertForwardBase(VertexInput v)
{
    UNITY_SETUP_INSTANCE_ID(v);
    VertexOutputForwardBase o;
    UNITY_INITIALIZE_OUTPUT(VertexOutputForwardBase, o);
    o.tex = TexCoords(v);
    o.eyeVec.xyz = -limn_ObjectToCamera(v.vertex.xyz);
    float3 posWorld = mul(unity_ObjectToWorld, v.vertex).xyz;
    o.pos = UnityObjectToClipPos(v.vertex);
    o.posWorld = posWorld;
    float3 normalWorld = UnityObjectToWorldNormal(v.normal);
    o.tangentToWorldAndPackedData[2].xyz = normalWorld;
#ifdef _TANGENT_TO_WORLD
    float3x3 frame = CreateTangentToWorldPerVertex(
        normalWorld, UnityObjectToWorldDir(v.tangent.xyz), v.tangent.w);
    o.tangentToWorldAndPackedData[0].xyz = frame[0];
    o.tangentToWorldAndPackedData[1].xyz = frame[1];
#endif
#ifdef _PARALLAXMAP
    TANGENT_SPACE_ROTATION;
    half3 viewDir = mul(rotation, ObjSpaceViewDir(v.vertex));
    o.tangentToWorldAndPackedData[0].w = viewDir.x;
    o.tangentToWorldAndPackedData[1].w = viewDir.y;
    o.tangentToWorldAndPackedData[2].w = viewDir.z;
#endif
    o.ambientOrLightmapUV = VertexGIForward(v, posWorld, normalWorld);
    UNITY_TRANSFER_SHADOW(o, v.uv1);
    UNITY_TRANSFER_FOG_COMBINED_WITH_EYE_VEC(o, o.pos);
    return o;
}

float3 PerPixelWorldNormal(float4 tex, float4 tangentToWorld[3])
{
#ifdef _NORMALMAP
    half3 normal = NormalInTangentSpace(tex);
    return normalize(tangentToWorld[0].xyz * normal.x + tangentToWorld[1].xyz * normal.y +
                     tangentToWorld[2].xyz * normal.z);
#else
    return normalize(tangentToWorld[2].xyz);
#endif
}

FragmentCommonData FragmentSetup(inout float4 tex, float3 eyeVec, half3 viewDirTangent,
                                 float4 tangentToWorld[3], float3 posWorld)
{
    tex = Parallax(tex, viewDirTangent);
    half alpha = Alpha(tex.xy);
#if defined(_ALPHATEST_ON)
    clip(alpha - _Cutoff);
#endif
    FragmentCommonData surface = UNITY_SETUP_BRDF_INPUT(tex);
    surface.diffColor = PreMultiplyAlpha(surface.diffColor, alpha, surface.oneMinusReflectivity,
                                         surface.alpha);
    surface.posWorld = posWorld;
    surface.eyeVec = normalize(eyeVec);
    surface.normalWorld = PerPixelWorldNormal(tex, tangentToWorld);
    return surface;
}

FragmentCommonData limn_FragmentSetup(VertexOutputForwardBase i)
{
    half3 viewDir = half3(i.tangentToWorldAndPackedData[0].w, i.tangentToWorldAndPackedData[1].w,
                          i.tangentToWorldAndPackedData[2].w);
    return FragmentSetup(i.tex, i.eyeVec.xyz, viewDir, i.tangentToWorldAndPackedData, i.posWorld);
}
#define FRAGMENT_SETUP(x) FragmentCommonData x = limn_FragmentSetup(i);
#define FRAGMENT_SETUP_FWDADD(x) FRAGMENT_SETUP(x)
#define IN_WORLDPOS(i) i.posWorld

UnityGI FragmentGI(FragmentCommonData s, half occlusion, half4 i_ambientOrLightmapUV, half atten,
                   UnityLight light, bool reflections)
{
    UnityGIInput at = (UnityGIInput)0;
#if !defined(LIGHTMAP_ON)
    at.ambient = i_ambientOrLightmapUV.rgb;
#else
    at.lightmapUV = i_ambientOrLightmapUV;
#endif
    at.atten = atten;
    at.light = light;
    at.worldViewDir = -s.eyeVec;
    at.worldPos = s.posWorld;
    return UnityGlobalIllumination(at, occlusion, s.smoothness, s.normalWorld, reflections);
}
UnityGI FragmentGI(FragmentCommonData s, half occlusion, half4 i_ambientOrLightmapUV, half atten,
                   UnityLight light)
{
    return FragmentGI(s, occlusion, i_ambientOrLightmapUV, atten, light, true);
}
// Of older shaders
UnityGI FragmentGI(float3 posWorld, half occlusion, half4 i_ambientOrLightmapUV, half atten,
                   half smoothness, half3 normalWorld, half3 eyeVec, UnityLight light,
                   bool reflections)
{
    FragmentCommonData surface = (FragmentCommonData)0;
    surface.posWorld = posWorld;
    surface.eyeVec = eyeVec;
    surface.normalWorld = normalWorld;
    surface.smoothness = smoothness;
    return FragmentGI(surface, occlusion, i_ambientOrLightmapUV, atten, light, reflections);
}
UnityGI FragmentGI(float3 posWorld, half occlusion, half4 i_ambientOrLightmapUV, half atten,
                   half smoothness, half3 normalWorld, half3 eyeVec, UnityLight light)
{
    return FragmentGI(posWorld, occlusion, i_ambientOrLightmapUV, atten, smoothness, normalWorld,
                      eyeVec, light, true);
}

half4 OutputForward(half4 output, half alphaFromSurface)
{
#if defined(_ALPHABLEND_ON) || defined(_ALPHAPREMULTIPLY_ON)
    output.a = alphaFromSurface;
#else
    UNITY_OPAQUE_ALPHA(output.a);
#endif
    return output;
}

half4 limn_Shaded(FragmentCommonData s, UnityLight light, UnityIndirect indirect)
{
    return UNITY_BRDF_PBS(s.diffColor, s.specColor, s.oneMinusReflectivity, s.smoothness,
                          s.normalWorld, -s.eyeVec, light, indirect);
}

half4 fragForwardBaseInternal(VertexOutputForwardBase i)
{
    FRAGMENT_SETUP(s)
    UNITY_LIGHT_ATTENUATION(reaching, i, s.posWorld);
    UnityGI gi =
        FragmentGI(s, Occlusion(i.tex.xy), i.ambientOrLightmapUV, reaching, MainLight());
    half4 color = limn_Shaded(s, gi.light, gi.indirect);
    color.rgb += Emission(i.tex.xy);
    UNITY_EXTRACT_FOG_FROM_EYE_VEC(i);
    UNITY_APPLY_FOG(_unity_fogCoord, color);
    return OutputForward(color, s.alpha);
}
half4 fragForwardBase(VertexOutputForwardBase i) : SV_Target { return fragForwardBaseInternal(i); }

// Passes that add a light
#define VertexOutputForwardAdd VertexOutputForwardBase
VertexOutputForwardBase vertForwardAdd(VertexInput v) { return vertForwardBase(v); }
half4 fragForwardAddInternal(VertexOutputForwardBase i)
{
    FRAGMENT_SETUP(s)
    float3 toLight = UnityWorldSpaceLightDir(s.posWorld);
    UNITY_LIGHT_ATTENUATION(reaching, i, s.posWorld);
    half4 color = limn_Shaded(s, AdditiveLight(toLight, reaching), ZeroIndirect());
    UNITY_EXTRACT_FOG_FROM_EYE_VEC(i);
    UNITY_APPLY_FOG_COLOR(_unity_fogCoord, color, half4(0, 0, 0, 0));
    return OutputForward(color, s.alpha);
}
half4 fragForwardAdd(VertexOutputForwardBase i) : SV_Target { return fragForwardAddInternal(i); }

// Passes that fill G-buffers: no lamp shines yet, ambient light and emission do.
#define VertexOutputDeferred VertexOutputForwardBase
VertexOutputForwardBase vertDeferred(VertexInput v) { return vertForwardBase(v); }
void fragDeferred(VertexOutputForwardBase i, out half4 outGBuffer0 : SV_Target0,
                  out half4 outGBuffer1 : SV_Target1, out half4 outGBuffer2 : SV_Target2,
                  out half4 outEmission : SV_Target3)
{
    FRAGMENT_SETUP(s)
    half open = Occlusion(i.tex.xy);
    UnityStandardDataToGbuffer(
        limn_StandardData(s.diffColor, open, s.specColor, s.smoothness, s.normalWorld),
        outGBuffer0, outGBuffer1, outGBuffer2);
    UnityGI gi = FragmentGI(s, open, i.ambientOrLightmapUV, 1.0, DummyLight(), true);
    half3 glow = Emission(i.tex.xy) + limn_Shaded(s, gi.light, gi.indirect).rgb;
#ifdef UNITY_HDR_ON
    outEmission = half4(glow, 1.0);
#else
    outEmission = half4(exp2(-glow), 1.0);
#endif
}
#endif

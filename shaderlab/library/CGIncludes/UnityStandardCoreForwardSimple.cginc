// The Standard shader on weak devices: its cheapest reflection model, of which the vertices have what
// changes slowly: the mirrored view, Fresnel's term, the light's direction in tangent space.
#pragma once
#ifndef UNITY_STANDARD_CORE_FORWARD_SIMPLE_INCLUDED
#define UNITY_STANDARD_CORE_FORWARD_SIMPLE_INCLUDED
#include "UnityStandardCore.cginc"

#ifndef SPECULAR_HIGHLIGHTS
#define SPECULAR_HIGHLIGHTS (!defined(_SPECULAR_HIGHLIGHTS_OFF))
#endif
#define GLOSSMAP (defined(_SPECGLOSSMAP) || defined(_METALLICGLOSSMAP))

half MetallicSetup_Reflectivity() { return 1.0 - OneMinusReflectivityFromMetallic(_Metallic); }
half RoughnessSetup_Reflectivity() { return MetallicSetup_Reflectivity(); }
half SpecularSetup_Reflectivity() { return SpecularStrength(_SpecColor.rgb); }
#define limn_REFLECTIVITY_OF(setup) setup##_Reflectivity()
#define limn_REFLECTIVITY(setup) limn_REFLECTIVITY_OF(setup)
#define UNIFORM_REFLECTIVITY() limn_REFLECTIVITY(UNITY_SETUP_BRDF_INPUT)

struct VertexOutputBaseSimple
{
    UNITY_POSITION(pos);
    float4 tex : TEXCOORD0;
    half4 eyeVec : TEXCOORD1; // w: what is reflected at grazing angles
    half4 ambientOrLightmapUV : TEXCOORD2;
    SHADOW_COORDS(3)
    half4 fogCoord : TEXCOORD4;    // yzw: the mirrored view
    half4 normalWorld : TEXCOORD5; // w: Fresnel's term
#ifdef _NORMALMAP
    half3 tangentSpaceLightDir : TEXCOORD6;
    half3 tangentSpaceEyeVec : TEXCOORD7;
#endif
    float3 posWorld : TEXCOORD8;
    UNITY_VERTEX_OUTPUT_STEREO
};
struct VertexOutputForwardAddSimple
{
    UNITY_POSITION(pos);
    float4 tex : TEXCOORD0;
    float3 posWorld : TEXCOORD1;
    UNITY_SHADOW_COORDS(2)
    half4 fogCoord : TEXCOORD3; // yzw: the mirrored view
    half3 lightDir : TEXCOORD4; // of these three: tangent space with a normal map
    half3 normalWorld : TEXCOORD5;
    half3 tangentSpaceEyeVec : TEXCOORD6;
    UNITY_VERTEX_OUTPUT_STEREO
};

#ifdef _NORMALMAP
half3 TransformToTangentSpace(half3 tangent, half3 binormal, half3 normal, half3 v)
{
    return mul(half3x3(tangent, binormal, normal), v);
}
void TangentSpaceLightingInput(half3 normalWorld, half4 vTangent, half3 lightDirWorld,
                               half3 eyeVecWorld, out half3 tangentSpaceLightDir,
                               out half3 tangentSpaceEyeVec)
{
    float3x3 frame =
        CreateTangentToWorldPerVertex(normalWorld, UnityObjectToWorldDir(vTangent.xyz), vTangent.w);
    tangentSpaceLightDir = TransformToTangentSpace(frame[0], frame[1], frame[2], lightDirWorld);
    tangentSpaceEyeVec =
        normalize(TransformToTangentSpace(frame[0], frame[1], frame[2], eyeVecWorld));
}
#endif

VertexOutputBaseSimple vertForwardBaseSimple(VertexInput v)
{
    UNITY_SETUP_INSTANCE_ID(v);
    VertexOutputBaseSimple o;
    UNITY_INITIALIZE_OUTPUT(VertexOutputBaseSimple, o);
    o.posWorld = mul(unity_ObjectToWorld, v.vertex).xyz;
    o.pos = UnityObjectToClipPos(v.vertex);
    o.tex = TexCoords(v);
    half3 eye = -normalize(limn_ObjectToCamera(v.vertex.xyz));
    half3 normal = UnityObjectToWorldNormal(v.normal);
    o.eyeVec = half4(eye, saturate(_Glossiness + UNIFORM_REFLECTIVITY()));
    o.normalWorld = half4(normal, Pow4(1.0 - saturate(dot(normal, -eye))));
    o.fogCoord.yzw = reflect(eye, normal);
#ifdef _NORMALMAP
    TangentSpaceLightingInput(normal, v.tangent, _WorldSpaceLightPos0.xyz, eye,
                              o.tangentSpaceLightDir, o.tangentSpaceEyeVec);
#endif
    TRANSFER_SHADOW(o);
    o.ambientOrLightmapUV = VertexGIForward(v, o.posWorld, normal);
    UNITY_TRANSFER_FOG(o, o.pos);
    return o;
}

VertexOutputForwardAddSimple vertForwardAddSimple(VertexInput v)
{
    UNITY_SETUP_INSTANCE_ID(v);
    VertexOutputForwardAddSimple o;
    UNITY_INITIALIZE_OUTPUT(VertexOutputForwardAddSimple, o);
    o.posWorld = mul(unity_ObjectToWorld, v.vertex).xyz;
    o.pos = UnityObjectToClipPos(v.vertex);
    o.tex = TexCoords(v);
    half3 eye = -normalize(limn_ObjectToCamera(v.vertex.xyz));
    half3 normal = UnityObjectToWorldNormal(v.normal);
    half3 light = _WorldSpaceLightPos0.xyz - o.posWorld * _WorldSpaceLightPos0.w;
#ifndef USING_DIRECTIONAL_LIGHT
    light = NormalizePerVertexNormal(light);
#endif
#ifdef _NORMALMAP
    TangentSpaceLightingInput(normal, v.tangent, light, eye, o.lightDir, o.tangentSpaceEyeVec);
#else
    o.lightDir = light;
    o.normalWorld = normal;
    o.fogCoord.yzw = reflect(eye, normal);
#endif
    UNITY_TRANSFER_SHADOW(o, v.uv1);
    UNITY_TRANSFER_FOG(o, o.pos);
    return o;
}

// The surface; its normal and the mirrored view are where the light's direction is.
FragmentCommonData limn_SimpleSurface(float4 tex)
{
    half alpha = Alpha(tex.xy);
#ifdef _ALPHATEST_ON
    clip(alpha - _Cutoff);
#endif
    FragmentCommonData surface = UNITY_SETUP_BRDF_INPUT(tex);
    surface.diffColor = PreMultiplyAlpha(surface.diffColor, alpha, surface.oneMinusReflectivity,
                                         surface.alpha);
    return surface;
}
FragmentCommonData FragmentSetupSimple(VertexOutputBaseSimple i)
{
    FragmentCommonData surface = limn_SimpleSurface(i.tex);
    surface.posWorld = i.posWorld;
    surface.eyeVec = i.eyeVec.xyz;
    surface.normalWorld = i.normalWorld.xyz;
    return surface;
}
FragmentCommonData FragmentSetupSimpleAdd(VertexOutputForwardAddSimple i)
{
    FragmentCommonData s = limn_SimpleSurface(i.tex);
    s.normalWorld = i.normalWorld;
    s.posWorld = i.posWorld;
    return s;
}

UnityLight MainLightSimple(VertexOutputBaseSimple i, FragmentCommonData s) { return MainLight(); }
half PerVertexGrazingTerm(VertexOutputBaseSimple i, FragmentCommonData s)
{
#if GLOSSMAP
    return saturate(s.smoothness + (1.0 - s.oneMinusReflectivity));
#else
    return i.eyeVec.w;
#endif
}
half PerVertexFresnelTerm(VertexOutputBaseSimple i) { return i.normalWorld.w; }

half3 BRDF3DirectSimple(half3 diffColor, half3 specColor, half smoothness, half rl)
{
#if SPECULAR_HIGHLIGHTS
    return BRDF3_Direct(diffColor, specColor, Pow4(rl), smoothness);
#else
    return diffColor;
#endif
}

half4 fragForwardBaseSimpleInternal(VertexOutputBaseSimple i)
{
    FragmentCommonData s = FragmentSetupSimple(i);
    UnityLight light = MainLightSimple(i, s);
#ifdef _NORMALMAP
    half3 normal = NormalInTangentSpace(i.tex);
    half3 lightDir = i.tangentSpaceLightDir;
    half3 mirrored = reflect(i.tangentSpaceEyeVec, normal);
#else
    half3 normal = s.normalWorld;
    half3 lightDir = light.dir;
    half3 mirrored = i.fogCoord.yzw;
#endif
    UnityGI gi = FragmentGI(s, Occlusion(i.tex.xy), i.ambientOrLightmapUV, SHADOW_ATTENUATION(i),
                            light);
    half3 scattered =
        BRDF3DirectSimple(s.diffColor, s.specColor, s.smoothness, dot(lightDir, mirrored));
    half grazing = PerVertexGrazingTerm(i, s);
    half fresnel = PerVertexFresnelTerm(i);
    half4 color = half4(Emission(i.tex.xy), 1);
    color.rgb += BRDF3_Indirect(s.diffColor, s.specColor, gi.indirect, grazing, fresnel);
    color.rgb += saturate(dot(lightDir, normal)) * gi.light.color * scattered;
    UNITY_APPLY_FOG(i.fogCoord, color);
    return OutputForward(color, s.alpha);
}
half4 fragForwardBaseSimple(VertexOutputBaseSimple i) : SV_Target
{
    return fragForwardBaseSimpleInternal(i);
}

half3 LightSpaceNormal(VertexOutputForwardAddSimple i, FragmentCommonData s)
{
#ifdef _NORMALMAP
    return NormalInTangentSpace(i.tex);
#else
    return i.normalWorld;
#endif
}
half4 fragForwardAddSimpleInternal(VertexOutputForwardAddSimple i)
{
    FragmentCommonData s = FragmentSetupSimpleAdd(i);
    half3 normal = LightSpaceNormal(i, s);
#ifdef _NORMALMAP
    half3 mirrored = reflect(i.tangentSpaceEyeVec, normal);
#else
    half3 mirrored = i.fogCoord.yzw;
#endif
    UNITY_LIGHT_ATTENUATION(atten, i, s.posWorld);
    half3 arriving = _LightColor0.rgb * (atten * saturate(dot(i.lightDir, normal)));
    half cosine = dot(i.lightDir, mirrored);
    half3 scattered = BRDF3DirectSimple(s.diffColor, s.specColor, s.smoothness, cosine);
    half4 color = half4(arriving * scattered, 1);
    UNITY_APPLY_FOG_COLOR(i.fogCoord, color, half4(0, 0, 0, 0));
    return OutputForward(color, s.alpha);
}
half4 fragForwardAddSimple(VertexOutputForwardAddSimple i) : SV_Target
{
    return fragForwardAddSimpleInternal(i);
}
#endif

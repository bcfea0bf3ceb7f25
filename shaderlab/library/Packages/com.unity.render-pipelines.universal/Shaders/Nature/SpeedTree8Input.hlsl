// Properties of SpeedTree 8.
#pragma once
#ifndef UNIVERSAL_SPEEDTREE8_INPUT_INCLUDED
#define UNIVERSAL_SPEEDTREE8_INPUT_INCLUDED

#ifdef EFFECT_BUMP
#define _NORMALMAP
#endif
#define _ALPHATEST_ON

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceInput.hlsl"
#include "limn/ShadowCaster.hlsl"
#define SPEEDTREE_Y_UP
#include "limn/SpeedTree8Vertex.hlsl"

#define _Surface 0.0 // opaque
half4 _Color;
int _TwoSided;
TEXTURE2D(_MainTex);
SAMPLER(sampler_MainTex);
float4 _MainTex_TexelSize;
float4 _MainTex_MipInfo;
#ifdef EFFECT_EXTRA_TEX
sampler2D _ExtraTex; // smoothness, metallic, ambient occlusion
#else
half _Glossiness;
half _Metallic;
#endif
#ifdef EFFECT_HUE_VARIATION
half4 _HueVariationColor;
#endif
#ifdef EFFECT_BILLBOARD
half _BillboardShadowFade;
#endif
#ifdef EFFECT_SUBSURFACE
sampler2D _SubsurfaceTex;
half4 _SubsurfaceColor;
half _SubsurfaceIndirect;
#endif
#ifdef SCENESELECTIONPASS
int _ObjectId;
int _PassValue;
#endif
#endif

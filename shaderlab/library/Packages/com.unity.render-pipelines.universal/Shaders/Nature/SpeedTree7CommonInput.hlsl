// Properties of SpeedTree 7 and of its billboards.
#pragma once
#ifndef UNIVERSAL_SPEEDTREE7COMMON_INPUT_INCLUDED
#define UNIVERSAL_SPEEDTREE7COMMON_INPUT_INCLUDED

#ifdef SPEEDTREE_ALPHATEST
#define _ALPHATEST_ON
#endif
#ifdef EFFECT_BUMP
#define _NORMALMAP
#endif

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SurfaceInput.hlsl"
#include "limn/ShadowCaster.hlsl"

#ifdef ENABLE_WIND
#define SPEEDTREE_Y_UP
half _WindQuality;
half _WindEnabled;
#endif
#include "limn/SpeedTreeWindOfTree.hlsl"

TEXTURE2D(_MainTex);
SAMPLER(sampler_MainTex);
float4 _MainTex_TexelSize;
float4 _MainTex_MipInfo;
half4 _Color;
#ifdef EFFECT_HUE_VARIATION
half4 _HueVariation;
#endif
#ifdef SCENESELECTIONPASS
int _ObjectId;
int _PassValue;
#endif
#endif

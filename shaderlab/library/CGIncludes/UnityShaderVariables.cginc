#pragma once
#include "limn/PerDraw.hlsl"
#include "limn/Globals.hlsl"

// The built-in pipeline's names of the same values.
#define _WorldSpaceLightPos0 _MainLightPosition
#define _LightColor0 _MainLightColor
#define UNITY_LIGHTMODEL_AMBIENT unity_AmbientSky
#define unity_AmbientEquator unity_AmbientSky
#define unity_AmbientGround unity_AmbientSky
#define _Object2World unity_ObjectToWorld
#define _World2Object unity_WorldToObject

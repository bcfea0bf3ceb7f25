// Properties of signed-distance-field text.
#pragma once
#include "HLSLSupport.cginc"

// The letters: alpha holds the distance to their edge.
sampler2D _MainTex;
float _TextureWidth, _TextureHeight;
float _GradientScale; // texels that the distances reach
float _ScaleX, _ScaleY;
float _PerspectiveFilter, _Sharpness;
float _WeightNormal, _WeightBold;
float _ScaleRatioA, _ScaleRatioB, _ScaleRatioC; // of the outline, the glow, the underlay
float _VertexOffsetX, _VertexOffsetY;
float _ShaderFlags;

sampler2D _FaceTex;
float _FaceUVSpeedX, _FaceUVSpeedY;
fixed4 _FaceColor;
float _FaceDilate;

sampler2D _OutlineTex;
float _OutlineUVSpeedX, _OutlineUVSpeedY;
fixed4 _OutlineColor;
float _OutlineWidth, _OutlineSoftness;

fixed4 _UnderlayColor;
float _UnderlayOffsetX, _UnderlayOffsetY, _UnderlayDilate, _UnderlaySoftness;

fixed4 _GlowColor;
float _GlowOffset, _GlowOuter, _GlowInner, _GlowPower;

float _Bevel, _BevelOffset, _BevelWidth, _BevelClamp, _BevelRoundness;
sampler2D _BumpMap;
float _BumpOutline, _BumpFace;
samplerCUBE _Cube;
fixed4 _ReflectFaceColor, _ReflectOutlineColor;
float3 _EnvMatrixRotation;
float4x4 _EnvMatrix;
fixed4 _SpecularColor;
float _LightAngle, _SpecularPower, _Reflectivity, _Diffuse, _Ambient;

float _MaskID;
sampler2D _MaskTex;
float4 _MaskCoord;
float4 _ClipRect; // lower left corner, upper right one
float _MaskSoftnessX, _MaskSoftnessY;

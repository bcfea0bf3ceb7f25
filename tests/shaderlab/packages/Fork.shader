Shader "P" { SubShader { Pass { HLSLPROGRAM
#pragma vertex vert
#pragma fragment frag
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
struct V { float4 p : SV_POSITION; float3 w : TEXCOORD0; };
V vert(float3 p : POSITION) { V o; o.w = TransformObjectToWorld(p); o.p = TransformWorldToHClip(o.w); return o; }
half4 frag(V i) : SV_Target { return _Time.x + unity_SHAr + float4(_WorldSpaceCameraPos - i.w, 1); }
ENDHLSL } } }

Shader "P" { SubShader { Pass { HLSLPROGRAM
#pragma vertex vert
#pragma fragment frag
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
struct Varyings { float4 positionCS : SV_POSITION; half3 normal : TEXCOORD0; float2 uv : TEXCOORD1; };
Varyings vert(float3 p : POSITION, float2 uv : TEXCOORD0) { Varyings o = (Varyings)0; o.positionCS = ToClip(p); o.normal = half3(uv, 1); o.uv = uv; return o; }
half4 frag(Varyings i) : SV_Target {
  half4 c = SampleSmall(i.uv, TEXTURE2D_ARGS(_Small, sampler_Small));
  half3 n = Unpack(c); float a = Smallest3(i.normal) + Smallest3(i.positionCS.xyz);
  real x = 1, y = 2; Swap(x, y); uint2 k = uint2(1, 2), m = 3; Swap(k, m);
  LerpAll(c, half4(n, a), 0.5); PositionInputs q = GetInputs(i.uv, 2.0);
  float2 s = 0; UNITY_LOOP for (int j = 0; j < 4; j++) s += k_Poisson[j];
  return c + half4(Shade(i.normal), Attenuation(a, half2(1, 2)) + Attenuation(a, float2(1, 2))) + half4(s, q.positionNDC) * DivideUp(3u, 2u) + mul(k_Identity, c) + _Lights[0] + LOAD_TEXTURE2D(_Large, int2(0, 0)) * PositivePow_(x, 2) + half4(mul(TangentToWorld(n, c), Normalized(n)), IsNaN_(a));
}
ENDHLSL } } }

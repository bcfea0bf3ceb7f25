#pragma vertex vert
#pragma fragment frag
#pragma target 4.5
#pragma require 2darray mrt8
#pragma multi_compile _ A B // words
#pragma shader_feature_local_fragment _C \
    _D
#pragma multi_compile_fwdadd_fullshadows
#pragma skip_variants A
#pragma only_renderers vulkan d3d11
#pragma multi_compile_instancing#define GLUED 1
#define OWN (1 + 2)
#if defined(OWN) && OWN * 2 >= 6 || !defined SHADER_API_MOBILE
#include_with_pragmas "other.hlsl"
#include "Packages\com.x\y.hlsl"
#elif GLUED
#warning never
#endif
static const int COUNT = 2;
typedef float4 color;
struct inner { half3 n : NORMAL; nointerpolation uint id : TEXCOORD5; };
struct v2f { float4 pos : SV_POSITION; color c[COUNT] : COLOR0; float3x3 m : TEXCOORD1; inner i; };
cbuffer UnityPerMaterial : register(b1) { float4 _C; float _F[4]; float4x4 _M; };
Texture2D<float4> _T; sampler sampler_T; StructuredBuffer<v2f> _B; sampler2D _Old;
float4 helper(inout float4 v, const float s = 1);
v2f vert(inout float4 p : POSITION, uint id : SV_VertexID, out float4 extra : TEXCOORD7)
{
    v2f o = (v2f)0;
    _C.xyz *= 2; _F[1]++;
    float3 line = _M._m03_m13_m23.zyx + (_M)._11_22.xxy;
    o.pos = helper(p, line.x);
    return o;
}
float4 helper(inout float4 v, const float s) { return v * s + limn_DrawIndex; }
[earlydepthstencil]
half4 frag(v2f i, fixed face : VFACE, float4 where : VPOS) : COLOR { return _T.Sample(sampler_T, i.pos.xy); }

namespace Inks {
float4 _Tint;
enum class Kind { Dry = 3, Wet };
static const float k_Size = 2, k_Area = k_Size * k_Size;
struct Drop { float size; static const float k_Most = 7; float Area() { return size * k_Size; } };
namespace Thin { float Scale(float x) { return x / k_Size; } }
}
cbuffer Settings { struct Pair { float a, b; } _One, _Two[2]; struct { float c; } _Three; };
Texture2D _Map; SamplerComparisonState sampler_Map;
float4 frag(float2 uv : TEXCOORD0) : SV_Target {
    Inks::Drop d; d.size = Inks::Thin::Scale(_One.a);
    return _Map.GatherCmp(sampler_Map, uv, 0.5) + d.Area() + Inks::Drop::k_Most + Inks::Kind::Wet + Inks::_Tint;
}

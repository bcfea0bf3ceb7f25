#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>

// SpeedTrees of both pipelines: every kind of geometry, pass and quality of wind compiles.

namespace limn
{
namespace
{

using test::CompileCg;
using test::k_Tree8Variants;
using testing::IsEmpty;

/// A pass of the author's around SpeedTreeVert and SpeedTreeFrag; VERTEX is what a vertex holds.
const std::string k_Tree = R"(
    struct v2f { float4 pos : SV_POSITION; fixed4 color : COLOR; half3 a : TEXCOORD0; half3 b : TEXCOORD1; };
    v2f vert(VERTEX v)
    {
        v2f o;
        Input data;
        PLACE(v, data);
        o.color = data.color;
        o.a = data.interpolator1;
        o.b = 0;
    #ifdef GEOM_TYPE_BRANCH_DETAIL
        o.b = data.interpolator2;
    #endif
        o.pos = UnityObjectToClipPos(v.vertex);
        return o;
    }
    fixed4 frag(v2f i) : SV_Target
    {
        Input data = (Input)0;
        data.color = i.color;
        data.interpolator1 = i.a;
    #ifdef GEOM_TYPE_BRANCH_DETAIL
        data.interpolator2 = i.b;
    #endif
        SpeedTreeFragOut o, other;
        SpeedTreeFrag(data, o);
        SPEEDTREE_COPY_FRAG(other, o)
        return fixed4(other.Albedo, other.Alpha);
    })";

TEST(BuiltinLibrary, CompilesSpeedTreesOfEveryGeometry)
{
    const std::string text = "#define VERTEX SpeedTreeVB\n#define PLACE SpeedTreeVert\n"
                             "#include \"SpeedTreeCommon.cginc\"\n" +
                             k_Tree;
    for (const char* geometry : {"BRANCH", "BRANCH_DETAIL", "FROND", "LEAF", "MESH"})
    {
        SCOPED_TRACE(geometry);
        const std::string define = std::string("#define GEOM_TYPE_") + geometry + "\n";
        CompileCg(define + text);
        CompileCg(define + text, {"EFFECT_BUMP", "EFFECT_HUE_VARIATION", "LOD_FADE_PERCENTAGE"});
        const auto windy = CompileCg("#define ENABLE_WIND\n" + define + text);
        EXPECT_THAT(windy->diagnostics, IsEmpty());
        EXPECT_THAT(test::Disassemble(windy->vertexSpirv), testing::HasSubstr("_ST_WindGlobal"));
    }
}

TEST(BuiltinLibrary, CompilesBillboardsOfSpeedTrees)
{
    const std::string text = "#define VERTEX SpeedTreeBillboardData\n"
                             "#define PLACE SpeedTreeBillboardVert\n"
                             "#include \"SpeedTreeBillboardCommon.cginc\"\n" +
                             k_Tree;
    CompileCg(text);
    CompileCg("#define BILLBOARD_FACE_CAMERA_POS\n#define ENABLE_WIND\n" + text,
              {"EFFECT_BUMP", "EFFECT_HUE_VARIATION"});
}

TEST(BuiltinLibrary, KnowsEveryFunctionOfTheWind)
{
    const std::string text = R"(
        #include "UnityCG.cginc"
        #include "SpeedTreeWind.cginc"
        #ifdef WIND_EFFECT_FROND_RIPPLE_ADJUST_LIGHTING
        #define FRAME , p.xyz, p.yzx
        #else
        #define FRAME
        #endif
        float4 vert(float4 p : POSITION, float3 n : NORMAL) : SV_Position
        {
            float4 waves = 0;
            float3 v = DirectionalBranchWind(p.xyz, n, p.x, p.y, p.z, 1, 2, 3, 4, 5, 6, true, true, true, true, n);
            v += DirectionalBranchWindFrondStyle(p.xyz, n, p.x, p.y, p.z, 1, 2, 3, 4, 5, 6, true, true, true, true, n, v);
            v += SimpleBranchWind(p.xyz, n, p.x, p.y, p.z, 1, 2, 3, 4, true, true, false, n);
            v *= Roll(p.x, p.y, p.z, 1, 2, p.xyz, 3, n) + Turbulence(p.x, p.y, p.z, p.w);
            v *= Oscillate(p.xyz, p.x, p.y, p.z, p.w, true, false, true, 1, 2, waves, n);
            v += RippleFrondTwoSided(p.xyz, n, p.x, p.y, p.z, p.w FRAME);
            v += RippleFrond(p.xyz, n, p.x, p.y, p.z, p.w, 1 FRAME);
            v += LeafRipple(p.xyz, n, 1, 2, 3, 4, true, 5) + wind_cross(v, n);
            v = mul_float3x3_float3(mul_float3x3_float3x3(RotationMatrix(n, 1), RotationMatrix(n, 2)), v);
            return waves + float4(v, 1);
        }
        fixed4 frag() : SV_Target { return 1; })";
    for (const char* define :
         {"", "#define SPEEDTREE_Z_UP\n", "#define WIND_EFFECT_FROND_RIPPLE_ADJUST_LIGHTING\n"})
    {
        SCOPED_TRACE(define);
        CompileCg(define + text);
    }
}

TEST(BuiltinLibrary, CompilesSpeedTree8)
{
    const std::string text = R"(
        #define ENABLE_WIND
        #include "SpeedTree8Common.cginc"
        struct v2f
        {
            float4 pos : SV_POSITION; Input data; float3 world : TEXCOORD1; float3 normal : NORMAL;
        };
        struct Stored { half4 a : SV_Target0; half4 b : SV_Target1; half4 c : SV_Target2; half4 d : SV_Target3; };
        v2f vert(appdata_full v)
        {
            v2f o = (v2f)0;
            SpeedTreeVert(v);
            o.pos = UnityObjectToClipPos(v.vertex);
            o.world = v.vertex.xyz;
            o.normal = v.normal;
            o.data.uv_MainTex = v.texcoord.xy;
            o.data.color = v.color;
            return o;
        }
        Stored frag(v2f i)
        {
            Input data = (Input)0;
            data.uv_MainTex = i.data.uv_MainTex;
            data.color = i.data.color;
            SurfaceOutputStandard s = (SurfaceOutputStandard)0;
            s.Normal = i.normal;
            SpeedTreeSurf(data, s);
            UnityGIInput giInput = (UnityGIInput)0;
            UnityGI gi = (UnityGI)0;
            LightingSpeedTreeSubsurface_GI(s, giInput, gi);
            Stored o;
            o.d = LightingSpeedTreeSubsurface_Deferred(s, i.world, gi, o.a, o.b, o.c);
            o.d += LightingSpeedTreeSubsurface(s, i.world, gi);
            return o;
        })";
    for (const auto& keywords : k_Tree8Variants)
    {
        SCOPED_TRACE(testing::PrintToString(keywords));
        CompileCg(text, keywords);
    }
}

} // namespace
} // namespace limn

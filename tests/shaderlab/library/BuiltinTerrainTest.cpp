#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using test::CompileCg;
using test::CompileEntries;
using test::TextureNames;
using testing::ElementsAre;

TEST(BuiltinLibrary, CompilesTreesOfTheTreeCreator)
{
    CompileCg(R"(
        #include "UnityBuiltin3xTreeLibrary.cginc"
        struct v2f
        {
            float4 pos : SV_POSITION; fixed3 light : COLOR; float2 uv : TEXCOORD0;
            float3 normal : TEXCOORD1; float4 screen : TEXCOORD2;
        };
        sampler2D _MainTex;
        v2f vert(appdata_full v)
        {
            v2f o;
            TreeVertLeaf(v);
            o.pos = UnityObjectToClipPos(v.vertex);
            o.light = ShadeTranslucentMainLight(v.vertex, v.normal) + v.color.rgb;
            o.light += ShadeTranslucentLights(v.vertex, v.normal);
            TreeVertBark(v);
            o.uv = v.texcoord.xy;
            o.normal = v.normal;
            o.screen = ComputeScreenPos(o.pos);
            return o;
        }
        fixed4 frag(v2f i) : SV_Target
        {
            LeafSurfaceOutput s = (LeafSurfaceOutput)0;
            s.Albedo = tex2D(_MainTex, i.uv).rgb;
            s.Normal = i.normal;
            clip(ComputeAlphaCoverage(i.screen, 0.5) - 0.5);
            return LightingTreeLeaf(s, _WorldSpaceLightPos0.xyz, i.normal, 1.0) + half4(i.light, 0);
        })",
              {"DIRECTIONAL", "VERTEXLIGHT_ON"});
}

TEST(BuiltinLibrary, CompilesSoftOcclusionTreesAndTreeBillboards)
{
    const std::string text = R"(
        #include "UnityBuiltin2xTreeLibrary.cginc"
        sampler2D _MainTex;
        v2f vert(appdata_tree v) { v2f o = LEAVES ? leaves(v) : bark(v); return o; }
        fixed4 frag(v2f i) : SV_Target
        {
            fixed4 c = tex2D(_MainTex, i.uv.xy) * i.color;
            UNITY_APPLY_FOG(i.fogCoord, c);
            return c;
        })";
    CompileCg("#define LEAVES 1\n" + text, {"FOG_LINEAR"});
    CompileCg("#define USE_CUSTOM_LIGHT_DIR\n#define WRITE_ALPHA_1\n#define LEAVES 0\n" + text);
    CompileCg(R"(
        #include "UnityCG.cginc"
        #include "TerrainEngine.cginc"
        float4 vert(appdata_tree_billboard v) : SV_Position
        {
            TerrainBillboardTree(v.vertex, v.texcoord1.xy, v.texcoord.y);
            return UnityObjectToClipPos(v.vertex);
        }
        fixed4 frag() : SV_Target { return 1; })");
}

TEST(BuiltinLibrary, CompilesTerrainLayersBrushesAndTheirPreview)
{
    const std::string layers = R"(
        #include "TerrainSplatmapCommon.cginc"
        struct v2f { float4 pos : SV_POSITION; float4 tc : TEXCOORD0; };
        v2f vert(appdata_full v)
        {
            Input data;
            SplatmapVert(v, data);
            v2f o;
            o.pos = UnityObjectToClipPos(v.vertex);
            o.tc = data.tc;
            return o;
        }
        fixed4 frag(v2f i) : SV_Target
        {
            Input IN = (Input)0;
            IN.tc = i.tc;
            half4 control; half weight; fixed4 color; fixed3 normal = fixed3(0, 0, 1);
        #ifdef TERRAIN_STANDARD_SHADER
            SplatmapMix(IN, half4(0.1, 0.2, 0.3, 0.4), control, weight, color, normal);
        #else
            SplatmapMix(IN, control, weight, color, normal);
        #endif
            SurfaceOutput o = (SurfaceOutput)0;
            o.Alpha = weight;
            SplatmapFinalColor(IN, o, color);
            return color + half4(normal, 0);
        })";
    EXPECT_THAT(
        TextureNames(*CompileCg(layers)),
        testing::UnorderedElementsAre("_Control", "_Splat0", "_Splat1", "_Splat2", "_Splat3"));
    EXPECT_EQ(CompileCg("#define TERRAIN_STANDARD_SHADER\n" + layers, {"_NORMALMAP", "FOG_EXP2"})
                  ->layout.textures.size(),
              9u);
    EXPECT_EQ(CompileCg("#define TERRAIN_SPLAT_ADDPASS\n" + layers, {"_ALPHATEST_ON"})
                  ->layout.textures.size(),
              6u);
    EXPECT_THAT(TextureNames(*CompileCg(R"(
        #include "TerrainTool.cginc"
        #include "TerrainPreview.cginc"
        #include "UnityCG.cginc"
        struct v2f { float4 pos : SV_POSITION; float2 uv : TEXCOORD0; };
        v2f vert(uint id : SV_VertexID)
        {
            v2f o;
            float2 pixels = BuildProceduralQuadMeshVertex(id);
            o.uv = PaintContextPixelsToBrushUV(pixels);
            float height = tex2Dlod(_Heightmap, float4(PaintContextPixelsToHeightmapUV(pixels), 0, 0)).r;
            float3 at = PaintContextPixelsToObjectPosition(pixels, height);
            o.pos = UnityWorldToClipPos(TerrainObjectToWorldPosition(at));
            return o;
        }
        fixed4 frag(v2f i) : SV_Target
        {
            float2 uv = PaintContextUVToBrushUV(i.uv) + PaintContextUVToHeightmapUV(i.uv);
            return Stripe(uv.x, 0.5, 1.0);
        })")),
                ElementsAre("_Heightmap"));
}

TEST(BuiltinLibrary, CompilesTheTerrainToolsPackage)
{
    CompileCg(R"(
        #include "UnityCG.cginc"
        #include "Packages/com.unity.terrain-tools/Shaders/TerrainTools.hlsl"
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        float4 frag(float4 p : SV_Position) : SV_Target
        {
            float2 uv = PcUvToHeightmapUv(HeightmapUvToPcUv(p.xy)) + PaintContextUVToBrushUV(p.xy);
            float valid = IsPcUvPartOfValidTerrainTileTexel(uv);
            valid *= IsPcUvPartOfValidTerrainTileTexelSobel(uv, p.zw);
            return float4(uv, valid, RemapFilterValue(p, 0, 1, 2, 3) + pow_keep_sign(p, 2));
        })");
}

TEST(BuiltinLibrary, CompilesTheOtherPassesOfTheStandardShader)
{
    const auto deferred = CompileEntries("#include \"UnityStandardCore.cginc\"\n", "vertDeferred",
                                         "fragDeferred", {"_EMISSION"});
    EXPECT_THAT(test::Disassemble(deferred->fragmentSpirv), testing::HasSubstr("Location 3"));
    CompileCg(R"(
        #include "UnityStandardCore.cginc"
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        half4 frag(float4 p : SV_Position) : SV_Target
        {
            UnityGI gi = FragmentGI(p.xyz, 1, p, 1, 0.5, p.xyz, p.xyz, DummyLight());
            return half4(gi.indirect.diffuse, 1);
        })");
    const std::string simple = "#define UNITY_STANDARD_SIMPLE 1\n"
                               "#define UNITY_SETUP_BRDF_INPUT MetallicSetup\n"
                               "#include \"UnityStandardCoreForward.cginc\"\n";
    for (const auto& keywords : {std::vector<std::string>{"FOG_LINEAR", "_NORMALMAP"},
                                 {"POINT", "_METALLICGLOSSMAP"},
                                 {"_SPECULARHIGHLIGHTS_OFF", "_SPECULAR_HIGHLIGHTS_OFF"}})
    {
        SCOPED_TRACE(keywords.front());
        CompileEntries(simple, "vertBase", "fragBase", keywords);
        CompileEntries(simple, "vertAdd", "fragAdd", keywords);
    }
    CompileEntries("#include \"UnityStandardCoreForwardSimple.cginc\"\n", "vertForwardBaseSimple",
                   "fragForwardBaseSimple");
}

TEST(BuiltinLibrary, CompilesTheOtherPassesOfParticles)
{
    const std::string editor = "#include \"UnityStandardParticleEditor.cginc\"\n";
    CompileEntries(editor, "vertEditorPass", "fragSceneHighlightPass", {"_ALPHATEST_ON"});
    CompileEntries("#define _FLIPBOOK_BLENDING 1\n" + editor, "vertEditorPass",
                   "fragScenePickingPass", {"_ALPHATEST_ON"});
    const std::string shadow = "#include \"UnityStandardParticleShadow.cginc\"\n";
    CompileEntries(shadow, "vertParticleShadowCaster", "fragParticleShadowCaster",
                   {"_ALPHATEST_ON"});
    CompileEntries("#define _REQUIRE_UV2 1\n" + shadow, "vertParticleShadowCaster",
                   "fragParticleShadowCaster", {"_ALPHAPREMULTIPLY_ON", "SHADOWS_CUBE"});
}

TEST(BuiltinLibrary, KeepsTheFunctionsOfOldShaders)
{
    CompileCg(R"(
        #include "UnityStandardBRDF.cginc"
        #define INCLUDE_UNITY_STANDARD_BRDF_DEPRECATED
        #include "UnityDeprecated.cginc"
        #undef INCLUDE_UNITY_STANDARD_BRDF_DEPRECATED
        #include "UnityImageBasedLighting.cginc"
        #define INCLUDE_UNITY_IMAGE_BASED_LIGHTING_DEPRECATED
        #include "UnityDeprecated.cginc"
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        half4 frag(float4 p : SV_Position) : SV_Target
        {
            half3 c = LazarovFresnelTerm(p.xyz, p.x, p.y) + SebLagardeFresnelTerm(p.xyz, p.x, p.y);
            c += CookTorranceVisibilityTerm(p.x, p.y, p.z, p.w) + KelemenVisibilityTerm(p.x);
            c += ModifiedKelemenVisibilityTerm(p.x, p.y) + SmithGGXVisibilityTerm(p.x, p.y, p.z);
            c += RDFBlinnPhongNormalizedTerm(p.x, p.y) * ImplicitVisibilityTerm();
            c += unity_LightGammaCorrectionConsts_PIDiv4 * RoughnessToSpecPower(p.x);
            c += Unity_GlossyEnvironment(UNITY_PASS_TEXCUBE(unity_SpecCube0), unity_SpecCube0_HDR, c, 0.5);
            return half4(c, LambertTerm(c, c));
        })");
}

} // namespace
} // namespace limn

#include "Mentions.h"
#include "Paths.h"
#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>

namespace limn
{
namespace
{

using test::CompileCg;
using test::Mentions;
using test::TextureNames;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Keywords = std::vector<std::string>;

constexpr const char* k_Entry = "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n"
                                "float4 frag() : SV_Target { return 1; }\n";

TEST(BuiltinLibrary, HasHeadersThatEachStandAlone)
{
    const std::filesystem::path folder = test::SourcePath("shaderlab/library/CGIncludes");
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        const std::string name = entry.path().filename().string();
        if (name == "Tessellation.cginc")
        {
            continue;
        }
        SCOPED_TRACE(name);
        EXPECT_NO_THROW(
            test::CompileHlsl("#define UIE_CUSTOM_SHADER\n#include \"" + name + "\"\n" + k_Entry));
        ++count;
    }
    EXPECT_GE(count, 20);
}

constexpr const char* k_Unlit = R"(
    #include "UnityCG.cginc"
    struct appdata { float4 vertex : POSITION; float2 uv : TEXCOORD0; UNITY_VERTEX_INPUT_INSTANCE_ID };
    struct v2f
    {
        float2 uv : TEXCOORD0;
        UNITY_FOG_COORDS(1)
        float4 vertex : SV_POSITION;
        UNITY_VERTEX_OUTPUT_STEREO
    };
    sampler2D _MainTex; float4 _MainTex_ST;
    v2f vert(appdata v)
    {
        v2f o;
        UNITY_SETUP_INSTANCE_ID(v);
        UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
        o.vertex = UnityObjectToClipPos(v.vertex);
        o.uv = TRANSFORM_TEX(v.uv, _MainTex);
        UNITY_TRANSFER_FOG(o, o.vertex);
        return o;
    }
    fixed4 frag(v2f i) : SV_Target
    {
        fixed4 col = tex2D(_MainTex, i.uv);
        UNITY_APPLY_FOG(i.fogCoord, col);
        UNITY_OPAQUE_ALPHA(col.a);
        return col;
    })";

TEST(BuiltinLibrary, FogsAnUnlitTextureWhereAFogKeywordIsOn)
{
    const auto plain = CompileCg(k_Unlit);
    EXPECT_THAT(test::Disassemble(plain->fragmentSpirv), Not(HasSubstr("unity_FogColor")));
    for (const char* fog : {"FOG_LINEAR", "FOG_EXP", "FOG_EXP2"})
    {
        SCOPED_TRACE(fog);
        const auto pass = CompileCg(k_Unlit, {fog});
        EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), HasSubstr("unity_FogColor"));
    }
}

TEST(BuiltinLibrary, LightsPerVertexInAForwardBasePass)
{
    const char* const text = R"(
        #include "UnityCG.cginc"
        #include "Lighting.cginc"
        #include "AutoLight.cginc"
        sampler2D _MainTex;
        struct v2f
        {
            float4 pos : SV_POSITION;
            float2 uv : TEXCOORD0;
            SHADOW_COORDS(1)
            fixed3 diff : COLOR0;
            fixed3 ambient : COLOR1;
            float3 worldPos : TEXCOORD2;
            LIGHTING_COORDS(3, 4)
        };
        v2f vert(appdata_base v)
        {
            v2f o;
            o.pos = UnityObjectToClipPos(v.vertex);
            o.uv = v.texcoord;
            o.worldPos = mul(unity_ObjectToWorld, v.vertex);
            half3 n = UnityObjectToWorldNormal(v.normal);
            o.diff = max(0, dot(n, _WorldSpaceLightPos0.xyz)) * _LightColor0.rgb;
            o.ambient = ShadeSH9(half4(n, 1)) + ShadeVertexLights(v.vertex, v.normal);
            o.ambient += Shade4PointLights(unity_4LightPosX0, unity_4LightPosY0, unity_4LightPosZ0,
                unity_LightColor[0].rgb, unity_LightColor[1].rgb, unity_LightColor[2].rgb,
                unity_LightColor[3].rgb, unity_4LightAtten0, o.worldPos, n);
            TRANSFER_SHADOW(o)
            TRANSFER_VERTEX_TO_FRAGMENT(o);
            return o;
        }
        fixed4 frag(v2f i) : SV_Target
        {
            UNITY_LIGHT_ATTENUATION(atten, i, i.worldPos);
            fixed3 light = i.diff * SHADOW_ATTENUATION(i) * atten * LIGHT_ATTENUATION(i) + i.ambient;
            return tex2D(_MainTex, i.uv) * fixed4(light, 1);
        })";
    EXPECT_THAT(TextureNames(*CompileCg(text, {"DIRECTIONAL"})), ElementsAre("_MainTex"));
    EXPECT_THAT(TextureNames(*CompileCg(text, {"DIRECTIONAL", "SHADOWS_SCREEN"})),
                ElementsAre("_MainTex"));
    const std::string adding = "#define UNITY_PASS_FORWARDADD\n" + std::string(text);
    EXPECT_THAT(TextureNames(*CompileCg(adding, {"POINT"})),
                testing::UnorderedElementsAre("_MainTex", "_LightTexture0"));
    EXPECT_THAT(TextureNames(*CompileCg(adding, {"SPOT"})),
                testing::UnorderedElementsAre("_MainTex", "_LightTexture0", "_LightTextureB0"));
}

TEST(BuiltinLibrary, TakesMacrosWithAndWithoutASemicolon)
{
    const std::string text = R"(
        #include "UnityCG.cginc"
        #include "AutoLight.cginc"
        UNITY_DECLARE_SCREENSPACE_TEXTURE(_GrabTexture)@
        struct v2f
        {
            float4 pos : SV_POSITION;
            UNITY_FOG_COORDS(0)@
            SHADOW_COORDS(1)@
            LIGHTING_COORDS(2, 3)@
            float3 worldPos : TEXCOORD4;
            UNITY_VERTEX_INPUT_INSTANCE_ID@
            UNITY_VERTEX_OUTPUT_STEREO@
        };
        v2f vert(appdata_base v)
        {
            v2f o;
            UNITY_SETUP_INSTANCE_ID(v)@
            UNITY_INITIALIZE_OUTPUT(v2f, o)@
            UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o)@
            o.pos = UnityObjectToClipPos(v.vertex);
            TRANSFER_SHADOW(o)@
            TRANSFER_VERTEX_TO_FRAGMENT(o)@
            UNITY_TRANSFER_FOG(o, o.pos);
            o.worldPos = SCALED_NORMAL;
            return o;
        }
        fixed4 frag(v2f i) : SV_Target
        {
            UNITY_LIGHT_ATTENUATION(atten, i, i.worldPos)@
            fixed4 c = UNITY_SAMPLE_SCREENSPACE_TEXTURE(_GrabTexture, i.pos.xy) * atten;
            UNITY_APPLY_FOG(i.fogCoord, c)@
            return c;
        })";
    for (const std::string semicolon : {"", ";"})
    {
        std::string written = text;
        for (std::size_t at = 0; (at = written.find('@', at)) != std::string::npos;)
        {
            written.replace(at, 1, semicolon);
        }
        EXPECT_THAT(TextureNames(*CompileCg(written, {"DIRECTIONAL"})),
                    ElementsAre("_GrabTexture"));
        EXPECT_THAT(TextureNames(*CompileCg(written, {"POINT", "SHADOWS_CUBE", "FOG_LINEAR"})),
                    testing::UnorderedElementsAre("_GrabTexture", "_LightTexture0"));
    }
}

TEST(BuiltinLibrary, LeavesTheLightColorToShadersThatDeclareIt)
{
    const auto pass = CompileCg(R"(
        #include "UnityCG.cginc"
        uniform float4 _LightColor0;
        float4 vert(float4 p : POSITION) : SV_Position { return UnityObjectToClipPos(p); }
        fixed4 frag() : SV_Target { return _LightColor0; })");
    EXPECT_THAT(test::Disassemble(pass->fragmentSpirv), HasSubstr("\"_LightColor0\""));
}

TEST(BuiltinLibrary, TellsADirectionalLightFromOneWithAPlace)
{
    const char* const text = R"(
        #include "Lighting.cginc"
        #include "AutoLight.cginc"
        float4 vert(float4 p : POSITION) : SV_Position { return UnityObjectToClipPos(p); }
        fixed4 frag(float4 p : SV_Position) : SV_Target
        {
        #ifdef USING_DIRECTIONAL_LIGHT
            return 1;
        #else
            float3 at = mul(unity_WorldToLight, p).xyz;
            return tex2D(_LightTexture0, dot(at, at).rr).UNITY_ATTEN_CHANNEL;
        #endif
        })";
    EXPECT_THAT(TextureNames(*CompileCg(text, {"DIRECTIONAL"})), testing::IsEmpty());
    EXPECT_THAT(TextureNames(*CompileCg(text, {"POINT"})), ElementsAre("_LightTexture0"));
}

TEST(BuiltinLibrary, CompilesShadowCasters)
{
    const char* const text = R"(
        #include "UnityCG.cginc"
        struct v2f { V2F_SHADOW_CASTER; };
        v2f vert(appdata_base v)
        {
            v2f o;
            TRANSFER_SHADOW_CASTER_NORMALOFFSET(o)
            return o;
        }
        float4 frag(v2f i) : SV_Target { SHADOW_CASTER_FRAGMENT(i) })";
    CompileCg(text, {"SHADOWS_DEPTH"});
    CompileCg(text, {"SHADOWS_CUBE"});
}

TEST(BuiltinLibrary, CompilesAnImageEffectThatReadsDepthAndNormals)
{
    const auto pass = CompileCg(R"(
        #include "UnityCG.cginc"
        sampler2D _MainTex; float4 _MainTex_TexelSize; half4 _MainTex_ST;
        UNITY_DECLARE_DEPTH_TEXTURE(_CameraDepthTexture);
        sampler2D_float _CameraDepthNormalsTexture;
        half4 frag(v2f_img i) : COLOR
        {
            float depth; float3 normal;
            float2 uv = UnityStereoScreenSpaceUVAdjust(i.uv, _MainTex_ST);
            #if UNITY_UV_STARTS_AT_TOP
            if (_MainTex_TexelSize.y < 0) uv.y = 1 - uv.y;
            #endif
            DecodeDepthNormal(tex2D(_CameraDepthNormalsTexture, uv), depth, normal);
            depth += Linear01Depth(SAMPLE_DEPTH_TEXTURE(_CameraDepthTexture, uv));
            depth += LinearEyeDepth(SAMPLE_DEPTH_TEXTURE_LOD(_CameraDepthTexture, float4(uv, 0, 0)));
            half4 c = tex2D(_MainTex, uv);
            c.rgb = LinearToGammaSpace(c.rgb) + GammaToLinearSpace(c.rgb) + Luminance(c.rgb);
            return c * depth + half4(normal, EncodeFloatRGBA(depth).x);
        }
        v2f_img vert(appdata_img v) { return vert_img(v); })");
    EXPECT_THAT(TextureNames(*pass),
                testing::UnorderedElementsAre("_MainTex", "_CameraDepthTexture",
                                              "_CameraDepthNormalsTexture"));
}

TEST(BuiltinLibrary, CompilesTheUserInterfaceAndSprites)
{
    CompileCg(R"(
        #include "UnityCG.cginc"
        #include "UnityUI.cginc"
        struct appdata_t { float4 vertex : POSITION; float4 color : COLOR; float2 texcoord : TEXCOORD0; };
        struct v2f
        {
            float4 vertex : SV_POSITION; fixed4 color : COLOR; float2 texcoord : TEXCOORD0;
            float4 worldPosition : TEXCOORD1;
        };
        sampler2D _MainTex; fixed4 _Color; fixed4 _TextureSampleAdd; float4 _ClipRect;
        v2f vert(appdata_t v)
        {
            v2f o;
            o.worldPosition = v.vertex;
            o.vertex = UnityPixelSnap(UnityObjectToClipPos(v.vertex));
            o.texcoord = v.texcoord;
            v.color.rgb = UIGammaToLinear(v.color.rgb);
            o.color = v.color * _Color;
            return o;
        }
        fixed4 frag(v2f i) : SV_Target
        {
            half4 color = (tex2D(_MainTex, i.texcoord) + _TextureSampleAdd) * i.color;
            color.a *= UnityGet2DClipping(i.worldPosition.xy, _ClipRect);
            clip(color.a - 0.001);
            return color;
        })");
    CompileCg("#include \"UnitySprites.cginc\"\n"
              "v2f vert(appdata_t v) { return SpriteVert(v); }\n"
              "fixed4 frag(v2f i) : SV_Target { return SpriteFrag(i); }",
              {"PIXELSNAP_ON"});
}

TEST(BuiltinLibrary, CompilesSoftParticlesAndDistortion)
{
    const auto pass = CompileCg(R"(
        #include "UnityCG.cginc"
        struct v2f
        {
            float4 vertex : SV_POSITION; fixed4 color : COLOR; float2 uv : TEXCOORD0;
            float4 projPos : TEXCOORD1; float4 grabPos : TEXCOORD2;
        };
        sampler2D _MainTex; sampler2D _BumpMap; sampler2D _GrabTexture; float4 _GrabTexture_TexelSize;
        UNITY_DECLARE_DEPTH_TEXTURE(_CameraDepthTexture); float _InvFade;
        v2f vert(appdata_full v)
        {
            v2f o;
            UNITY_INITIALIZE_OUTPUT(v2f, o);
            o.vertex = UnityObjectToClipPos(v.vertex);
            o.projPos = ComputeScreenPos(o.vertex);
            COMPUTE_EYEDEPTH(o.projPos.z);
            o.grabPos = ComputeGrabScreenPos(o.vertex);
            o.color = v.color;
            o.uv = v.texcoord;
            return o;
        }
        fixed4 frag(v2f i) : SV_Target
        {
            float scene = LinearEyeDepth(
                SAMPLE_DEPTH_TEXTURE_PROJ(_CameraDepthTexture, UNITY_PROJ_COORD(i.projPos)));
            i.color.a *= saturate(_InvFade * (scene - i.projPos.z));
            half2 bump = UnpackNormal(tex2D(_BumpMap, i.uv)).rg;
            i.grabPos.xy += bump * _GrabTexture_TexelSize.xy * i.grabPos.z;
            return i.color * tex2D(_MainTex, i.uv) * tex2Dproj(_GrabTexture, UNITY_PROJ_COORD(i.grabPos));
        })");
    EXPECT_EQ(pass->layout.textures.size(), 4u);
}

TEST(BuiltinLibrary, CompilesAToonOutline)
{
    CompileCg(R"(
        #include "UnityCG.cginc"
        float _OutlineWidth; float4 _OutlineColor;
        struct v2f { float4 pos : POSITION; fixed4 color : COLOR; };
        v2f vert(appdata_tan v)
        {
            v2f o;
            TANGENT_SPACE_ROTATION;
            float3 viewDir = mul(rotation, ObjSpaceViewDir(v.vertex));
            o.pos = UnityObjectToClipPos(v.vertex);
            float3 norm = normalize(mul((float3x3)UNITY_MATRIX_IT_MV, v.normal));
            o.pos.xy += TransformViewToProjection(norm.xy) * o.pos.z * _OutlineWidth * viewDir.z;
            o.color = _OutlineColor;
            return o;
        }
        half4 frag(v2f i) : COLOR { return i.color; })");
}

TEST(BuiltinLibrary, CompilesVariationsOfTheStandardShader)
{
    const std::string forward =
        "#include \"UnityStandardCoreForward.cginc\"\n"
        "VertexOutputForwardBase vert(VertexInput v) { return vertBase(v); }\n"
        "half4 frag(VertexOutputForwardBase i) : SV_Target { return ";
    CompileCg(forward + "fragBase(i); }");
    CompileCg("#define UNITY_SETUP_BRDF_INPUT MetallicSetup\n" + forward + "fragBase(i); }",
              {"_NORMALMAP", "_PARALLAXMAP", "_METALLICGLOSSMAP", "_DETAIL_MULX2", "_EMISSION",
               "_ALPHATEST_ON", "FOG_LINEAR"});
    CompileCg("#define UNITY_SETUP_BRDF_INPUT RoughnessSetup\n" + forward + "fragAdd(i); }",
              {"SPOT", "_ALPHAPREMULTIPLY_ON"});
    CompileCg("#include \"UnityStandardShadow.cginc\"\n"
              "limn_ShadowVaryings vert(VertexInput v) { return vertShadowCaster(v); }\n"
              "half4 frag(limn_ShadowVaryings i) : SV_Target { return fragShadowCaster(i); }",
              {"_ALPHATEST_ON"});
    CompileCg("#include \"UnityStandardMeta.cginc\"\n"
              "v2f_meta vert(VertexInput v) { return vert_meta(v); }\n"
              "float4 frag(v2f_meta i) : SV_Target { return frag_meta(i); }");
}

TEST(BuiltinLibrary, CompilesLightingFunctionsCalledByHand)
{
    CompileCg(R"(
        #include "UnityPBSLighting.cginc"
        #include "Lighting.cginc"
        #include "AutoLight.cginc"
        UNITY_DECLARE_TEX2D(_A); UNITY_DECLARE_TEX2D_NOSAMPLER(_B);
        float4 vert(float4 p : POSITION) : SV_Position { return UnityObjectToClipPos(p); }
        half4 frag(float4 pos : SV_POSITION) : SV_Target
        {
            UnityGI gi; UnityGIInput d;
            UNITY_INITIALIZE_OUTPUT(UnityGI, gi);
            UNITY_INITIALIZE_OUTPUT(UnityGIInput, d);
            d.light.color = _LightColor0.rgb;
            d.light.dir = _WorldSpaceLightPos0.xyz;
            SurfaceOutputStandard s;
            UNITY_INITIALIZE_OUTPUT(SurfaceOutputStandard, s);
            s.Albedo = UNITY_SAMPLE_TEX2D(_A, pos.xy) + UNITY_SAMPLE_TEX2D_SAMPLER(_B, _A, pos.xy);
            LightingStandard_GI(s, d, gi);
            half4 c = LightingStandard(s, pos.xyz, gi);
            SurfaceOutputStandardSpecular p;
            UNITY_INITIALIZE_OUTPUT(SurfaceOutputStandardSpecular, p);
            LightingStandardSpecular_GI(p, d, gi);
            c += LightingStandardSpecular(p, pos.xyz, gi);
            SurfaceOutput o;
            UNITY_INITIALIZE_OUTPUT(SurfaceOutput, o);
            LightingLambert_GI(o, d, gi);
            c += LightingLambert(o, gi) + LightingBlinnPhong(o, pos.xyz, gi);
            c += BRDF2_Unity_PBS(c.rgb, c.rgb, 1, 0.5, pos.xyz, pos.xyz, gi.light, gi.indirect);
            Unity_GlossyEnvironmentData g = UnityGlossyEnvironmentSetup(0.5, pos.xyz, c.rgb, c.rgb);
            c.rgb += Unity_GlossyEnvironment(UNITY_PASS_TEXCUBE(unity_SpecCube0), unity_SpecCube0_HDR, g);
            c.rgb += Unity_GlossyEnvironment(UNITY_PASS_TEXCUBE_SAMPLER(unity_SpecCube1, unity_SpecCube0),
                                             unity_SpecCube1_HDR, g);
            c.rgb += DecodeLightmap(UNITY_SAMPLE_TEX2D(unity_Lightmap, pos.xy)) + DecodeRealtimeLightmap(c);
            return c + UnityComputeShadowFade(UnityComputeShadowFadeDistance(pos.xyz, 1));
        })");
}

TEST(BuiltinLibrary, KnowsClipPlanesRgbmAndTheScaleOfAnEye)
{
    CompileCg(R"(
        #include "UnityCG.cginc"
        float4 vert(float4 p : POSITION) : SV_Position { return UnityObjectToClipPos(p); }
        half4 frag(float4 p : SV_Position) : SV_Target
        {
            float inside = dot(unity_CameraWorldClipPlanes[4], p);
            inside += length(p.xyz - _LightPositionRange.xyz) * _LightProjectionParams.z;
            return UnityEncodeRGBM(p.rgb, 5.0) * inside * unity_StereoScaleOffset[0];
        })");
}

} // namespace
} // namespace limn

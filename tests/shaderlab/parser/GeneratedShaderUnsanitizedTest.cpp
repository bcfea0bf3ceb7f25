#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

// Shaders as shader graphs and node editors write them.

namespace limn
{
namespace
{

constexpr const char* k_Includes = "Packages/com.unity.render-pipelines.universal/";

const std::string k_Libraries =
    test::IncludeOf(std::string(k_Includes) + "ShaderLibrary/Core.hlsl") +
    test::IncludeOf("Packages/com.unity.render-pipelines.core/ShaderLibrary/Texture.hlsl") +
    test::IncludeOf(std::string(k_Includes) + "ShaderLibrary/Lighting.hlsl") +
    test::IncludeOf("Packages/com.unity.render-pipelines.core/ShaderLibrary/TextureStack.hlsl") +
    test::IncludeOf(std::string(k_Includes) + "ShaderLibrary/ShaderGraphFunctions.hlsl") +
    test::IncludeOf(std::string(k_Includes) + "Editor/ShaderGraph/Includes/ShaderPass.hlsl");

constexpr const char* k_Members = R"(
    #define ATTRIBUTES_NEED_NORMAL
    #define ATTRIBUTES_NEED_TANGENT
    #define VARYINGS_NEED_POSITION_WS
    #define VARYINGS_NEED_NORMAL_WS
    #define VARYINGS_NEED_TANGENT_WS
    #define VARYINGS_NEED_TEXCOORD0
    #define VARYINGS_NEED_FOG_AND_VERTEX_LIGHT
    #define FEATURES_GRAPH_VERTEX
    #define _NORMALMAP 1
    #define _NORMAL_DROPOFF_TS 1
)";

constexpr const char* k_Graph = R"(
    struct Attributes { float3 positionOS : POSITION; float3 normalOS : NORMAL;
                        float4 tangentOS : TANGENT; float4 uv0 : TEXCOORD0; float4 uv1 : TEXCOORD1;
                        float4 uv2 : TEXCOORD2; };
    struct Varyings { float4 positionCS : SV_POSITION; float3 positionWS; float3 normalWS;
                      float4 tangentWS; float4 texCoord0; float3 sh;
                      float4 fogFactorAndVertexLight; };
    struct PackedVaryings { float4 positionCS : SV_POSITION; float3 a : INTERP0; float3 b : INTERP1;
                            float4 c : INTERP2; float4 d : INTERP3; float3 e : INTERP4;
                            float4 f : INTERP5; };
    PackedVaryings PackVaryings(Varyings i)
    {
        PackedVaryings o; ZERO_INITIALIZE(PackedVaryings, o); o.positionCS = i.positionCS;
        o.a = i.positionWS; o.b = i.normalWS; o.c = i.tangentWS; o.d = i.texCoord0; o.e = i.sh;
        o.f = i.fogFactorAndVertexLight; return o;
    }
    Varyings UnpackVaryings(PackedVaryings i)
    {
        Varyings o; o.positionCS = i.positionCS; o.positionWS = i.a; o.normalWS = i.b;
        o.tangentWS = i.c; o.texCoord0 = i.d; o.sh = i.e; o.fogFactorAndVertexLight = i.f; return o;
    }
    TEXTURE2D(_Map); SAMPLER(sampler_Map); SAMPLER(SamplerState_Linear_Repeat);
    CBUFFER_START(UnityPerMaterial)
    float4 _Map_ST; float4 _Map_TexelSize; float4 _Tint;
    CBUFFER_END
    struct VertexDescriptionInputs { float3 ObjectSpacePosition; float3 ObjectSpaceNormal;
                                     float3 ObjectSpaceTangent; };
    struct VertexDescription { float3 Position; float3 Normal; float3 Tangent; };
    VertexDescription VertexDescriptionFunction(VertexDescriptionInputs IN)
    {
        VertexDescription o = (VertexDescription)0; o.Position = IN.ObjectSpacePosition * 2;
        o.Normal = IN.ObjectSpaceNormal; o.Tangent = IN.ObjectSpaceTangent; return o;
    }
    struct SurfaceDescriptionInputs { float4 uv0; float4 ScreenPosition; };
    struct SurfaceDescription { float3 BaseColor; float3 NormalTS; float3 Emission; float Metallic;
                                float Smoothness; float Occlusion; float Alpha;
                                float AlphaClipThreshold; };
    SurfaceDescription SurfaceDescriptionFunction(SurfaceDescriptionInputs IN)
    {
        SurfaceDescription o = (SurfaceDescription)0;
        UnityTexture2D map = UnityBuildTexture2DStruct(_Map);
        UnityTexture2D plain = UnityBuildTexture2DStructNoScale(_Map);
        UnitySamplerState state = UnityBuildSamplerStateStruct(SamplerState_Linear_Repeat);
        float4 tint = IsGammaSpace() ? LinearToSRGB(_Tint) : _Tint;
        o.BaseColor = (SAMPLE_TEXTURE2D(map.tex, map.samplerstate,
                                        map.GetTransformedUV(IN.uv0.xy)) * tint).rgb
            + plain.Sample(state, IN.ScreenPosition.xy).rgb;
        Gradient g = NewGradient(0, 2, 2, float4(0, 0, 0, 0), float4(1, 1, 1, 1), 0, 0, 0, 0, 0, 0,
                                 float2(1, 0), float2(1, 1), 0, 0, 0, 0, 0, 0);
        o.Emission = g.colors[1].rgb; o.NormalTS = float3(0, 0, 1); o.Smoothness = 0.5;
        o.Occlusion = 1; o.Alpha = tint.a; o.AlphaClipThreshold = 0.5; return o;
    }
    VertexDescriptionInputs BuildVertexDescriptionInputs(Attributes i)
    {
        VertexDescriptionInputs o; ZERO_INITIALIZE(VertexDescriptionInputs, o);
        o.ObjectSpacePosition = i.positionOS; o.ObjectSpaceNormal = i.normalOS;
        o.ObjectSpaceTangent = i.tangentOS.xyz; return o;
    }
    SurfaceDescriptionInputs BuildSurfaceDescriptionInputs(Varyings i)
    {
        SurfaceDescriptionInputs o; ZERO_INITIALIZE(SurfaceDescriptionInputs, o);
        o.uv0 = i.texCoord0; o.ScreenPosition = ComputeScreenPos(
            TransformWorldToHClip(i.positionWS), _ProjectionParams.x); return o;
    }
)";

struct GraphPass
{
    const char* file;
    const char* kind;
};

TEST(GeneratedShader, CompilesEveryPassOfAShaderGraph)
{
    const std::string folder = std::string(k_Includes) + "Editor/ShaderGraph/Includes/";
    for (const GraphPass& item : {GraphPass{"PBRForwardPass", "SHADERPASS_FORWARD"},
                                  {"UnlitPass", "SHADERPASS_UNLIT"},
                                  {"DepthOnlyPass", "SHADERPASS_DEPTHONLY"},
                                  {"ShadowCasterPass", "SHADERPASS_SHADOWCASTER"},
                                  {"DepthNormalsOnlyPass", "SHADERPASS_DEPTHNORMALSONLY"},
                                  {"PBRGBufferPass", "SHADERPASS_GBUFFER"},
                                  {"UnlitGBufferPass", "SHADERPASS_GBUFFER"},
                                  {"PBR2DPass", "SHADERPASS_2D"},
                                  {"LightingMetaPass", "SHADERPASS_META"}})
    {
        SCOPED_TRACE(item.file);
        const bool isMeta = std::string(item.kind) == "SHADERPASS_META";
        const std::string text =
            k_Members + ("#define SHADERPASS " + std::string(item.kind) + "\n") + k_Libraries +
            (isMeta ? test::IncludeOf(std::string(k_Includes) + "ShaderLibrary/MetaInput.hlsl")
                    : "") +
            k_Graph + test::IncludeOf(folder + "Varyings.hlsl") +
            test::IncludeOf(folder + item.file + ".hlsl");
        for (const std::vector<std::string>& keywords :
             {std::vector<std::string>{}, {"_ALPHATEST_ON", "_SURFACE_TYPE_TRANSPARENT"}})
        {
            ShaderCompiler compiler;
            const auto pass = compiler.Compile(test::Program(text), keywords);
            EXPECT_EQ(test::ValidationMessages(pass->vertexSpirv), "");
            EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
        }
    }
}

// A sprite's graph has a colour, texture coordinates and a place on the screen to hand on.
constexpr const char* k_SpriteGraph = R"(
    #define ATTRIBUTES_NEED_NORMAL
    #define ATTRIBUTES_NEED_TANGENT
    #define ATTRIBUTES_NEED_TEXCOORD0
    #define ATTRIBUTES_NEED_COLOR
    #define VARYINGS_NEED_NORMAL_WS
    #define VARYINGS_NEED_TANGENT_WS
    #define VARYINGS_NEED_TEXCOORD0
    #define VARYINGS_NEED_COLOR
    #define VARYINGS_NEED_SCREENPOSITION
    #define FEATURES_GRAPH_VERTEX
    #define CUSTOMINTERPOLATOR_VARYPASSTHROUGH_FUNC CustomInterpolatorPassThroughFunc
    int _ObjectId; int _PassValue; float4 _SelectionID;
    struct Attributes { float3 positionOS : POSITION; float3 normalOS : NORMAL;
                        float4 tangentOS : TANGENT; float4 uv0 : TEXCOORD0; float4 color : COLOR; };
    struct Varyings { float4 positionCS : SV_POSITION; float3 normalWS : INTERP0;
                      float4 tangentWS : INTERP1; float4 texCoord0 : INTERP2;
                      float4 color : INTERP3; float4 screenPosition : INTERP4;
                      float own : INTERP5; };
    #define PackedVaryings Varyings
    Varyings PackVaryings(Varyings v) { return v; }
    Varyings UnpackVaryings(Varyings v) { return v; }
    struct VertexDescriptionInputs { float3 position; float3 normal; float3 tangent; };
    struct VertexDescription { float3 Position; float3 Normal; float3 Tangent; float own; };
    VertexDescription VertexDescriptionFunction(VertexDescriptionInputs i)
    {
        VertexDescription o; o.Position = i.position; o.Normal = i.normal; o.Tangent = i.tangent;
        o.own = i.position.x; return o;
    }
    VertexDescriptionInputs BuildVertexDescriptionInputs(Attributes i)
    {
        VertexDescriptionInputs o; o.position = i.positionOS; o.normal = i.normalOS;
        o.tangent = i.tangentOS.xyz; return o;
    }
    void CustomInterpolatorPassThroughFunc(inout Varyings v, VertexDescription d) { v.own = d.own; }
    struct SurfaceDescriptionInputs { float4 uv0; float own; };
    struct SurfaceDescription { float3 BaseColor; float Alpha; float4 SpriteColor;
                                float4 SpriteMask; float3 NormalTS; float AlphaClipThreshold; };
    SurfaceDescriptionInputs BuildSurfaceDescriptionInputs(Varyings v)
    {
        SurfaceDescriptionInputs i; i.uv0 = v.texCoord0; i.own = v.own; return i;
    }
    SurfaceDescription SurfaceDescriptionFunction(SurfaceDescriptionInputs i)
    {
        SurfaceDescription s; s.BaseColor = i.uv0.xyz; s.Alpha = i.own; s.SpriteColor = i.uv0;
        s.SpriteMask = 1; s.NormalTS = float3(0, 0, 1); s.AlphaClipThreshold = 0.5; return s;
    }
)";

// Generated passes of sprites, and those that select objects in the editor.
TEST(GeneratedShader, CompilesTheOtherPassesOfSpritesAndTheEditor)
{
    const std::string sprites = "Editor/2D/ShaderGraph/Includes/";
    const std::string graphs = "Editor/ShaderGraph/Includes/";
    for (const GraphPass& item : {GraphPass{"SpriteUnlitPass", "SHADERPASS_SPRITEUNLIT"},
                                  {"SpriteLitPass", "SHADERPASS_SPRITELIT"},
                                  {"SpriteNormalPass", "SHADERPASS_SPRITENORMAL"},
                                  {"SpriteForwardPass", "SHADERPASS_SPRITEFORWARD"},
                                  {"SelectionPickingPass", "SHADERPASS_DEPTHONLY"}})
        for (const std::string& folder : {sprites, graphs})
            for (const char* define :
                 {"SCENESELECTIONPASS", "SCENEPICKINGPASS", "UNIVERSAL_USELEGACYSPRITEBLOCKS"})
            {
                SCOPED_TRACE(std::string(item.file) + " " + folder + " " + define);
                if (folder == sprites && std::string(item.file) == "SelectionPickingPass")
                    continue;
                const std::string text =
                    "#define SHADERPASS " + std::string(item.kind) + "\n#define " + define +
                    " 1\n#define ALPHA_CLIP_THRESHOLD 1\n#define _ALPHATEST_ON 1\n" + k_Libraries +
                    k_SpriteGraph + test::IncludeOf(k_Includes + graphs + "Varyings.hlsl") +
                    test::IncludeOf(k_Includes + folder + item.file + ".hlsl");
                ShaderCompiler compiler;
                const auto pass = compiler.Compile(test::Program(text), {});
                EXPECT_EQ(test::ValidationMessages(pass->vertexSpirv), "");
                EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
            }
}

const std::string k_Fullscreen =
    "Packages/com.unity.shadergraph/Editor/Generation/Targets/Fullscreen/Includes/";

// A graph for the whole screen, with Unity 6's macros.
constexpr const char* k_FullscreenGraph = R"(
    struct Attributes { uint vertexID : VERTEXID_SEMANTIC; };
    struct SurfaceDescriptionInputs { float3 WorldSpacePosition; float2 uv; };
    struct Varyings { SV_POSITION_QUALIFIERS float4 positionCS : SV_POSITION;
                      float4 texCoord0 : INTERP0; float4 texCoord1 : INTERP1; };
    #define PackedVaryings Varyings
    Varyings PackVaryings(Varyings v) { return v; }
    Varyings UnpackVaryings(Varyings v) { return v; }
    CBUFFER_START(UnityPerMaterial)
    float4 _Tint; UNITY_TEXTURE_STREAMING_DEBUG_VARS;
    CBUFFER_END
    float _FlipY;
    TEXTURE2D_X(_BlitTexture);
    struct SurfaceDescription { float3 BaseColor; float Alpha; float FullscreenEyeDepth;
                                float FullscreenLinear01Depth; float FullscreenRawDepth; };
    SurfaceDescription SurfaceDescriptionFunction(SurfaceDescriptionInputs IN)
    {
        SurfaceDescription s = (SurfaceDescription)0;
        s.BaseColor = LOAD_TEXTURE2D_X_LOD(_BlitTexture, uint2(IN.uv * _ScreenSize.xy), 0).rgb;
        float4 fog; float density; SHADERGRAPH_FOG(IN.WorldSpacePosition, fog, density);
        s.BaseColor = lerp(s.BaseColor, OklabToLinear(LinearToOklab(fog.rgb)), density);
        s.BaseColor *= SHADERGRAPH_BAKED_GI(IN.WorldSpacePosition, 1, IN.uv, IN.uv, true);
        s.BaseColor *= SHADERGRAPH_BAKED_GI(IN.WorldSpacePosition, 1, (uint2)IN.uv, IN.uv, IN.uv,
                                            true);
        s.BaseColor += SHADERGRAPH_MAIN_LIGHT_DIRECTION() * SHADERGRAPH_OBJECT_POSITION +
            SHADERGRAPH_RENDERER_BOUNDS_MAX - SHADERGRAPH_RENDERER_BOUNDS_MIN;
        s.FullscreenEyeDepth = s.FullscreenLinear01Depth = s.FullscreenRawDepth = 0.5;
        s.Alpha = _Tint.a; return s;
    }
    SurfaceDescriptionInputs BuildSurfaceDescriptionInputs(Varyings input)
    {
        SurfaceDescriptionInputs output;
        float3 normalWS = SHADERGRAPH_SAMPLE_SCENE_NORMAL(input.texCoord0.xy);
        float3 viewDirWS = normalize(input.texCoord1.xyz);
        output.WorldSpacePosition = viewDirWS + normalWS +
            SHADERGRAPH_SAMPLE_SCENE_DEPTH(input.texCoord0.xy);
        output.uv = input.texCoord0.xy; return output;
    }
)";

TEST(GeneratedShader, CompilesPassesForTheWholeScreen)
{
    for (const char* file : {"Blit", "DrawProcedural"})
        for (const char* mode : {"EYE", "LINEAR01", "RAW"})
        {
            SCOPED_TRACE(std::string(file) + " " + mode);
            const std::string text =
                "#define DEPTH_WRITE 1\n#define DEPTH_WRITE_MODE_" + std::string(mode) +
                "\n#define REQUIRE_DEPTH_TEXTURE\n#define REQUIRE_NORMAL_TEXTURE\n" +
                test::IncludeOf(k_Fullscreen + "FullscreenShaderPass.cs.hlsl") + k_Libraries +
                test::IncludeOf("Packages/com.unity.render-pipelines.core/ShaderLibrary/"
                                "DebugMipmapStreamingMacros.hlsl") +
                k_FullscreenGraph + test::IncludeOf(k_Fullscreen + "FullscreenCommon.hlsl") +
                test::IncludeOf(k_Fullscreen + "Fullscreen" + file + ".hlsl");
            ShaderCompiler compiler;
            const auto pass =
                compiler.Compile(test::Program(text), std::vector<std::string>{"FOG_LINEAR"});
            EXPECT_EQ(test::ValidationMessages(pass->vertexSpirv), "");
            EXPECT_EQ(test::ValidationMessages(pass->fragmentSpirv), "");
        }
}

} // namespace
} // namespace limn

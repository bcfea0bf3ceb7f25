#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>

// What shaders of public projects asked the ShaderLibrary for in vain. The values are
// UnseenLibraryGpuTest's.

namespace limn::test
{

namespace
{

constexpr const char* k_Core =
    "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n";

std::string Include(const std::string& file)
{
    return "#include \"Packages/com.unity.render-pipelines." + file + ".hlsl\"\n";
}

/// A pass whose fragment function gives the expression.
std::string Pass(const std::string& declarations, const std::string& result)
{
    return declarations + "float4 vert(float4 p : POSITION) : SV_POSITION { return p; }\n" +
           "float4 frag(float4 p : SV_POSITION) : SV_Target { return " + result + "; }\n";
}

std::shared_ptr<const ShaderProgram> CompileUrp(const std::string& text,
                                                const std::vector<std::string>& keywords = {},
                                                const char* vertex = "vert",
                                                const char* fragment = "frag")
{
    return CompileEntries(text, vertex, fragment, keywords, ProgramLanguage::Hlsl);
}

/// A file of URP's passes behind the properties that it names, but for _BaseMap_ST.
std::string WithoutScale(const std::string& file)
{
    return k_Core + Include("universal/ShaderLibrary/SurfaceInput") +
           "float4 _BaseColor; float _Cutoff; float _BumpScale;\n" +
           Include("universal/Shaders/" + file);
}

constexpr const char* k_ShadowVertex = "ShadowPassVertex";
constexpr const char* k_ShadowFragment = "ShadowPassFragment";

} // namespace

TEST(UnseenLibrary, TakesAnAuthorsEyeIndexBesideItsOwn)
{
    for (const std::string& include : {Include("core/ShaderLibrary/Common"), std::string(k_Core)})
    {
        EXPECT_NO_THROW(CompileUrp(Pass(include, "unity_StereoEyeIndex")));
        EXPECT_NO_THROW(
            CompileUrp(Pass(include + "int unity_StereoEyeIndex;\n", "unity_StereoEyeIndex")));
    }
    const std::string builtin = "#include \"UnityCG.cginc\"\n";
    EXPECT_NO_THROW(CompileCg(Pass(builtin, "unity_StereoEyeIndex")));
    EXPECT_NO_THROW(
        CompileCg(Pass("int unity_StereoEyeIndex;\n" + builtin, "unity_StereoEyeIndex")));
}

TEST(UnseenLibrary, ReadsTheScaleOfATextureOnlyWherePassesTestItsAlpha)
{
    const auto compile = [](const std::string& text, const std::vector<std::string>& keywords)
    {
        CompileUrp(text + Include("universal/Shaders/ShadowCasterPass"), keywords, k_ShadowVertex,
                   k_ShadowFragment);
        CompileUrp(text + Include("universal/Shaders/DepthOnlyPass"), keywords, "DepthOnlyVertex",
                   "DepthOnlyFragment");
        for (const std::string file : {"DepthNormalsPass", "LitDepthNormalsPass"})
        {
            CompileUrp(text + Include("universal/Shaders/" + file), keywords, "DepthNormalsVertex",
                       "DepthNormalsFragment");
        }
    };
    const std::string properties = k_Core + Include("universal/ShaderLibrary/SurfaceInput") +
                                   "float4 _BaseColor; float _Cutoff; float _BumpScale;\n";
    EXPECT_NO_THROW(compile(properties, {}));
    EXPECT_NO_THROW(compile(properties + "float4 _BaseMap_ST;\n", {"_ALPHATEST_ON", "_NORMALMAP"}));
    EXPECT_THROW(compile(properties, {"_ALPHATEST_ON"}), AssetError);
    EXPECT_THROW(CompileUrp(WithoutScale("LitDepthNormalsPass"), {"_NORMALMAP"},
                            "DepthNormalsVertex", "DepthNormalsFragment"),
                 AssetError);
}

TEST(UnseenLibrary, KeepsTheNamesThatEarlierVersionsPassesHad)
{
    const std::string lit =
        Include("universal/Shaders/LitInput") + Include("universal/Shaders/LitForwardPass") + R"(
        Varyings vert(Attributes input)
        {
            Varyings output = (Varyings)0;
            output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
            output.positionWS = TransformObjectToWorld(input.positionOS.xyz);
            output.viewDirWS = GetWorldSpaceViewDir(output.positionWS);
            output.normalWS = TransformObjectToWorldNormal(input.normalOS);
            output.uv = input.texcoord;
            output.lightmapUV = input.lightmapUV * 2;
            output.fogFactor = ComputeFogFactor(output.positionCS.z);
            OUTPUT_LIGHTMAP_UV(input.lightmapUV, unity_LightmapST, output.lightmapUV);
            OUTPUT_SH4(output.positionWS, output.normalWS, output.viewDirWS, output.vertexSH, 0);
            return output;
        }
        float4 frag(Varyings input) : SV_Target
        {
            InputData data;
            InitializeInputData(input, float3(0, 0, 1), data);
            return data.fogCoord + input.viewDirWS.xyzz + input.lightmapUV.xyxy;
        })";
    EXPECT_NO_THROW(CompileUrp(lit));
    EXPECT_NO_THROW(CompileUrp(lit, {"_ADDITIONAL_LIGHTS_VERTEX", "FOG_LINEAR"}));
    const std::string meta = Include("universal/ShaderLibrary/MetaInput") + R"(
        float4 vert(float4 positionOS : POSITION) : SV_POSITION { return positionOS; }
        float4 frag() : SV_Target
        {
            MetaInput meta = (MetaInput)0;
            meta.SpecularColor = float3(0.5, 0.5, 0.5);
            return MetaFragment(meta);
        })";
    EXPECT_NO_THROW(CompileUrp(meta));
}

// URP 10 and later: its own passes read the position whatever keywords there are.
TEST(UnseenLibrary, SaysThatPassesNeedPositions)
{
    const std::string text = Pass(Include("universal/ShaderLibrary/Lighting") + R"(
        #if !defined(REQUIRES_WORLD_SPACE_POS_INTERPOLATOR)
        #error it is needed
        #endif
        )",
                                  "1");
    EXPECT_NO_THROW(CompileUrp(text));
    EXPECT_NO_THROW(CompileUrp(text, {"_MAIN_LIGHT_SHADOWS", "_RECEIVE_SHADOWS_OFF"}));
    EXPECT_NO_THROW(CompileUrp("#define REQUIRES_WORLD_SPACE_POS_INTERPOLATOR 1\n" + text));
}

TEST(UnseenLibrary, HasTheStructsAndFunctionsOfUnity6sSprites)
{
    const std::string core2D = Include("universal/Shaders/2D/Include/Core2D");
    const auto compile = [&](const std::string& kind, const std::string& varyings,
                             const std::string& attributes, const std::string& file)
    {
        return CompileUrp(core2D + "struct Attributes { " + attributes +
                          " half4 color : COLOR; };\n" + "struct Varyings { " + varyings +
                          " half4 color : COLOR; };\n" +
                          Include("universal/Shaders/2D/Include/" + file) +
                          "Varyings vert(Attributes i) { Varyings o = Common" + kind +
                          "Vertex(i); o.color = i.color; return o; }\n" +
                          "half4 frag(Varyings i) : SV_Target { return Common" + kind +
                          "Fragment(i, i.color); }\n");
    };
    EXPECT_NO_THROW(compile("Unlit", "COMMON_2D_OUTPUTS", "COMMON_2D_INPUTS", "2DCommon"));
    EXPECT_NO_THROW(compile("Lit", "COMMON_2D_LIT_OUTPUTS", "COMMON_2D_INPUTS", "Lit2DCommon"));
    EXPECT_NO_THROW(compile("Normals", "COMMON_2D_NORMALS_OUTPUTS", "COMMON_2D_NORMALS_INPUTS",
                            "Normals2DCommon"));
}

TEST(UnseenLibrary, HasAPassOfMotionThatBringsItsPragmas)
{
    for (const std::string& before :
         {std::string(), std::string("#pragma multi_compile _ALPHATEST_ON\n")})
    {
        const PassProgram program = ProgramOf(
            "\n" + before + Include("universal/Shaders/LitInput") +
            "#include_with_pragmas \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/"
            "ObjectMotionVectors.hlsl\"\n");
        ShaderCompiler compiler;
        const std::vector<std::string> keywords =
            before.empty() ? std::vector<std::string>{} : std::vector<std::string>{"_ALPHATEST_ON"};
        EXPECT_NO_THROW(compiler.Compile(program, keywords));
        EXPECT_EQ(compiler.ReadPragmas(program).vertex.name, "vert");
    }
}

TEST(UnseenLibrary, LeavesTheKeywordsOf2DLightsOffByThemselves)
{
    const PassProgram program =
        ProgramOf("\n#pragma vertex vert\n#pragma fragment frag\n#include_with_pragmas "
                  "\"Packages/com.unity.render-pipelines.universal/Shaders/2D/Include/"
                  "ShapeLightShared.hlsl\"\n" +
                  Pass("", "1"));
    const PassProgram whole = ShaderCompiler().ReadPragmas(program);
    ASSERT_EQ(whole.keywordSets.size(), 4u);
    for (const KeywordSet& set : whole.keywordSets)
    {
        EXPECT_EQ(set.keywords.front(), "");
    }
}

TEST(UnseenLibrary, KnowsTheOtherNamesOfOneEye)
{
    const std::string text = R"(
        struct V
        {
            float4 p : SV_POSITION;
            UNITY_VERTEX_OUTPUT_STEREO_EYE_INDEX
            DEFAULT_UNITY_VERTEX_OUTPUT_STEREO_EYE_INDEX
        };
        V vert(float4 p : POSITION)
        {
            V o; o.p = p;
            UNITY_INITIALIZE_OUTPUT_STEREO_EYE_INDEX(o)
            DEFAULT_UNITY_INITIALIZE_OUTPUT_STEREO_EYE_INDEX(o)
            return o;
        }
        float4 frag(V i) : SV_Target { DEFAULT_UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i) return 1; })";
    EXPECT_NO_THROW(CompileUrp(k_Core + text));
    EXPECT_NO_THROW(CompileCg("#include \"UnityCG.cginc\"\n" + text));
    EXPECT_NO_THROW(
        CompileUrp(Pass(k_Core + std::string("SCREENSPACE_TEXTURE(_Map); SAMPLER(sampler_Map);\n"),
                        "SAMPLE_TEXTURE2D_X(_Map, sampler_Map, p.xy)")));
}

TEST(UnseenLibrary, TakesTheBuiltinSupportBeforeOrBehindUrp)
{
    const std::string support = "#include \"HLSLSupport.cginc\"\n";
    for (const std::string& text : {support + k_Core, k_Core + support, std::string(k_Core)})
    {
        EXPECT_NO_THROW(CompileUrp(Pass(text, "TransformStereoScreenSpaceTex(p.xy, 1).xyxy")));
    }
}

TEST(UnseenLibrary, HasFilesBesideThePipelines)
{
    EXPECT_NO_THROW(CompileUrp(Pass(Include("universal-config/Runtime/ShaderConfig.cs"),
                                    "MAX_VISIBLE_LIGHT_COUNT_DESKTOP + "
                                    "MAX_VISIBLE_LIGHT_COUNT_MOBILE + "
                                    "MAX_VISIBLE_LIGHT_COUNT_LOW_END_MOBILE")));
    EXPECT_NO_THROW(
        CompileUrp(Pass("#include \"Packages/com.unity.shadergraph/ShaderGraphLibrary/Nature/"
                        "SpeedTreeCommon.hlsl\"\n",
                        "float4(DoLeafFacing(p.xyz, p.yzx) + "
                        "TransformWindVectorFromWorldToLocalSpace(p.xyz), 1)")));
    EXPECT_NO_THROW(CompileCg(Pass("#include \"UnityLegacyTextureStack.cginc\"\n", "1")));
    EXPECT_NO_THROW(CompileCg(Pass("float3 unity_LightColor0;\n#include \"UnityCG.cginc\"\n",
                                   "float4(unity_LightColor0 + unity_LightColor3, 1)")));
}

TEST(UnseenLibrary, HasTheOldOppositesOfLightmapKeywords)
{
    const std::string text = Pass("#include \"UnityCG.cginc\"\n#ifdef LIGHTMAP_ON\n"
                                  "#if defined(LIGHTMAP_OFF)\n#error both\n#endif\n"
                                  "#elif !LIGHTMAP_OFF || !DIRLIGHTMAP_OFF || !DYNAMICLIGHTMAP_OFF"
                                  "\n#error neither\n#endif\n",
                                  "1");
    EXPECT_NO_THROW(CompileCg(text));
    EXPECT_NO_THROW(CompileEntries(text, "vert", "frag", {"LIGHTMAP_ON"}, ProgramLanguage::Cg));
}

} // namespace limn::test

#include "ShaderTestSupport.h"

#include <limn/shaderlab/PrintShaderLab.h>

namespace limn
{
namespace
{

std::string Print(const std::string& text)
{
    const ShaderLabParseResult result = ParseShaderLab(text, "t.shader");
    EXPECT_FALSE(result.hasErrors()) << testing::PrintToString(test::Messages(result.diagnostics));
    return PrintShaderLab(result.document);
}

/// The lines inside the Pass of Print(), without their indentation.
std::string PrintPass(const std::string& commands)
{
    const std::string text = Print(test::WrapPass(commands));
    const std::string start = "        Pass\n        {\n";
    const std::size_t begin = text.find(start) + start.size();
    std::string lines = text.substr(begin, text.find("        }\n    }\n}\n") - begin);
    for (std::size_t i = 0; (i = lines.find("            ", i)) != std::string::npos;)
    {
        lines.erase(i, 12);
        i = std::min(lines.find('\n', i), lines.size());
    }
    return lines;
}

constexpr const char* k_Canonical = R"(Shader "Folder/Name"
{
    Properties
    {
        [HDR] [MainColor] _Color("Tint", Color) = (1, 0.5, 0, 1)
        _Width("Width", Range(-1, 10)) = 3
        _Tex("Tex", 2DArray) = "white" {}
        _Old("Old", Rect) = "" { TexGen CubeReflect Matrix [_M] }
        [Enum(OFF, 0, ON, 1,] _Int("Int", Int) = 16777216
        _Tiny("a
b", Float) = 0.0000001
        _V("v", Vector) = (1, 2, 3, -0.25)
        _I("i", Integer) = 3
    }
    SubShader
    {
        PackageRequirements { "com.unity.x" : "1.2" "com.unity.y" }
        Tags { "Queue" = "Transparent" "RenderType" = "Opaque" }
        LOD 100
        UsePass "Other/Shader/NAME"
        GrabPass { "_Grab" Name "G" Tags { "LightMode" = "Always" } }
        GrabPass { }
        Pass
        {
            PackageRequirements { "unity" : "2021.2" }
            Name "X"
            Tags { "LightMode" = "ShadowCaster" }
            Cull Front
            ZClip Off
            ZTest Always
            ZWrite Off
            Offset -1, [_Units]
            Conservative On
            Blend SrcAlpha OneMinusSrcAlpha, One Zero
            Blend 1 One One
            BlendOp Max, Add
            ColorMask RGB
            ColorMask [_Mask] 2
            AlphaToMask On
            Stencil
            {
                Ref 5
                ReadMask 15
                WriteMask [_W]
                CompFront Equal
                Pass Replace
            }
            Lighting Off
            HLSLPROGRAM
            float x; // }
            ENDHLSL
        }
        Pass
        {
        }
    }
    SubShader
    {
    }
    Fallback "Diffuse"
    CustomEditor "X"
    CustomEditorForRenderPipeline "E" "P"
    Dependency "A" = "B"
}
)";

TEST(PrintShaderLab, LeavesCanonicalTextAsItIs)
{
    EXPECT_EQ(Print(k_Canonical), k_Canonical);
}

TEST(PrintShaderLab, GivesTextOfTheSameContent)
{
    const ShaderLabDocument document = ParseShaderLab(k_Canonical, "a").document;
    const ShaderLabDocument again = ParseShaderLab(PrintShaderLab(document), "b").document;
    EXPECT_TRUE(SameContent(document, again));
}

TEST(PrintShaderLab, LeavesOutDefaults)
{
    EXPECT_EQ(PrintPass("Cull Back ZTest LEqual ZWrite On ZClip True Offset 0, 0 Blend Off BlendOp "
                        "Add ColorMask RGBA AlphaToMask Off Conservative False Name \"\" Tags { }"),
              "");
}

TEST(PrintShaderLab, SpellsValuesAsUnityDocumentsThem)
{
    EXPECT_EQ(PrintPass("cull FALSE ztest off ZWRITE false blend one oneminusdstalpha COLORMASK "
                        "agb"),
              "Cull Off\nZTest Disabled\nZWrite Off\nBlend One OneMinusDstAlpha\nColorMask GBA\n");
    EXPECT_EQ(PrintPass("ZTest NEqual"), "ZTest NotEqual\n");
}

TEST(PrintShaderLab, PrintsTargetsThatDifferFromMost)
{
    EXPECT_EQ(PrintPass("Blend One One Blend 2 Zero One ColorMask 0 ColorMask RG 3 BlendOp 7 Min"),
              "Blend One One\nBlend 2 Zero One\nBlendOp 7 Min\nColorMask 0\nColorMask RG 3\n");
}

TEST(PrintShaderLab, PrintsBothFacesOfAStencilWhereTheyDiffer)
{
    EXPECT_EQ(PrintPass("Stencil { Fail Zero ZFailBack Invert CompFront Less CompBack Less }"),
              "Stencil\n{\n    Comp Less\n    Fail Zero\n    ZFailBack Invert\n}\n");
    EXPECT_EQ(PrintPass("Stencil { }"), "Stencil\n{\n}\n");
}

TEST(PrintShaderLab, PutsTheStateOfOuterScopesIntoThePass)
{
    EXPECT_EQ(
        Print("Shader \"x\" { Category { ZWrite Off Tags { \"A\"=\"1\" } SubShader { Cull Off "
              "Pass { } } } }"),
        "Shader \"x\"\n{\n    SubShader\n    {\n        Tags { \"A\" = \"1\" }\n        "
        "Pass\n        {\n            Cull Off\n            ZWrite Off\n        }\n    "
        "}\n}\n");
}

TEST(PrintShaderLab, PutsIncludeBlocksIntoTheProgram)
{
    EXPECT_EQ(PrintPass("HLSLINCLUDE\nA\n  ENDHLSL HLSLINCLUDE B ENDHLSL HLSLPROGRAM\nC\nENDHLSL"),
              "HLSLPROGRAM\nA\n   B \n\nC\nENDHLSL\n");
}

TEST(PrintShaderLab, PutsTheStateOfASurfaceShaderInFrontOfItAndTakesItBackBehindIt)
{
    EXPECT_EQ(Print("Shader \"x\" { SubShader { Pass { } Cull Off\nCGPROGRAM\nENDCG\nCull Back "
                    "Pass { } } }"),
              "Shader \"x\"\n{\n    SubShader\n    {\n        Pass\n        {\n        }\n        "
              "Cull Off\n        CGPROGRAM\nENDCG\n        Pass\n        {\n            Cull "
              "Back\n        }\n    }\n}\n");
}

TEST(SameContent, IgnoresPlacesAndFileNames)
{
    const ShaderLabDocument a =
        ParseShaderLab("Shader \"x\" { SubShader { Pass { Cull Off } } }", "a").document;
    const ShaderLabDocument b =
        ParseShaderLab("Shader \"x\"\n{SubShader\n{Pass\n{Cull False}}}", "b").document;
    EXPECT_TRUE(SameContent(a, b));
    EXPECT_FALSE(a == b);
}

TEST(SameContent, SeesEveryDifference)
{
    const ShaderLabDocument document = ParseShaderLab(k_Canonical, "a").document;
    // One replacement in the canonical text for each kind of thing a document holds.
    const std::pair<std::string, std::string> changes[] = {
        {"Folder/Name", "folder/Name"},
        {"[HDR]", "[hdr]"},
        {"\"Tint\"", "\"tint\""},
        {"0.5, 0", "0.25, 0"},
        {"-1, 10", "-1, 11"},
        {"2DArray", "2D"},
        {"Rect", "2D"},
        {"TexGen CubeReflect", "TexGen CubeNormal"},
        {"\"com.unity.y\"", "\"com.unity.z\""},
        {"\"1.2\"", "\"1.3\""},
        {"Transparent", "Overlay"},
        {"LOD 100", "LOD 101"},
        {"/NAME", "/name"},
        {"\"_Grab\"", "\"_grab\""},
        {"GrabPass { }", ""},
        {"Name \"X\"", ""},
        {"ShadowCaster", "Meta"},
        {"ZWrite Off", ""},
        {"[_Units]", "[_units]"},
        {"Blend 1 One One", ""},
        {"Ref 5", ""},
        {"CompFront", "Comp"},
        {"Lighting Off", "Lighting On"},
        {"float x;", "float y;"},
        {"HLSL", "CG"},
        {"SubShader\n    {\n    }", ""},
        {"\"Diffuse\"", "\"Specular\""},
        {"CustomEditor \"X\"", ""},
        {"\"E\" \"P\"", "\"E\" \"Q\""},
        {"\"A\" = \"B\"", "\"A\" = \"C\""},
    };
    for (const auto& [from, to] : changes)
    {
        std::string text = k_Canonical;
        ASSERT_NE(text.find(from), std::string::npos) << from;
        for (std::size_t i = 0; (i = text.find(from, i)) != std::string::npos; i += to.size())
        {
            text.replace(i, from.size(), to);
        }
        const ShaderLabParseResult changed = ParseShaderLab(text, "a");
        EXPECT_FALSE(changed.hasErrors()) << from;
        EXPECT_FALSE(SameContent(document, changed.document)) << from;
    }
}

} // namespace
} // namespace limn

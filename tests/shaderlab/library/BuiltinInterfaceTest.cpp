#include "Mentions.h"
#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>

// The UI Toolkit's and TextCore's files, and those for scripts that draw indirectly or for
// displays.

namespace limn
{
namespace
{

using test::CompileCg;
using test::CompileEntries;
using test::Mentions;
using test::TextureNames;

TEST(BuiltinLibrary, CompilesTheUIToolkit)
{
    const auto standard = CompileCg("#include \"UnityUIE.cginc\"\n");
    EXPECT_EQ(standard->layout.textures.size(), 11u); // 8 slots, font, gradients, information
    CompileCg("#define UIE_CUSTOM_SHADER\n#define UIE_COLORSPACE_GAMMA 1\n"
              "#include \"UnityUIE.cginc\"\n"
              "v2f vert(appdata_t v) { return uie_std_vert(v); }\n"
              "UIE_FRAG_T frag(v2f i) : SV_Target { return 1 - uie_std_frag(i); }");
    CompileCg("#include \"EditorUIE.cginc\"\n"
              "v2f vert(appdata_t v) { return uie_std_vert(v); }\n"
              "fixed4 frag(v2f i) : SV_Target { return uie_editor_frag(i); }");
}

TEST(BuiltinLibrary, CompilesTextOfDistanceFields)
{
    const std::string text = "#include \"UnityCG.cginc\"\n#include \"TextCoreProperties.cginc\"\n"
                             "#include \"TextCore_SDF_SSD.cginc\"\n";
    EXPECT_THAT(TextureNames(*CompileEntries(text, "VertShader", "PixShader")),
                testing::UnorderedElementsAre("_MainTex", "_GUIClipTexture"));
    for (const char* define : {"#define UNDERLAY_ON 1\n#define OUTLINE_ON 1\n",
                               "#define UNDERLAY_INNER 1\n#define FORCE_LINEAR 1\n"})
    {
        SCOPED_TRACE(define);
        CompileEntries(define + text, "VertShader", "PixShader");
    }
}

TEST(BuiltinLibrary, CompilesIndirectDraws)
{
    const std::string text = R"(
        #include "UnityCG.cginc"
        #define UNITY_INDIRECT_DRAW_ARGS IndirectDrawIndexedArgs
        #include "UnityIndirect.cginc"
        StructuredBuffer<float4> _Places;
        float4 vert(uint vertexID : SV_VertexID, uint instanceID : SV_InstanceID) : SV_Position
        {
            InitIndirectDrawArgs(0);
            uint instance = GetIndirectInstanceID(instanceID);
            return UnityObjectToClipPos(_Places[instance + GetIndirectVertexID(vertexID)]);
        }
        fixed4 frag() : SV_Target { return 1; })";
    EXPECT_THAT(test::Messages(CompileCg(text)->diagnostics),
                testing::ElementsAre(Mentions(" note: it uses", "indirect draw", "0")));
    CompileCg(R"(
        #include "UnityCG.cginc"
        #include "UnityIndirect.cginc"
        ByteAddressBuffer _Args;
        float4 vert(uint vertexID : SV_VertexID) : SV_Position
        {
            IndirectDrawArgs args;
            IndirectDrawIndexedArgs indexed;
            GetIndirectDrawArgs(args, _Args, GetCommandID(1));
            GetIndirectDrawArgs(indexed, _Args, 2);
            return GetIndirectVertexID_Base(indexed, vertexID) + GetIndirectVertexCount(args);
        }
        fixed4 frag() : SV_Target { return 1; })");
}

TEST(BuiltinLibrary, CompilesColorsOfDisplays)
{
    CompileCg(R"(
        #include "UnityColorGamut.cginc"
        float4 vert(float4 p : POSITION) : SV_Position { return p; }
        fixed4 frag(float4 p : SV_Position) : SV_Target
        {
            float3 c = SimpleHDRDisplayToneMapAndOETF(p.rgb, kColorGamutHDR10, true, 200, 1000);
            c += InverseSimpleHDRDisplayToneMapAndOETF(c, (int)p.w, false, 200, 1000);
            return fixed4(c, 1);
        })");
}

} // namespace
} // namespace limn

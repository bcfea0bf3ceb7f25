#include "library/BuiltinTestSupport.h"

#include <gmock/gmock.h>

// The UI Toolkit's and TextCore's files.

namespace limn
{
namespace
{

using test::CompileCg;
using test::CompileEntries;
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

} // namespace
} // namespace limn

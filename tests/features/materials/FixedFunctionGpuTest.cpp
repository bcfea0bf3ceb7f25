#include "features/materials/PanelWall.h"

namespace limn::test
{
namespace
{

/// A material whose first pass has no program, and whose second draws red where its state lets it.
std::shared_ptr<const Material> MarkedAndRed(const std::string& first, const std::string& second)
{
    return std::make_shared<const Material>(ShaderOf(
        "Shader \"Test/Marked\" { SubShader {\nPass { " + first +
        " }\nPass { Tags { \"LightMode\" = \"UniversalForward\" } " + second +
        "\nHLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "float4 Vert(float4 p : POSITION) : SV_POSITION { return TransformObjectToHClip(p.xyz); }\n"
        "half4 Frag() : SV_Target { return half4(1, 0, 0, 1); }\nENDHLSL\n} } }"));
}

const glm::dvec4 k_PureWhite(1, 1, 1, 1);
const glm::dvec4 k_PureRed(1, 0, 0, 1);

} // namespace

using FixedFunctionGpu = GpuTest;

TEST_F(FixedFunctionGpu, APassWithoutAProgramDrawsTheMeshInWhite)
{
    PanelWall wall;
    wall.Add(std::make_shared<const Material>(
        ShaderOf("Shader \"Test/White\" { SubShader { Pass { } } }")));
    EXPECT_EQ(k_PureWhite, wall.Draw()[0]);
}

TEST_F(FixedFunctionGpu, APassWithoutAProgramMarksTheStencilAndTheDepth)
{
    const std::string mark = "ZWrite Off ColorMask 0 Stencil { Ref 1 Pass Replace }";
    PanelWall wall;
    wall.background = Color(0, 1, 0, 1);
    wall.Add(MarkedAndRed(mark, "Stencil { Ref 1 Comp Equal }"));
    wall.Add(MarkedAndRed(mark, "Stencil { Ref 1 Comp NotEqual }"));
    wall.Add(MarkedAndRed("ColorMask 0", "ZTest Equal"));
    wall.Add(MarkedAndRed("ColorMask 0", "ZTest Less"));
    const std::vector<glm::dvec4> colors = wall.Draw();
    const glm::dvec3 green(0, 1, 0);
    EXPECT_EQ(k_PureRed, colors[0]);
    EXPECT_EQ(green, glm::dvec3(colors[1]));
    EXPECT_EQ(k_PureRed, colors[2]);
    EXPECT_EQ(green, glm::dvec3(colors[3]));
}

} // namespace limn::test

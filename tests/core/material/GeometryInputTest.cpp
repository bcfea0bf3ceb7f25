#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

/// A draw with a geometry function that has this array of vertices.
void Draw(const std::string& parameter)
{
    const auto shader = test::ShaderOf(R"(Shader "T" { SubShader { Pass { HLSLPROGRAM
        #pragma vertex vert
        #pragma geometry geom
        #pragma fragment frag
        struct v2f { float4 pos : SV_POSITION; };
        v2f vert(float4 p : POSITION) { v2f o; o.pos = p; return o; }
        [maxvertexcount(1)]
        void geom()" + parameter + R"(, inout PointStream<v2f> s) { s.Append(i[0]); }
        float4 frag() : SV_Target { return 1; }
        ENDHLSL } } })");
    test::OneDraw draw;
    draw.Resolve(std::make_shared<Material>(shader, "Grass"));
}

std::string Refusal(const std::string& parameter)
{
    return test::ThrownMessage<ContractError>([&] { Draw(parameter); });
}

} // namespace

TEST(GeometryInput, OfAnythingButTrianglesIsRefusedWhenDrawn)
{
    const auto expected = [](const std::string& taken)
    {
        return test::Mentions("'Grass'", "takes " + taken + ",", "triangles are drawn",
                              "'triangle'");
    };
    EXPECT_THAT(Refusal("point v2f i[1]"), expected("points"));
    EXPECT_THAT(Refusal("line v2f i[2]"), expected("lines"));
    EXPECT_THAT(Refusal("lineadj v2f i[4]"), expected("lines with neighbours"));
    EXPECT_THAT(Refusal("triangleadj v2f i[6]"), expected("triangles with neighbours"));
    EXPECT_NO_THROW(Draw("triangle v2f i[3]"));
}

} // namespace limn

#include "features/materials/PanelWall.h"

namespace limn::test
{
namespace
{

/// A material that shows its normals, with a program's functions before the fragment function.
std::shared_ptr<const Material> ShowingNormals(const std::string& program)
{
    return std::make_shared<const Material>(
        ShaderOf("Shader \"Test/Normals\" { SubShader { Pass {\nHLSLPROGRAM\n#pragma vertex Vert\n"
                 "#pragma fragment Frag\n" +
                 program +
                 "\nhalf4 Frag(Varyings v) : SV_Target { return half4(v.normalWS * 0.5 + 0.5, 1); "
                 "}\nENDHLSL\n} } }"));
}

constexpr const char* k_Structs = R"(
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Tessellation.hlsl"
struct Attributes { float4 positionOS : POSITION; float3 normalOS : NORMAL; };
struct Point { float3 positionWS : INTERNALTESSPOS; float3 normalWS : NORMAL; };
struct Varyings { float4 positionCS : SV_POSITION; float3 normalWS : TEXCOORD0; };
Point Prepare(Attributes a)
{
    Point p;
    p.positionWS = TransformObjectToWorld(a.positionOS.xyz);
    p.normalWS = TransformObjectToWorldNormal(a.normalOS);
    return p;
}
Varyings Finish(float3 position, float3 normal)
{
    Varyings v;
    v.positionCS = TransformWorldToHClip(position + 8 * normal);
    v.normalWS = normal;
    return v;
}
)";

constexpr const char* k_Patch = R"(
#pragma target 5.0
#pragma hull Hull
#pragma domain Domain
struct Factors { float edge[3] : SV_TessFactor; float inside : SV_InsideTessFactor; };
Point Vert(Attributes a) { return Prepare(a); }
Factors Constant(InputPatch<Point, 3> patch, uint id : SV_PrimitiveID)
{
    Factors f;
    float3 factors = GetDistanceBasedTessFactor(patch[0].positionWS, patch[1].positionWS,
                                                patch[2].positionWS, 0, 1, 5);
    f.edge[0] = factors.x;
    f.edge[1] = factors.y;
    f.edge[2] = factors.z;
    f.inside = 1;
    return f;
}
[domain("tri")] [outputcontrolpoints(3)] [outputtopology("triangle_cw")]
[partitioning("fractional_odd")] [patchconstantfunc("Constant")]
Point Hull(InputPatch<Point, 3> patch, uint id : SV_OutputControlPointID) { return patch[id]; }
[domain("tri")]
Varyings Domain(Factors factors, const OutputPatch<Point, 3> patch,
                float3 place : SV_DomainLocation)
{
    float3 position = patch[0].positionWS * place.x + patch[1].positionWS * place.y +
                      patch[2].positionWS * place.z;
    position = PhongTessellation(position, patch[0].positionWS, patch[1].positionWS,
                                 patch[2].positionWS, patch[0].normalWS, patch[1].normalWS,
                                 patch[2].normalWS, place, 0.5);
    return Finish(position, patch[0].normalWS * place.x + patch[1].normalWS * place.y +
                                patch[2].normalWS * place.z);
}
)";

} // namespace

class TessellationGpu : public GpuTest
{
protected:
    TessellationGpu() { m_Flat.camera.farClipPlane = 101.0f; }

    /// Returns the picture of a ball.
    Field Draw(const std::string& program)
    {
        GameObject& ball = m_Flat.Add({16, 16}, {48, 48}, 50, ShowingNormals(program));
        ball.transform.localScale.z = ball.transform.localScale.x;
        ball.renderer->mesh = CreatePrimitive(PrimitiveType::Sphere);
        PictureRun run(m_Flat.scene, m_Flat.camera, 64, 64);
        Field field = run.Color(nullptr);
        ball.activeSelf = false;
        return field;
    }

private:
    FlatScene m_Flat{64, 64};
};

TEST_F(TessellationGpu, MovesTheVerticesOfTheMeshAsTheDomainFunctionDoes)
{
    const Field whole =
        Draw(std::string(k_Structs) + "Varyings Vert(Attributes a) { Point p = Prepare(a); "
                                      "return Finish(p.positionWS, p.normalWS); }");
    const Field patched = Draw(std::string(k_Structs) + k_Patch);
    const Field still =
        Draw(std::string(k_Structs) + "Varyings Vert(Attributes a) { Point p = Prepare(a); "
                                      "return Finish(p.positionWS, 0 * p.normalWS); }");
    EXPECT_EQ(CountDifferent(whole, patched), 0);
    EXPECT_GT(CountDifferent(whole, still), 20) << "the pictures would show no movement";
}

TEST_F(TessellationGpu, GivesThePatchWhatTheVertexFunctionReturnsBySemantics)
{
    const std::string one = std::string(k_Structs) + k_Patch;
    const std::string vertex = "Point Vert(Attributes a) { return Prepare(a); }";
    // The struct of the patch stays. That of the vertex function has the members in another order,
    // and one that the patch does not take.
    for (const auto& [semantic, other] :
         {std::pair("INTERNALTESSPOS", "InternalTessPos0"), std::pair("POSITION", "SV_Position")})
    {
        std::string two = one;
        const std::string_view old = "INTERNALTESSPOS";
        two.replace(two.find(old), old.size(), semantic);
        two.replace(
            two.find(vertex), vertex.size(),
            std::string("struct Moved { float2 uv : TEXCOORD0; float3 normal : Normal; "
                        "float3 place : ") +
                other +
                "; };\nMoved Vert(Attributes a) { Point p = Prepare(a); Moved m = {float2(0, "
                "0), p.normalWS, p.positionWS}; return m; }");
        EXPECT_EQ(CountDifferent(Draw(one), Draw(two)), 0) << other;
        std::string three = two; // the patch's struct by another name
        three.insert(three.find("Factors Constant"), "typedef Point Corner;\n");
        three.replace(three.find("OutputPatch<Point"), 17, "OutputPatch<Corner");
        EXPECT_EQ(CountDifferent(Draw(one), Draw(three)), 0) << other << ", typedef";
    }
}

} // namespace limn::test

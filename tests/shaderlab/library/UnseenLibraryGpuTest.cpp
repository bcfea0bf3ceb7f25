#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <vulkan/GpuTestDevice.h>

// Values of the functions that shaders of public projects asked the ShaderLibrary for in vain.

namespace limn::test
{

namespace
{

using UnseenLibraryValues = GpuTest;

const std::vector<double> k_Fractions = {0.0, 1e-5, 0.1, 0.25, 0.5, 0.6180339, 0.999, 1.0};

} // namespace

TEST_F(UnseenLibraryValues, ColorsMoveTowardsTheirMean)
{
    FunctionGrid grid(CoreInclude("Color"));
    for (const double saturation : {0.0, 0.25, 1.0, 1.5})
    {
        grid.Add("Desaturate(a.xyz, " + std::to_string(saturation) + ")", CombineVectors(Colors()),
                 [saturation](const glm::dvec4& a, auto&, auto&)
                 {
                     const double mean = (a.x + a.y + a.z) / 3.0;
                     return glm::dvec3(mean) + saturation * (glm::dvec3(a) - mean);
                 });
    }
    grid.Run();
}

TEST_F(UnseenLibraryValues, ConesSeeColorsAsTheAppearanceModelSays)
{
    // CIECAM02's matrix behind that of sRGB's primaries, row by row.
    const glm::dmat3 cat02 = glm::transpose(
        glm::dmat3(0.7328, 0.4296, -0.1624, -0.7036, 1.6975, 0.0061, 0.0030, 0.0136, 0.9834));
    const glm::dmat3 toXyz = glm::transpose(
        glm::dmat3(0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505));
    const glm::dmat3 toLms = cat02 * toXyz;
    FunctionGrid grid(CoreInclude("Color"));
    const std::vector<GridInput> colors =
        CombineVectors({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {0.2, 0.5, 0.8}});
    grid.Add("LinearToLMS(a.xyz)", colors,
             [toLms](const glm::dvec4& a, auto&, auto&) { return toLms * glm::dvec3(a); },
             {0.0, 2e-4});
    grid.Add("LMSToLinear(LinearToLMS(a.xyz))", colors,
             [](const glm::dvec4& a, auto&, auto&) { return glm::dvec3(a); }, {0.0, 1e-4});
    grid.Run();
}

TEST_F(UnseenLibraryValues, NumbersInTwoBytesComeBack)
{
    FunctionGrid grid(CoreInclude("Packing"));
    grid.Add("PackFloatToR8G8(a.x)", Combine(k_Fractions),
             [](const glm::dvec4& a, auto&, auto&)
             {
                 const double bits = std::floor(a.x * 65535.0 + 0.5);
                 return glm::dvec2(std::fmod(bits, 256.0), std::floor(bits / 256.0)) / 255.0;
             });
    grid.Add("UnpackFloatFromR8G8(PackFloatToR8G8(a.x))", Combine(k_Fractions),
             [](const glm::dvec4& a, auto&, auto&)
             { return std::floor(a.x * 65535.0 + 0.5) / 65535.0; });
    grid.Run();
}

TEST_F(UnseenLibraryValues, NumbersInSomeBitsComeBack)
{
    FunctionGrid grid(CoreInclude("Packing"));
    // Five bits behind three others.
    grid.Add("(float)PackFloatToUInt(a.x, 3, 5)", Combine(k_Fractions),
             [](const glm::dvec4& a, auto&, auto&) { return std::floor(a.x * 31.0 + 0.5) * 8.0; });
    grid.Add("UnpackUIntToFloat(PackFloatToUInt(a.x, 3, 5) | 7, 3, 5)", Combine(k_Fractions),
             [](const glm::dvec4& a, auto&, auto&) { return std::floor(a.x * 31.0 + 0.5) / 31.0; });
    grid.Add("(float)(PackToR10G10B10A2(float4(a.x, 0, 0, 0)) & 0x3FF)", Combine(k_Fractions),
             [](const glm::dvec4& a, auto&, auto&) { return std::floor(a.x * 1023.0 + 0.5); });
    grid.Add("UnpackFromR10G10B10A2(PackToR10G10B10A2(float4(a.x, 1 - a.x, a.x, a.x)))",
             Combine(k_Fractions),
             [](const glm::dvec4& a, auto&, auto&)
             {
                 const auto inSteps = [](double value, double steps)
                 {
                     return std::floor(value * steps + 0.5) / steps;
                 };
                 return glm::dvec4(inSteps(a.x, 1023.0), inSteps(1.0 - a.x, 1023.0),
                                   inSteps(a.x, 1023.0), inSteps(a.x, 3.0));
             });
    grid.Run();
}

TEST_F(UnseenLibraryValues, ANumberAndAFractionShareAByteAndComeBack)
{
    FunctionGrid grid(CoreInclude("Packing") +
                      "float2 ThereAndBack(float f, uint i) { float fraction; uint number;\n"
                      "UnpackFloatInt8bit(PackFloatInt8bit(f, i, 4), 4, fraction, number);\n"
                      "return float2(fraction, number); }\n");
    // 256 codes for four whole numbers: 64 for the fractions of each.
    const std::vector<double> numbers = {0.0, 1.0, 2.0, 3.0};
    grid.Add("PackFloatInt8bit(a.x, (uint)b.x, 4) * 255", Combine(k_Fractions, numbers),
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             { return a.x * 63.0 + b.x * 64.0; },
             {0.0, 1e-3});
    grid.Add("ThereAndBack(a.x, (uint)b.x)", Combine(k_Fractions, numbers),
             [](const glm::dvec4& a, const glm::dvec4& b, auto&) { return glm::dvec2(a.x, b.x); },
             {0.0, 1e-4});
    grid.Run();
}

TEST_F(UnseenLibraryValues, NormalsInARectangleComeBack)
{
    FunctionGrid grid(CoreInclude("Packing"));
    grid.Add("PackNormalOctRectEncode(a.xyz)", CombineVectors(UnitVectors()),
             [](const glm::dvec4& a, auto&, auto&)
             {
                 const double sum = std::abs(a.x) + std::abs(a.y) + std::abs(a.z);
                 const double side = std::clamp(0.5 - 0.5 * a.x / sum + 0.5 * a.y / sum, 0.0, 1.0);
                 return glm::dvec2(std::copysign(side, a.z), (a.x + a.y) / sum);
             });
    grid.Add("UnpackNormalOctRectEncode(PackNormalOctRectEncode(a.xyz))",
             CombineVectors(UnitVectors()),
             [](const glm::dvec4& a, auto&, auto&) { return glm::dvec3(a); }, {0.0, 2e-6});
    grid.Run();
}

TEST_F(UnseenLibraryValues, ACutOutCoversAPixelByHowFarAlphaIsFromTheThreshold)
{
    // Where alpha does not change from pixel to pixel it is sharpened the most.
    FunctionGrid grid(CoreInclude("Common"));
    const auto add = [&](const std::string& alpha, double covered)
    {
        grid.Add("SharpenAlpha(" + alpha + ", 0.5)", Combine({0.0}),
                 [covered](auto&, auto&, auto&) { return covered; }, {0.0, 1e-3});
    };
    add("0.2", 0.0);
    add("0.49998", 0.3); // 2e-5 of 1e-4 below
    add("0.5", 0.5);
    add("0.50002", 0.7);
    add("0.8", 1.0);
    grid.Run();
}

TEST_F(UnseenLibraryValues, BuiltinNamesOfEarlierVersions)
{
    FunctionGrid grid("#include \"UnityCG.cginc\"\n", ProgramLanguage::Cg);
    grid.SetGlobal("unity_AmbientSky", {0.25f, 0.5f, 0.75f, 1.0f});
    const std::vector<GridInput> inputs = {{{0.5, 0.25, 1, 0.25}, {4, 2, 0, 1}, {}}};
    grid.Add("DecodeHDR(a, b, 0)", inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             { return glm::dvec3(a) * (b.x * std::pow(a.w, b.y)); });
    grid.Add("DecodeHDR(a, b, 1)", inputs,
             [](const glm::dvec4& a, const glm::dvec4& b, auto&)
             { return glm::dvec3(a) * (b.x * a.w); });
    grid.Add("unity_StereoEyeIndex", Combine({0.0}), [](auto&, auto&, auto&) { return 0.0; });
    grid.Run();
}

TEST_F(UnseenLibraryValues, TheAmbientLightHasTheBuiltinPipelinesName)
{
    FunctionGrid grid(
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n");
    grid.SetGlobal("unity_AmbientSky", {0.25f, 0.5f, 0.75f, 1.0f});
    grid.Add("UNITY_LIGHTMODEL_AMBIENT", Combine({0.0}),
             [](auto&, auto&, auto&) { return glm::dvec4(0.25, 0.5, 0.75, 1.0); });
    grid.Run();
}

TEST_F(UnseenLibraryValues, FogReachesTheLightingByEitherOfItsNames)
{
    FunctionGrid grid("#define FOG_EXP 1\n"
                      "#include \"Packages/com.unity.render-pipelines.universal/Shaders/"
                      "LitInput.hlsl\"\n"
                      "#include \"Packages/com.unity.render-pipelines.universal/Shaders/"
                      "LitForwardPass.hlsl\"\n"
                      R"(
        float FogOf(float old, float now)
        {
            Varyings v = (Varyings)0;
            v.normalWS = float3(0, 1, 0);
            v.positionCS = 1;
            v.fogFactorAndVertexLight = old;
            v.fogFactor = now;
            InputData data;
            InitializeInputData(v, float3(0, 0, 1), data);
            return data.fogCoord;
        })");
    grid.Add("FogOf(a.x, 0)", Combine({0.25, 0.75}),
             [](const glm::dvec4& a, auto&, auto&) { return a.x; });
    grid.Add("FogOf(0, a.x)", Combine({0.25, 0.75}),
             [](const glm::dvec4& a, auto&, auto&) { return a.x; });
    grid.Run();
}

TEST_F(UnseenLibraryValues, LeavesTurnAboutTheirAnchorToTheCamera)
{
    FunctionGrid grid("#include \"Packages/com.unity.shadergraph/ShaderGraphLibrary/Nature/"
                      "SpeedTreeCommon.hlsl\"\n"
                      R"(
        float Kind(float w) { bool two; int kind = GetGeometryType(float4(0, 0, 0, w), two); return kind + (two ? 10 : 0); }
        float3 Facing(float4 p, float4 uv2, float4 uv3)
        {
            float3 result; SpeedTree9LeafFacing_float(p.xyz, uv2, uv3, result); return result;
        })");
    // The object and the camera stand as the world does, one unit is one unit.
    const std::vector<float> identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    grid.SetGlobal("unity_MatrixInvV", identity);
    std::ranges::copy(identity, grid.perDraw.objectToWorld);
    std::ranges::copy(identity, grid.perDraw.worldToObject);
    grid.Add("Kind(a.x)", Combine({0, 1, 2, 3, 4, 5}),
             [](const glm::dvec4& a, auto&, auto&) { return a.x > 3.0 ? a.x - 2.0 + 10.0 : a.x; });
    grid.Add(
        "Facing(a, b, 0)", {{{3, 4, 5, 0}, {1, 1, 1, 0}, {}}, {{3, 4, 5, 0}, {1, 1, 1, 1}, {}}},
        [](const glm::dvec4& a, const glm::dvec4& b, auto&)
        {
            const glm::dvec3 arm = glm::dvec3(a) - glm::dvec3(b);
            return b.w > 0.0 ? glm::dvec3(b) + glm::dvec3(arm.x, -arm.z, arm.y) : glm::dvec3(a);
        });
    grid.Run();
}

} // namespace limn::test

#include "hlsl/DialectGpuSupport.h"

#include <bit>
#include <cmath>
#include <functional>
#include <utility>

namespace limn::test
{

TEST_F(HlslDialectValues, ScalarsFillMatrices)
{
    FunctionGrid grid(R"(
        static const float3x3 k_Ones = (float3x3)1;
        static const int3x3 k_Table = {1, 2, 3, 4, 5, 7, 8, 9, 10};
        static const int k_Five = 5;
        static const float3x3 k_All[2] = { (float3x3)-2, (float3x3)k_Five };
        half3x3 Half(int n) { return (half3x3)n; }
        float3 Local() { static const float3x3 k = (float3x3)6; return k[2]; })");
    const std::pair<std::string, std::function<double(const glm::dvec4&)>> scalars[] = {
        {"1",
         [](auto&)
         {
             return 1.0;
         }},
        {"-2",
         [](auto&)
         {
             return -2.0;
         }},
        {"3.5",
         [](auto&)
         {
             return 3.5;
         }},
        {"0x10",
         [](auto&)
         {
             return 16.0;
         }},
        {"7u",
         [](auto&)
         {
             return 7.0;
         }},
        {"true",
         [](auto&)
         {
             return 1.0;
         }},
        {"(int)a.x",
         [](auto& a)
         {
             return std::trunc(a.x);
         }},
        {"-(int)a.x",
         [](auto& a)
         {
             return -std::trunc(a.x);
         }},
        {"uint3(a.xyz)[1]",
         [](auto& a)
         {
             return std::trunc(a.y);
         }},
        {"(a.x > 1)",
         [](auto& a)
         {
             return a.x > 1 ? 1.0 : 0.0;
         }},
        {"a.x",
         [](auto& a)
         {
             return a.x;
         }},
    };
    const auto inputs = std::vector<GridInput>{{{5.75, 2.5, 0, 0}}, {{-0.5, 1, 0, 0}}};
    for (const auto& [scalar, value] : scalars)
    {
        for (const std::string size :
             {"2x2", "2x3", "2x4", "3x2", "3x3", "3x4", "4x2", "4x3", "4x4"})
        {
            const std::string matrix = "((float" + size + ")" + scalar + ")";
            const std::string row = "[" + std::to_string(size[0] - '1') + "]";
            const std::string column = "[" + std::to_string(size[2] - '1') + "]";
            grid.Add("float4(" + matrix + "[0][0], " + matrix + "[0]" + column + ", " + matrix +
                         row + "[0], " + matrix + row + column + ")",
                     inputs,
                     [value = value](auto& a, auto&, auto&) { return glm::dvec4(value(a)); });
        }
    }
    for (const std::string type : {"int", "uint"})
    {
        grid.Add("float3(((" + type + "3x3)2.75)[1])", inputs,
                 [](auto&, auto&, auto&) { return glm::dvec3(2); });
    }
    grid.Add("k_Table[1][2] / 2", inputs, [](auto&, auto&, auto&) { return 3; });
    grid.Add("k_All[0][1] + k_All[1][1] + Local()", inputs,
             [](auto&, auto&, auto&) { return glm::dvec3(-2 + 5 + 6); });
    grid.Add("k_Ones[2]", inputs, [](auto&, auto&, auto&) { return glm::dvec3(1); });
    grid.Add("Half(a.x * 4)[1]", inputs,
             [](auto& a, auto&, auto&) { return glm::dvec3(std::trunc(a.x * 4)); });
    grid.Add("float4x4((int)a.x)[3]", inputs,
             [](auto& a, auto&, auto&) { return glm::dvec4(std::trunc(a.x)); });
    grid.Add("mul((float3x3)(int)a.x, a.xyz)", inputs,
             [](auto& a, auto&, auto&) { return glm::dvec3(std::trunc(a.x) * (a.x + a.y + a.z)); });
    grid.Add("((float2x2)a)[1]", k_Inputs,
             [](auto& a, auto&, auto&) { return glm::dvec2(a.z, a.w); });
    grid.Run();
}

TEST_F(HlslDialectValues, IntegersThatAreNotConstantFillMatrices)
{
    FunctionGrid grid(R"(
        int _N; uint _U; bool _B; int _List[3]; int2 _Pair;
        struct Item { int n; uint list[2]; };
        Item Make(int n) { Item i; i.n = n; i.list[0] = 1; i.list[1] = n + 1; return i; }
        static int s_Sum = 0;
        int Next(int n) { s_Sum += n; return s_Sum; })");
    const auto bits = [](std::int32_t n)
    {
        return std::bit_cast<float>(n);
    };
    grid.SetGlobal("_N", {bits(-7)});
    grid.SetGlobal("_U", {bits(1 << 20)});
    grid.SetGlobal("_B", {bits(1)});
    grid.SetGlobal("_List", {0, 0, 0, 0, bits(11), 0, 0, 0, bits(12)});
    grid.SetGlobal("_Pair", {bits(21), bits(22)});
    const std::pair<std::string, double> scalars[] = {
        {"_N", -7},
        {"-_N", 7},
        {"(_N * 2 + 1)", -13},
        {"_U", 1 << 20},
        {"~_U", 4293918719.0},
        {"_B", 1},
        {"!_B", 0},
        {"_List[1]", 11},
        {"_List[_B + 1]", 12},
        {"_Pair.y", 22},
        {"Make(_N).n", -7},
        {"Make(4).list[1]", 5},
        {"(_N < 0 ? _N : 3)", -7},
        {"min(_N, 2)", -7},
        {"(uint)_Pair.x", 21},
        {"(half)(int)2.75", 2},
    };
    for (const auto& [scalar, value] : scalars)
    {
        for (const std::string size : {"2x3", "4x4"})
        {
            const std::string type = (size[0] == size[2] ? "half" : "float") + size;
            const std::string matrix = "((" + type + ")" + scalar + ")";
            const std::string row = "[" + std::to_string(size[0] - '1') + "]";
            const std::string column = "[" + std::to_string(size[2] - '1') + "]";
            grid.Add("float4(" + matrix + "[0][0], " + matrix + "[0]" + column + ", " + matrix +
                         row + "[0], " + matrix + row + column + ")",
                     k_Once, [value = value](auto&, auto&, auto&) { return glm::dvec4(value); });
        }
    }
    grid.Add("float2(((float3x3)Next(3))[1][2], s_Sum)", {{}},
             [](auto&, auto&, auto&) { return glm::dvec2(3); });
    grid.Run();
}

TEST_F(HlslDialectValues, ScalarsFillMatricesByEveryNameAndWithoutACast)
{
    FunctionGrid grid(R"(
        int _N;
        typedef float3x3 Basis; typedef Basis Frame; typedef matrix<float, 2, 3> Wide;
        float3x3 Initial(int n) { float3x3 m = n; return m; }
        float3x3 Literal() { float3x3 m = 2; return m; }
        float3x3 Assigned(int n) { float3x3 m; m = n; return m; }
        float3x3 Returned(int n) { return n; }
        float3x3 Passed(float3x3 m) { return m; }
        float3x3 Sum(float3x3 m, int n) { m += n; m *= 2; m = m + n * 10; return 3 - m; }
        static float3x3 s_Static = (float3x3)_N;
        float3 Local() { static const float3x3 k = (float3x3)_N; return k[2]; })");
    grid.SetGlobal("_N", {std::bit_cast<float>(5)});
    const auto all = [](double value)
    {
        return [value](auto&, auto&, auto&)
        {
            return glm::dvec3(value);
        };
    };
    for (const std::string type :
         {"Basis", "Frame", "Wide", "matrix<float, 3, 3>", "matrix<half,4,3>"})
    {
        grid.Add("((" + type + ")_N)[1]", k_Once, all(5));
        grid.Add("((" + type + ")2)[1]", k_Once, all(2));
    }
    grid.Add("Basis(_N)[2]", k_Once, all(5));
    grid.Add("matrix<float, 3, 3>(_N)[2]", k_Once, all(5));
    for (const std::string call : {"Initial(_N)", "Assigned(_N)", "Returned(_N)", "Passed(_N)"})
    {
        grid.Add(call + "[1]", k_Once, all(5));
    }
    grid.Add("Literal()[2]", k_Once, all(2));
    grid.Add("Returned(-3)[0]", k_Once, all(-3));
    grid.Add("Passed(4)[0]", k_Once, all(4));
    grid.Add("Sum((float3x3)a.x, _N)[1]", k_Inputs,
             [](auto& a, auto&, auto&) { return glm::dvec3(3 - ((a.x + 5) * 2 + 50)); });
    grid.Add("s_Static[1]", k_Once, all(5));
    grid.Add("Local()", k_Once, all(5));
    grid.Add("(_N > 2 ? (float3x3)_N : (float3x3)1)[0]", k_Once, all(5));
    grid.Run();
}

TEST_F(HlslDialectValues, MatrixSwizzlesEvaluateTheirOperandOnce)
{
    FunctionGrid grid(R"(
        static float s_Calls = 0;
        float4x4 Next(float x) { s_Calls += 1; return (float4x4)(x + s_Calls); }
        float3 Calls(float x) { s_Calls = 0; float2 v = Next(x)._m03_m13; return float3(v, s_Calls); }
        float3x4 m(float4 a, float4 b, float4 c) { return float3x4(a, b, c); }
        static const float2x2 k_Square = float2x2(1, 2, 3, 4);
        static const float2 k_Pair = k_Square._m10_m01;)");
    grid.Add("k_Pair", k_Inputs, [](auto&, auto&, auto&) { return glm::dvec2(3, 2); });
    grid.Add("Calls(a.x)", k_Inputs,
             [](auto& a, auto&, auto&) { return glm::dvec3(a.x + 1, a.x + 1, 1); });
    grid.Add("m(a, b, c)._m03_m12_m20.zxyy", k_Inputs,
             [](auto& a, auto& b, auto& c) { return glm::dvec4(c.x, a.w, b.z, b.z); });
    grid.Add("(float3x3(a.xyz, b.xyz, c.xyz))._11_32", k_Inputs,
             [](auto& a, auto&, auto& c) { return glm::dvec2(a.x, c.y); });
    grid.Add("m(a, b, c)._m01_m02.y", k_Inputs, [](auto& a, auto&, auto&) { return a.z; });
    grid.Run();
}

} // namespace limn::test

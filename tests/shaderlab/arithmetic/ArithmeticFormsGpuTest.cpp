#include "vulkan/compute/ComputeRun.h"

#include <cmath>
#include <string>
#include <vector>

// Remainders and rounding in every form that HLSL writes them in.

namespace limn::test
{

namespace
{

class ArithmeticFormsGpu : public GpuTest
{
};

struct Form
{
    const char* hlsl; ///< a float
    float wanted;
};

/// What the forms give, "" where it is what is wanted.
std::string Differences(const std::string& declarations, const std::vector<Form>& forms)
{
    std::string body;
    for (std::size_t i = 0; i < forms.size(); ++i)
    {
        body += "_Out[" + std::to_string(i) + "] = " + forms[i].hlsl + ";\n";
    }
    const auto shader = MakeKernel(
        "1, 1, 1", "StructuredBuffer<float> _In; RWStructuredBuffer<float> _Out;\n" + declarations,
        body);
    const auto in = MakeBuffer(std::vector<float>{-1.3f, 1.0f, 2.5f, -7.0f, 3.0f});
    const auto out = MakeBuffer(std::vector<float>(forms.size()));
    CommandBuffer cmd;
    cmd.SetComputeBufferParam(shader, 0, "_In", in);
    cmd.SetComputeBufferParam(shader, 0, "_Out", out);
    cmd.DispatchCompute(shader, shader->FindKernel("K"), 1, 1, 1);
    RunCommands(cmd);
    const auto results = DataOf<float>(*out);
    std::string report;
    for (std::size_t i = 0; i < forms.size(); ++i)
    {
        if (std::abs(results[i] - forms[i].wanted) > 1e-6f)
        {
            report += std::string(forms[i].hlsl) + " is " + std::to_string(results[i]) +
                      " instead of " + std::to_string(forms[i].wanted) + "\n";
        }
    }
    return report;
}

} // namespace

TEST_F(ArithmeticFormsGpu, TakeTheSignOfWhatIsDivided)
{
    EXPECT_EQ("",
              Differences("#define X _In[0]\n#define Y _In[1]\n#define M _In[3]\n#define N _In[4]",
                          {{"fmod(X, Y)", -0.3f},
                           {"X % Y", -0.3f},
                           {"(int)M % (int)N", -1.0f},
                           {"-(int)M % -(int)N", 1.0f},
                           {"fmod(float2(X, M), Y).x", -0.3f},
                           {"fmod(M, float3(Y, N, N)).z", -1.0f},
                           {"(float4(X, M, X, M) % float4(Y, N, Y, N)).w", -1.0f},
                           {"(int3(M, M, M) % (int)N).y", -1.0f},
                           {"(int)M % int4(1, 2, 3, 4).z", -1.0f},
                           {"fmod(float2x2(X, M, X, M), float2x2(Y, N, Y, N))[1][1]", -1.0f},
                           {"(float2x2(X, M, X, M) % float2x2(Y, N, Y, N))[1][1]", -1.0f},
                           {"fmod((half)M, (half)N)", -1.0f},
                           {"(min16float)M % (min16float)N", -1.0f},
                           {"(min16int)M % (min16int)N", -1.0f},
                           {"(min16uint)-M % (min16uint)N", 1.0f},
                           {"(uint)N % (uint)2", 1.0f}}));
}

TEST_F(ArithmeticFormsGpu, TakeTheSignOfConstants)
{
    EXPECT_EQ("",
              Differences("static const float s_Rest = fmod(-1.3, 1.0);\n"
                          "static const float2 s_Rests = float2(-7.5, 7.5) % float2(2, -2);\n"
                          "static const float s_Whole = fmod(-7, 2);\n"
                          "static float s_Changed = -1.3 % 1;\n"
                          "static const int s_Size = fmod(7, 4);\n"
                          "float Local() { static const float k = fmod(-1.3, 1.0); return k; }\n"
                          "float Sized() { float a[-7 % 3 + 3]; a[1] = 5; return a[1]; }\n",
                          {{"s_Rest", -0.3f},
                           {"s_Rests.x", -1.5f},
                           {"s_Rests.y", 1.5f},
                           {"s_Whole", -1.0f},
                           {"s_Changed", -0.3f},
                           {"s_Size", 3.0f},
                           {"Local()", -0.3f},
                           {"Sized()", 5.0f},
                           {"fmod(-1.3, 1.0)", -0.3f},
                           {"-1.3 % 1.0", -0.3f},
                           {"5.5h % 2", 1.5f},
                           {"fmod(float3(-1.3, 1, 2), 1).x", -0.3f},
                           {"-7 % 3", -1.0f},
                           {"(int2(-7, 7) % int2(3, -3)).x", -1.0f},
                           {"fmod(fmod(-7.5, 4), 2)", -1.5f}}));
}

TEST_F(ArithmeticFormsGpu, RoundHalfToEven)
{
    EXPECT_EQ("", Differences("static const float s_Even = round(2.5);\n"
                              "static const float3 s_Evens = round(float3(-2.5, 3.5, -0.5));\n"
                              "static const float2 s_Others = round(float2(2.4999, -3.5001));\n",
                              {{"round(_In[2])", 2.0f},
                               {"round(-_In[2])", -2.0f},
                               {"round(_In[2] + 1)", 4.0f},
                               {"round(float3(_In[2], 1.5, 0.5)).x", 2.0f},
                               {"round(float3(_In[2], 1.5, 0.5)).z", 0.0f},
                               {"round(float2x2(_In[2], 1.5, 0.5, -2.5))[1].y", -2.0f},
                               {"round((half)_In[2])", 2.0f},
                               {"s_Even", 2.0f},
                               {"s_Evens.x", -2.0f},
                               {"s_Evens.y", 4.0f},
                               {"s_Evens.z", 0.0f},
                               {"s_Others.x", 2.0f},
                               {"s_Others.y", -4.0f},
                               {"round(2.5)", 2.0f},
                               {"round(-2.5)", -2.0f},
                               {"round(0.5)", 0.0f},
                               {"round(1.5)", 2.0f},
                               {"round(float2(4.5, 5.5)).x", 4.0f},
                               {"round(3)", 3.0f}}));
}

// spirv-opt makes x / -c of -(x / c), of numbers without a sign as well.
TEST_F(ArithmeticFormsGpu, NegateNumbersWithoutASign)
{
    EXPECT_EQ("", Differences("", {{"-((uint)_In[4] / 2u) == 4294967295u", 1.0f},
                                   {"(-(uint)_In[4]) / 2u == 2147483646u", 1.0f},
                                   {"-((uint2)_In[4] / 3u).y == 4294967295u", 1.0f},
                                   {"(-(uint3)_In[4] % 7u).z == 1u", 1.0f},
                                   {"-((uint)_In[4] * 2u) == 4294967290u", 1.0f},
                                   {"(int)-((min16uint)_In[4] / (min16uint)2) == -1", 1.0f},
                                   {"-((int)_In[3] / 2) == 3", 1.0f}}));
}

// Direct3D: what is out of range becomes the nearest integer, NaN becomes 0.
TEST_F(ArithmeticFormsGpu, ClampConstantsThatIntegersCannotHold)
{
    EXPECT_EQ("", Differences("float Declared() { int i = 1e20; return i == 2147483647; }\n"
                              "float Assigned() { uint u; u = -1.5; return u; }\n"
                              "float Several() { int2 v = float2(-1e10, 0.0 / 0.0); "
                              "return (v.x == -2147483647 - 1) + 2 * (v.y == 0); }\n"
                              "float Sized() { const int n = 2.5 * 2; float a[n]; a[4] = n; "
                              "return a[4]; }\n",
                              {{"Declared()", 1.0f},
                               {"Assigned()", 0.0f},
                               {"Several()", 3.0f},
                               {"Sized()", 5.0f},
                               {"(int)1e20 == 2147483647", 1.0f},
                               {"uint(4e20) == 0xffffffff", 1.0f},
                               {"(uint)(-3.5)", 0.0f},
                               {"(int)-3.5", -3.0f}}));
}

} // namespace limn::test

#include "compute/ComputeRun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace limn::test
{

namespace
{

class KernelGpu : public GpuTest
{
};

using Uint4 = std::array<std::uint32_t, 4>;

} // namespace

// Every thread of 3x2x2 groups of 4x2x3 notes its system values where its place in the whole grid
// says.
TEST_F(KernelGpu, GivesEachThreadItsNumbers)
{
    const auto shader = MakeKernel(
        "4, 2, 3", "RWStructuredBuffer<uint4> _Ids; RWStructuredBuffer<uint4> _Groups;",
        "uint place = (id.z * 4 + id.y) * 12 + id.x;\n"
        "_Ids[place] = uint4(id, index); _Groups[place] = uint4(group, local.x + 10 * local.y + "
        "100 * local.z);");
    const auto ids = MakeBuffer(std::vector<Uint4>(12 * 4 * 6));
    const auto groups = MakeBuffer(std::vector<Uint4>(12 * 4 * 6));
    CommandBuffer cmd;
    cmd.SetComputeBufferParam(shader, 0, "_Ids", ids);
    cmd.SetComputeBufferParam(shader, 0, "_Groups", groups);
    cmd.DispatchCompute(shader, shader->FindKernel("K"), 3, 2, 2);
    RunCommands(cmd);
    const auto seenIds = DataOf<Uint4>(*ids);
    const auto seenGroups = DataOf<Uint4>(*groups);
    for (std::uint32_t z = 0; z < 6; ++z)
    {
        for (std::uint32_t y = 0; y < 4; ++y)
        {
            for (std::uint32_t x = 0; x < 12; ++x)
            {
                const std::size_t place = (z * 4 + y) * 12 + x;
                const std::uint32_t index = (z % 3 * 2 + y % 2) * 4 + x % 4;
                ASSERT_EQ(seenIds[place], (Uint4{x, y, z, index}));
                ASSERT_EQ(seenGroups[place],
                          (Uint4{x / 4, y / 2, z / 3, x % 4 + 10 * (y % 2) + 100 * (z % 3)}));
            }
        }
    }
}

// 1000 numbers, whose number is no multiple of the group's 64.
TEST_F(KernelGpu, SumsUpInMemoryOfTheGroup)
{
    const auto shader =
        MakeKernel("64, 1, 1",
                   "StructuredBuffer<uint> _In; RWStructuredBuffer<uint> _Sums; uint _Count;\n"
                   "groupshared uint parts[64];",
                   "parts[index] = id.x < _Count ? _In[id.x] : 0;\n"
                   "GroupMemoryBarrierWithGroupSync();\n"
                   "[unroll] for (uint step = 32; step > 0; step /= 2)\n{\n"
                   "    if (index < step) { parts[index] += parts[index + step]; }\n"
                   "    GroupMemoryBarrierWithGroupSync();\n}\n"
                   "if (index == 0) { _Sums[group.x] = parts[0]; }");
    std::vector<std::uint32_t> numbers(1000);
    for (std::uint32_t i = 0; i < 1000; ++i)
    {
        numbers[i] = i * i + 7;
    }
    const auto sums = MakeBuffer(std::vector<std::uint32_t>(16));
    shader->SetBuffer(0, "_In", MakeBuffer(numbers));
    shader->SetBuffer(0, "_Sums", sums);
    shader->SetInt("_Count", 1000);
    CommandBuffer cmd;
    cmd.DispatchCompute(shader, 0, (1000 + 63) / 64, 1, 1);
    RunCommands(cmd);
    const auto seen = DataOf<std::uint32_t>(*sums);
    for (std::size_t group = 0; group < 16; ++group)
    {
        const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(group * 64);
        const auto end = numbers.begin() +
                         static_cast<std::ptrdiff_t>(std::min<std::size_t>(1000, group * 64 + 64));
        EXPECT_EQ(seen[group], std::accumulate(begin, end, 0u)) << group;
    }
}

TEST_F(KernelGpu, WritesTexturesWhoseSizeIsNoMultipleOfTheGroup)
{
    const auto shader =
        MakeKernel("8, 8, 1", "RWTexture2D<float4> _Result;",
                   "uint2 size; _Result.GetDimensions(size.x, size.y);\n"
                   "if (any(id.xy >= size)) { return; }\n"
                   "_Result[id.xy] = float4(id.x / 32.0, id.y * id.y, id.x * id.y, size.x);");
    for (const auto& [width, height] : {std::pair(13, 9), std::pair(1, 1), std::pair(8, 17)})
    {
        const TargetPtr result = MakeWritable(width, height);
        shader->SetTexture(0, "_Result", result);
        CommandBuffer cmd;
        cmd.DispatchCompute(shader, 0, (width + 7) / 8, (height + 7) / 8, 1);
        RunCommands(cmd, {result});
        const Image image = ReadRows(*result);
        for (int y = 0; y < height; ++y)
        {
            for (int x = 0; x < width; ++x)
            {
                const auto fx = static_cast<float>(x);
                const auto fy = static_cast<float>(y);
                ASSERT_EQ(
                    TexelFloat(image, x, y),
                    (std::array<float, 4>{fx / 32.0f, fy * fy, fx * fy, static_cast<float>(width)}))
                    << x << ", " << y;
            }
        }
    }
}

TEST_F(KernelGpu, ReadsAndWritesTexturesOfEachFormat)
{
    const auto shader = MakeKernel("4, 4, 1", "RWTexture2D<float4> _Result; float4 _Added;",
                                   "_Result[id.xy] = _Result[id.xy] * 0.5 + _Added;");
    shader->SetVector("_Added", {0.25f, 0.5f, 0.125f, 0.75f});
    for (const GraphicsFormat format :
         {GraphicsFormat::R8_UNorm, GraphicsFormat::R8G8B8A8_UNorm, GraphicsFormat::R16G16_SFloat,
          GraphicsFormat::R16G16B16A16_SFloat, GraphicsFormat::R32_SFloat,
          GraphicsFormat::R32G32B32A32_SFloat, GraphicsFormat::B10G11R11_UFloatPack32})
    {
        const TargetPtr result = MakeWritable(4, 4, format, ToString(format));
        const TargetPtr copy = MakeTarget(4, 4, GraphicsFormat::R32G32B32A32_SFloat);
        CommandBuffer cmd;
        CoreUtils::SetRenderTarget(cmd, RTHandle(result), ClearFlag::Color, {1, 0, 0, 0});
        cmd.SetComputeTextureParam(shader, 0, "_Result", RTHandle(result));
        cmd.DispatchCompute(shader, 0, 1, 1, 1);
        cmd.DispatchCompute(shader, 0, 1, 1, 1);
        const auto show = MakeKernel("4, 4, 1", "Texture2D<float4> _From; RWTexture2D<float4> _To;",
                                     "_To[id.xy] = _From.Load(int3(id.xy, 0));");
        const TargetPtr seen = MakeWritable(4, 4);
        cmd.SetComputeTextureParam(show, 0, "_From", RTHandle(result));
        cmd.SetComputeTextureParam(show, 0, "_To", RTHandle(seen));
        cmd.DispatchCompute(show, 0, 1, 1, 1);
        RunCommands(cmd, {seen});
        // ((1, 0, 0, 0) / 2 + a) / 2 + a, as far as the format goes
        const float red = (0.5f + 0.25f) / 2 + 0.25f;
        const int channels = ChannelCount(format);
        const std::array<float, 4> wanted{red, channels > 1 ? 0.75f : 0.0f,
                                          channels > 2 ? 0.1875f : 0.0f,
                                          channels > 3 ? 1.125f : 1.0f};
        const auto texel = TexelFloat(ReadRows(*seen), 3, 2);
        for (std::size_t i = 0; i < 4; ++i)
        {
            const bool isByte = BytesPerTexel(format) == channels;
            const float top = isByte ? std::min(wanted[i], 1.0f) : wanted[i];
            EXPECT_NEAR(texel[i], top, isByte ? 1.5f / 255 : 0.0f) << ToString(format) << " " << i;
        }
    }
}

TEST_F(KernelGpu, FindsParametersAsTheyWereSet)
{
    const auto shader = MakeKernel(
        "1, 1, 1",
        "cbuffer Params { float _Float; int _Int; uint _Uint; float2 _Float2; int3 _Int3;\n"
        "float4x4 _Matrix; float4 _Vectors[3]; float _Array[3]; float4x4 _Matrices[2]; bool _Bool;"
        "};\nfloat4 _Loose; float3x3 _Small; RWStructuredBuffer<float4> _Out;",
        "_Out[0] = float4(_Float, _Int, _Uint, _Bool ? 5 : 6); _Out[1] = float4(_Float2, 0, 0);\n"
        "_Out[2] = float4(_Int3, 0); _Out[3] = mul(_Matrix, float4(1, 10, 100, 1000));\n"
        "_Out[4] = mul(float4(1, 10, 100, 1000), _Matrix); _Out[5] = _Vectors[0] + _Vectors[2];\n"
        "_Out[6] = float4(_Array[0], _Array[1], _Array[2], 0); _Out[7] = _Loose;\n"
        "_Out[8] = mul(_Matrices[1], float4(1, 10, 100, 1000));\n"
        "_Out[9] = float4(_Matrix[1][2], _Matrix._m21, _Matrix._m00, _Matrix[3].x);");
    const auto out = MakeBuffer(std::vector<glm::vec4>(10));
    const glm::mat4 matrix(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
    CommandBuffer cmd;
    cmd.SetComputeFloatParam(shader, "_Float", 1.5f);
    cmd.SetComputeIntParam(shader, "_Int", -3);
    cmd.SetComputeIntParam(shader, "_Uint", 70000);
    cmd.SetComputeIntParam(shader, "_Bool", 1);
    cmd.SetComputeFloatParams(shader, "_Float2", {2.5f, 3.5f});
    cmd.SetComputeIntParams(shader, "_Int3", 4, -5, 6); // as C# has them
    cmd.SetComputeMatrixParam(shader, "_Matrix", matrix);
    cmd.SetComputeVectorArrayParam(shader, "_Vectors",
                                   {{1, 2, 3, 4}, {9, 9, 9, 9}, {10, 20, 30, 40}});
    cmd.SetComputeFloatParams(shader, "_Array", {7, 0, 0, 0, 8, 0, 0, 0, 9});
    cmd.SetComputeMatrixArrayParam(shader, "_Matrices", {glm::mat4(0.0f), glm::mat4(2.0f)});
    cmd.SetComputeVectorParam(shader, "_Loose", {11, 12, 13, 14});
    cmd.SetComputeBufferParam(shader, 0, "_Out", out);
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    RunCommands(cmd);
    const auto seen = DataOf<glm::vec4>(*out);
    const glm::vec4 v(1, 10, 100, 1000);
    EXPECT_EQ(seen[0], glm::vec4(1.5f, -3, 70000, 5));
    EXPECT_EQ(seen[1], glm::vec4(2.5f, 3.5f, 0, 0));
    EXPECT_EQ(seen[2], glm::vec4(4, -5, 6, 0));
    EXPECT_EQ(seen[3], glm::vec4(1 + 50 + 900 + 13000, 2 + 60 + 1000 + 14000, 3 + 70 + 1100 + 15000,
                                 4 + 80 + 1200 + 16000));
    EXPECT_EQ(seen[4], glm::vec4(4321, 8765, 13209, 17653)) << "a row vector times the matrix";
    EXPECT_EQ(seen[5], glm::vec4(11, 22, 33, 44));
    EXPECT_EQ(seen[6], glm::vec4(7, 8, 9, 0));
    EXPECT_EQ(seen[7], glm::vec4(11, 12, 13, 14));
    EXPECT_EQ(seen[8], v * 2.0f);
    EXPECT_EQ(seen[9], glm::vec4(matrix[2][1], matrix[1][2], matrix[0][0], matrix[0][3]))
        << "rows first";
}

TEST_F(KernelGpu, SetsParametersInTheOrderOfTheCommands)
{
    const auto shader = MakeKernel("1, 1, 1",
                                   "int _Place; float _Value; "
                                   "RWStructuredBuffer<float> _Out;",
                                   "_Out[_Place] = _Value;");
    const auto out = MakeBuffer(std::vector<float>(4));
    CommandBuffer cmd;
    shader->SetBuffer(0, "_Out", out);
    for (int i = 0; i < 4; ++i)
    {
        cmd.SetComputeIntParam(shader, "_Place", i);
        cmd.SetComputeFloatParam(shader, "_Value", static_cast<float>(i * i + 1));
        cmd.DispatchCompute(shader, 0, 1, 1, 1);
    }
    shader->SetFloat("_Value", 77.0f); // before the buffer is executed: it sets others
    RunCommands(cmd);
    EXPECT_EQ(DataOf<float>(*out), (std::vector<float>{1, 2, 5, 10}));
    EXPECT_EQ(std::get<float>(*shader->Find(0, "_Value")), 10.0f) << "and from then on";
}

TEST_F(KernelGpu, PicksVariantsByKeywords)
{
    const auto shader =
        MakeCompute("#pragma kernel K\n#pragma multi_compile _ TWICE THRICE\n"
                    "#pragma multi_compile_local _ NEGATIVE\n"
                    "RWStructuredBuffer<int> _Out; int _Place;\n"
                    "[numthreads(1, 1, 1)] void K()\n{\nint value = 10;\n"
                    "#if defined(TWICE)\nvalue *= 2;\n#elif defined(THRICE)\n"
                    "value *= 3;\n#endif\n#ifdef NEGATIVE\nvalue = -value;\n#endif\n"
                    "_Out[_Place] = value;\n}\n");
    const auto out = MakeBuffer(std::vector<int>(5));
    shader->SetBuffer(0, "_Out", out);
    CommandBuffer cmd;
    int place = 0;
    const auto run = [&]
    {
        cmd.SetComputeIntParam(shader, "_Place", place++);
        cmd.DispatchCompute(shader, 0, 1, 1, 1);
    };
    run();
    cmd.EnableKeyword(shader, "TWICE");
    run();
    cmd.EnableShaderKeyword("THRICE"); // global, behind the shader's own
    cmd.EnableKeyword(shader, "NEGATIVE");
    cmd.DisableKeyword(shader, "TWICE");
    run();
    cmd.DisableShaderKeyword("THRICE");
    run();
    cmd.DisableKeyword(shader, "NEGATIVE");
    cmd.EnableShaderKeyword("NEGATIVE"); // a local one hears no global
    run();
    RunCommands(cmd);
    EXPECT_EQ(DataOf<int>(*out), (std::vector<int>{10, 20, -30, -10, 10}));
}

TEST_F(KernelGpu, CountsWhatItAppendsInWhateverOrder)
{
    const auto shader =
        MakeKernel("64, 1, 1", "StructuredBuffer<uint> _In; AppendStructuredBuffer<uint> _Odd;",
                   "if (_In[id.x] % 2 == 1) { _Odd.Append(_In[id.x]); }");
    std::vector<std::uint32_t> numbers(256);
    for (std::uint32_t i = 0; i < 256; ++i)
    {
        numbers[i] = i * 7 + i / 3;
    }
    const auto odd = MakeBuffer(std::vector<std::uint32_t>(300), GraphicsBuffer::Target::Append);
    odd->SetCounterValue(2);
    shader->SetBuffer(0, "_In", MakeBuffer(numbers));
    shader->SetBuffer(0, "_Odd", odd);
    CommandBuffer cmd;
    cmd.DispatchCompute(shader, 0, 4, 1, 1);
    RunCommands(cmd);
    std::erase_if(numbers, [](std::uint32_t n) { return n % 2 == 0; });
    const std::uint32_t count = odd->GetCounterValue(SharedDevice());
    ASSERT_EQ(count, numbers.size() + 2) << "from the value on that was set";
    auto seen = DataOf<std::uint32_t>(*odd);
    seen.resize(count);
    EXPECT_EQ(seen[0] + seen[1], 0u);
    seen.erase(seen.begin(), seen.begin() + 2);
    std::ranges::sort(seen);
    EXPECT_EQ(seen, numbers);
}

TEST_F(KernelGpu, AddsUpFromAllThreads)
{
    const auto shader =
        MakeKernel("32, 1, 1", "RWStructuredBuffer<uint> _Sums; RWByteAddressBuffer _Raw;",
                   "InterlockedAdd(_Sums[id.x % 3], 1); InterlockedMax(_Sums[3], id.x);\n"
                   "uint old; _Raw.InterlockedAdd(4, id.x, old);");
    const auto sums = MakeBuffer(std::vector<std::uint32_t>{0, 10, 20, 30});
    const auto raw = MakeBuffer(std::vector<std::uint32_t>{1, 2, 3}, GraphicsBuffer::Target::Raw);
    shader->SetBuffer(0, "_Sums", sums);
    shader->SetBuffer(0, "_Raw", raw);
    CommandBuffer cmd;
    cmd.DispatchCompute(shader, 0, 4, 1, 1);
    RunCommands(cmd);
    EXPECT_EQ(DataOf<std::uint32_t>(*sums), (std::vector<std::uint32_t>{43, 53, 62, 127}));
    EXPECT_EQ(DataOf<std::uint32_t>(*raw), (std::vector<std::uint32_t>{1, 2 + 127 * 64, 3}));
}

TEST_F(KernelGpu, SamplesByTheSamplersThatItNames)
{
    const auto shader = MakeKernel(
        "1, 1, 1",
        "Texture2D _Map; SamplerState sampler_LinearClamp; SamplerState sampler_PointRepeat;\n"
        "RWStructuredBuffer<float4> _Out;",
        "_Out[0] = _Map.SampleLevel(sampler_LinearClamp, float2(0.5, 0.5), 0);\n"
        "_Out[1] = _Map.SampleLevel(sampler_PointRepeat, float2(1.25, 0.25), 0);\n"
        "_Out[2] = _Map.SampleLevel(sampler_LinearClamp, float2(-3, 0.25), 0);\n"
        "_Out[3] = _Map.Load(int3(1, 1, 0));");
    std::vector<std::byte> texels;
    for (const int value : {0, 255, 51, 0})
    {
        texels.insert(texels.end(), 4, static_cast<std::byte>(value));
    }
    const auto map =
        std::make_shared<Texture2D>("map", 2, 2, GraphicsFormat::R8G8B8A8_UNorm, texels);
    const auto out = MakeBuffer(std::vector<glm::vec4>(4));
    shader->SetTexture(0, "_Map", map);
    shader->SetBuffer(0, "_Out", out);
    CommandBuffer cmd;
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    RunCommands(cmd);
    const auto seen = DataOf<glm::vec4>(*out);
    EXPECT_NEAR(seen[0].x, (0.0 + 1.0 + 0.2 + 0.0) / 4, 2.0 / 255) << "weights may have 8 bits";
    EXPECT_NEAR(seen[1].x, 0.0, 1e-6);
    EXPECT_NEAR(seen[2].x, 0.0, 1e-6);
    EXPECT_NEAR(seen[3].x, 0.0, 1e-6);
}

TEST_F(KernelGpu, TakesWhatIsGlobal)
{
    const auto shader = MakeKernel("1, 1, 1",
                                   "float4 _GlobalTint; StructuredBuffer<float> _GlobalData;"
                                   "RWStructuredBuffer<float4> _Out;",
                                   "_Out[0] = _GlobalTint * _GlobalData[1];");
    const auto out = MakeBuffer(std::vector<glm::vec4>(1));
    CommandBuffer cmd;
    cmd.SetGlobalVector("_GlobalTint", {1, 2, 3, 4});
    cmd.SetGlobalBuffer("_GlobalData", MakeBuffer(std::vector<float>{5, 10}));
    cmd.SetComputeBufferParam(shader, 0, "_Out", out);
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    RunCommands(cmd);
    EXPECT_EQ(DataOf<glm::vec4>(*out)[0], glm::vec4(10, 20, 30, 40));
}

} // namespace limn::test

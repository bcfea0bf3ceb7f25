#include "compute/ComputeRun.h"

#include <limn/core/Material.h>

#include <algorithm>
#include <array>
#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

class BufferGpu : public GpuTest
{
};

/// As a program on the CPU writes it, without padding.
struct Packed
{
    std::array<float, 3> a;
    std::array<float, 3> b;
    float c;
    std::array<std::int32_t, 2> d;
};
static_assert(sizeof(Packed) == 36);

constexpr const char* k_Packed = "struct Packed { float3 a; float3 b; float c; int2 d; };\n";

/// Draws one triangle over a target of 4x4 with a material.
Image DrawWith(const std::shared_ptr<Material>& material)
{
    const TargetPtr target = MakeTarget(4, 4, GraphicsFormat::R32G32B32A32_SFloat);
    CommandBuffer cmd;
    CoreUtils::SetRenderTarget(cmd, RTHandle(target), ClearFlag::Color);
    CoreUtils::DrawFullScreen(cmd, material);
    RunCommands(cmd, {target});
    return ReadRows(*target);
}

std::shared_ptr<Material> MakeMaterial(const std::string& declarations, const std::string& value)
{
    const auto shader = Shader::FromText(
        "Shader \"Buffers\" { SubShader { Pass { Cull Off ZTest Always ZWrite Off\nHLSLPROGRAM\n"
        "#pragma vertex V\n#pragma fragment F\n" +
            declarations +
            "\nfloat4 V(uint id : SV_VertexID) : SV_POSITION { return float4(id == 1 ? 3 : -1, id "
            "== 2 ? 3 : -1, 0.5, 1); }\nfloat4 F(float4 p : SV_POSITION) : SV_Target { return " +
            value + "; }\nENDHLSL\n} } }",
        "Buffers.shader", ComputeCompiler());
    return std::make_shared<Material>(shader);
}

} // namespace

TEST_F(BufferGpu, HoldsStructsAsTheCpuPacksThem)
{
    const auto shader = MakeKernel("4, 1, 1",
                                   std::string(k_Packed) + "StructuredBuffer<Packed> _In; "
                                                           "RWStructuredBuffer<Packed> _Out;",
                                   "Packed p = _In[3 - id.x]; Packed q;\n"
                                   "q.a = p.b; q.b = p.a * 2; q.c = p.c + id.x; q.d = p.d.yx;\n"
                                   "_Out[id.x] = q;");
    std::vector<Packed> in(4);
    for (std::size_t i = 0; i < 4; ++i)
    {
        const auto n = static_cast<float>(i);
        in[i] = {
            {n, n + 0.25f, n + 0.5f}, {10 * n, 20 * n, 30 * n}, -n, {100, static_cast<int>(i)}};
    }
    const auto out = MakeBuffer(std::vector<Packed>(4));
    shader->SetBuffer(0, "_In", MakeBuffer(in));
    shader->SetBuffer(0, "_Out", out);
    CommandBuffer cmd;
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    RunCommands(cmd);
    const auto seen = DataOf<Packed>(*out);
    for (std::size_t i = 0; i < 4; ++i)
    {
        const Packed& p = in[3 - i];
        EXPECT_EQ(seen[i].a, p.b);
        EXPECT_EQ(seen[i].b, (std::array<float, 3>{2 * p.a[0], 2 * p.a[1], 2 * p.a[2]}));
        EXPECT_EQ(seen[i].c, p.c + static_cast<float>(i));
        EXPECT_EQ(seen[i].d, (std::array<std::int32_t, 2>{p.d[1], p.d[0]}));
    }
}

TEST_F(BufferGpu, HoldsMatricesColumnByColumn)
{
    const auto shader = MakeKernel(
        "1, 1, 1",
        "struct M { float4x4 m; float3x3 n; float2x3 o; };\n"
        "StructuredBuffer<M> _In; RWStructuredBuffer<M> _Out; "
        "RWStructuredBuffer<float> _Elements;",
        "M m = _In[0]; _Out[0] = m; _Elements[0] = m.m[1][2]; _Elements[1] = m.n[0][2];\n"
        "_Elements[2] = m.o[1][0]; _Elements[3] = m.o._m02;");
    struct M
    {
        std::array<float, 16> m;
        std::array<float, 9> n;
        std::array<float, 6> o;
    };
    M in{};
    for (std::size_t i = 0; i < 31; ++i)
    {
        auto* floats = reinterpret_cast<float*>(&in);
        floats[i] = static_cast<float>(i + 1);
    }
    const auto out = MakeBuffer(std::vector<M>(1));
    const auto elements = MakeBuffer(std::vector<float>(4));
    shader->SetBuffer(0, "_In", MakeBuffer(std::vector<M>{in}));
    shader->SetBuffer(0, "_Out", out);
    shader->SetBuffer(0, "_Elements", elements);
    CommandBuffer cmd;
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    RunCommands(cmd);
    const M seen = DataOf<M>(*out)[0];
    EXPECT_EQ(seen.m, in.m);
    EXPECT_EQ(seen.n, in.n);
    EXPECT_EQ(seen.o, in.o);
    // Element (row, column) of a matrix with R rows is number column * R + row of its floats.
    EXPECT_EQ(DataOf<float>(*elements), (std::vector<float>{in.m[2 * 4 + 1], in.n[2 * 3 + 0],
                                                            in.o[0 * 2 + 1], in.o[2 * 2 + 0]}));
}

TEST_F(BufferGpu, IsZeroUntilItIsSet)
{
    const auto shader =
        MakeKernel("4, 1, 1", "RWStructuredBuffer<uint> _Out;", "_Out[id.x + 4] = _Out[id.x] + 1;");
    const auto out = std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::Structured, 9, 4);
    shader->SetBuffer(0, "_Out", out);
    CommandBuffer cmd;
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    RunCommands(cmd);
    EXPECT_EQ(DataOf<std::uint32_t>(*out), (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1, 1, 1, 0}));
}

TEST_F(BufferGpu, TakesPartsBetweenFramesAndKeepsWhatKernelsWrote)
{
    const auto shader = MakeKernel("8, 1, 1", "RWStructuredBuffer<uint> _Out;", "_Out[id.x] += 1;");
    const auto out = MakeBuffer(std::vector<std::uint32_t>{0, 10, 20, 30, 40, 50, 60, 70});
    shader->SetBuffer(0, "_Out", out);
    CommandBuffer cmd;
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    RunCommands(cmd);
    out->SetData(std::vector<std::uint32_t>{1, 100, 200, 2}, 1, 3, 2);
    RunCommands(cmd);
    RunCommands(cmd);
    EXPECT_EQ(DataOf<std::uint32_t>(*out),
              (std::vector<std::uint32_t>{3, 13, 23, 102, 202, 53, 63, 73}));
}

TEST_F(BufferGpu, IsReadByShadersOfPassesByName)
{
    const auto material = MakeMaterial(
        std::string(k_Packed) + "StructuredBuffer<Packed> _Items; ByteAddressBuffer _Raw;",
        "float4(_Items[(uint)p.x].b, asfloat(_Raw.Load(4 * (uint)p.y)))");
    std::vector<Packed> items(4);
    for (std::size_t i = 0; i < 4; ++i)
    {
        items[i].b = {static_cast<float>(i), 2.0f, 3.0f};
    }
    material->SetBuffer("_Items", MakeBuffer(items));
    material->SetBuffer("_Raw",
                        MakeBuffer(std::vector<float>{5, 6, 7, 8}, GraphicsBuffer::Target::Raw));
    const Image image = DrawWith(material);
    EXPECT_EQ(TexelFloat(image, 2, 3), (std::array<float, 4>{2, 2, 3, 8}));
    EXPECT_EQ(TexelFloat(image, 3, 0), (std::array<float, 4>{3, 2, 3, 5}));
}

TEST_F(BufferGpu, StandsForAConstantBufferByName)
{
    const auto material = MakeMaterial("cbuffer Tints { float4 _Tint; float4 _Other; };", "_Tint");
    material->SetVector("_Tint", {9, 9, 9, 9});
    EXPECT_EQ(TexelFloat(DrawWith(material), 0, 0), (std::array<float, 4>{9, 9, 9, 9}));
    std::vector<glm::vec4> values(32);
    values[0] = {1, 2, 3, 4};
    values[16] = {5, 6, 7, 8};
    const auto constants = MakeBuffer(values, GraphicsBuffer::Target::Constant);
    material->SetConstantBuffer("Tints", constants, 0, 0);
    EXPECT_EQ(TexelFloat(DrawWith(material), 0, 0), (std::array<float, 4>{1, 2, 3, 4}));
    material->SetConstantBuffer("Tints", constants, 256, 256);
    EXPECT_EQ(TexelFloat(DrawWith(material), 0, 0), (std::array<float, 4>{5, 6, 7, 8}));
    material->SetConstantBuffer("Tints", nullptr, 0, 0);
    EXPECT_EQ(TexelFloat(DrawWith(material), 0, 0), (std::array<float, 4>{9, 9, 9, 9}));
}

TEST_F(BufferGpu, GoesFromAKernelToADrawAndBack)
{
    const auto fill = MakeKernel("4, 1, 1", "RWStructuredBuffer<float4> _Colors; float _Base;",
                                 "_Colors[id.x] = _Colors[id.x] + float4(id.x, _Base, 0, 1);");
    const auto material = MakeMaterial("StructuredBuffer<float4> _Colors;", "_Colors[(uint)p.x]");
    const auto colors = MakeBuffer(std::vector<glm::vec4>(4));
    const TargetPtr first = MakeTarget(4, 4, GraphicsFormat::R32G32B32A32_SFloat);
    const TargetPtr second = MakeTarget(4, 4, GraphicsFormat::R32G32B32A32_SFloat);
    CommandBuffer cmd;
    cmd.SetGlobalBuffer("_Colors", colors);
    cmd.SetComputeFloatParam(fill, "_Base", 10.0f);
    for (const TargetPtr& target : {first, second})
    {
        cmd.DispatchCompute(fill, 0, 1, 1, 1);
        CoreUtils::SetRenderTarget(cmd, RTHandle(target), ClearFlag::Color);
        CoreUtils::DrawFullScreen(cmd, material);
    }
    RunCommands(cmd, {first, second});
    EXPECT_EQ(TexelFloat(ReadRows(*first), 3, 1), (std::array<float, 4>{3, 10, 0, 1}));
    EXPECT_EQ(TexelFloat(ReadRows(*second), 3, 1), (std::array<float, 4>{6, 20, 0, 2}));
}

TEST_F(BufferGpu, CannotBeReadBackBeforeAFrameUsedIt)
{
    const GraphicsBuffer buffer(GraphicsBuffer::Target::Structured, 1, 4);
    EXPECT_THROW(SharedDevice().ReadBackBuffer(buffer), ContractError);
}

TEST_F(BufferGpu, TakesDataFromACommandBuffer)
{
    const auto shader =
        MakeKernel("4, 1, 1", "StructuredBuffer<uint> _In; RWStructuredBuffer<uint> _Out;",
                   "_Out[id.x] = 10 * _In[id.x];");
    const auto in = MakeBuffer(std::vector<std::uint32_t>{1, 2, 3, 4});
    const auto out = MakeBuffer(std::vector<std::uint32_t>(4));
    shader->SetBuffer(0, "_In", in);
    shader->SetBuffer(0, "_Out", out);
    const std::vector<std::uint32_t> numbers{7, 8, 9};
    CommandBuffer cmd;
    cmd.SetBufferData(in, numbers, 1, 2, 2);
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    EXPECT_EQ(in->bytes()[8], std::byte{3}) << "not before it is executed";
    RunCommands(cmd);
    EXPECT_EQ(DataOf<std::uint32_t>(*out), (std::vector<std::uint32_t>{10, 20, 80, 90}));
    cmd.Clear();
    cmd.SetBufferData(in, numbers);
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    RunCommands(cmd);
    EXPECT_EQ(DataOf<std::uint32_t>(*out), (std::vector<std::uint32_t>{70, 80, 90, 90}));
}

TEST_F(BufferGpu, RefusesDataThatWouldComeBeforeAnEarlierDispatch)
{
    const auto shader = MakeKernel("1, 1, 1", "RWStructuredBuffer<uint> _Out;", "_Out[0] = 1;");
    const auto out = MakeBuffer(std::vector<std::uint32_t>(1));
    shader->SetBuffer(0, "_Out", out);
    CommandBuffer cmd;
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    cmd.SetBufferData(out, std::vector<std::uint32_t>{5});
    EXPECT_THAT([&] { RunCommands(cmd); }, testing::ThrowsMessage<ContractError>(testing::AllOf(
                                               testing::HasSubstr("SetBufferData"),
                                               testing::HasSubstr("'GraphicsBuffer' already"))));
    EXPECT_THAT([&] { cmd.SetBufferData(nullptr, std::vector<int>{5}); },
                testing::ThrowsMessage<ContractError>("SetBufferData: the buffer is null"));
}

TEST_F(BufferGpu, CountsFromWhatACommandBufferSays)
{
    const auto shader =
        MakeKernel("3, 1, 1", "AppendStructuredBuffer<uint> _Out;", "_Out.Append(id.x + 1);");
    const auto out = MakeBuffer(std::vector<std::uint32_t>(8), GraphicsBuffer::Target::Append);
    shader->SetBuffer(0, "_Out", out);
    CommandBuffer cmd;
    cmd.SetBufferCounterValue(out, 2);
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    RunCommands(cmd);
    EXPECT_EQ(out->GetCounterValue(SharedDevice()), 5u);
    std::vector<std::uint32_t> seen = DataOf<std::uint32_t>(*out);
    EXPECT_EQ(seen[0] + seen[1], 0u);
    std::sort(seen.begin() + 2, seen.begin() + 5);
    EXPECT_EQ(std::vector<std::uint32_t>(seen.begin() + 2, seen.begin() + 5),
              (std::vector<std::uint32_t>{1, 2, 3}));
}

} // namespace limn::test

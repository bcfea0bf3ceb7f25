#include "compute/ComputeRun.h"

#include <limn/core/BuiltinShaders.h>
#include <limn/core/RenderTexturePool.h>
#include <numeric>

namespace limn::test
{

namespace
{

using Target = GraphicsBuffer::Target;

/// Runs command buffers as a camera's.
class CopyGpu : public GpuTest
{
protected:
    void Run(const CommandBuffer& cmd, const std::vector<TargetPtr>& outputs = {})
    {
        RenderReport report;
        ScriptableRenderContext context(report);
        context.BeginCamera({m_Color, {}, &m_Pool, m_Copy});
        context.ExecuteCommandBuffer(cmd);
        SharedDevice().Execute(
            CompileFrame(context.TakeCommands(), SharedDevice().textureStates(), outputs));
        ExpectNoValidationMessages();
        EXPECT_TRUE(report.notes.empty()) << report.notes.front();
    }
    static std::vector<std::uint32_t> Counting(std::size_t count, std::uint32_t from)
    {
        std::vector<std::uint32_t> numbers(count);
        std::iota(numbers.begin(), numbers.end(), from);
        return numbers;
    }

    const RTHandle m_Color{MakeTarget(4, 4)};
    RenderTexturePool m_Pool;
    const std::shared_ptr<const Material> m_Copy = CoreUtils::CreateEngineMaterial(
        FindBuiltinShader("Hidden/Universal/CoreBlit", ComputeCompiler()));
};

} // namespace

TEST_F(CopyGpu, CopiesAllWordsOfBuffersOfAnyTarget)
{
    // The last one has more words than one row of groups does.
    for (const std::size_t count : {1u, 63u, 64u, 65u, 4'200'000u})
    {
        const auto numbers = Counting(count, 7);
        const auto from = MakeBuffer(numbers, Target::Structured | Target::CopySource);
        const auto between = std::make_shared<GraphicsBuffer>(
            Target::Constant | Target::CopySource | Target::CopyDestination,
            static_cast<int>(count * 2), 2);
        const auto to = std::make_shared<GraphicsBuffer>(
            Target::IndirectArguments | Target::CopyDestination, static_cast<int>(count), 4);
        CommandBuffer cmd;
        cmd.CopyBuffer(from, between);
        cmd.CopyBuffer(between, to);
        Run(cmd);
        EXPECT_EQ(DataOf<std::uint32_t>(*to), numbers) << count;
    }
}

TEST_F(CopyGpu, WaitsForKernelsBeforeAndBehind)
{
    const auto add = MakeKernel("4, 1, 1", "RWStructuredBuffer<uint> _Data;", "_Data[id.x] += 10;");
    const auto from = MakeBuffer(Counting(4, 0), Target::Structured | Target::CopySource);
    const auto to = MakeBuffer(std::vector<std::uint32_t>{9, 9, 9, 9},
                               Target::Structured | Target::CopyDestination);
    CommandBuffer cmd;
    cmd.SetComputeBufferParam(add, 0, "_Data", from);
    cmd.DispatchCompute(add, 0, 1, 1, 1);
    cmd.CopyBuffer(from, to);
    cmd.DispatchCompute(add, 0, 1, 1, 1); // behind the copy
    cmd.SetComputeBufferParam(add, 0, "_Data", to);
    cmd.DispatchCompute(add, 0, 1, 1, 1);
    Run(cmd);
    EXPECT_EQ(DataOf<std::uint32_t>(*from), (std::vector<std::uint32_t>{20, 21, 22, 23}));
    EXPECT_EQ(DataOf<std::uint32_t>(*to), (std::vector<std::uint32_t>{20, 21, 22, 23}));
}

TEST_F(CopyGpu, CopiesWhatWasCountedToAPlace)
{
    const auto append = MakeKernel("8, 1, 1", "AppendStructuredBuffer<uint> _Found;",
                                   "if (id.x % 3 == 0) _Found.Append(id.x);");
    const auto found = std::make_shared<GraphicsBuffer>(Target::Append, 100, 4);
    found->SetCounterValue(2);
    const auto to = MakeBuffer(std::vector<std::uint32_t>{1, 2, 3, 4}, Target::IndirectArguments);
    CommandBuffer cmd;
    cmd.SetComputeBufferParam(append, 0, "_Found", found);
    cmd.DispatchCompute(append, 0, 2, 1, 1); // 0, 3 ... 15 of 16
    cmd.CopyCounterValue(found, to, 8);
    Run(cmd);
    EXPECT_EQ(DataOf<std::uint32_t>(*to), (std::vector<std::uint32_t>{1, 2, 2 + 6, 4}));
    EXPECT_EQ(found->GetCounterValue(SharedDevice()), 8u);
}

TEST_F(CopyGpu, GivesKernelsWhatAMaterialHas)
{
    const auto material = std::make_shared<Material>(Shader::FromText(
        "Shader \"T\" { Properties { _Tint (\"\", Color) = (1, 0.5, 0, 1) _Size (\"\", Float) = 3\n"
        "_Map (\"\", 2D) = \"red\" {} }\nSubShader { Pass { HLSLPROGRAM\n#pragma vertex V\n"
        "#pragma fragment F\nfloat4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
        "float4 F() : SV_Target { return 1; }\nENDHLSL } } }",
        "T.shader", ComputeCompiler()));
    const auto read = MakeKernel("1, 1, 1",
                                 "float4 _Tint; float _Size; Texture2D _Map; float4 _Map_TexelSize;"
                                 "RWStructuredBuffer<float4> _Out;",
                                 "_Out[0] = _Tint; _Out[1] = _Size; _Out[2] = _Map.Load(0);"
                                 "_Out[3] = _Map_TexelSize;");
    const auto out = MakeBuffer(std::vector<glm::vec4>(4));
    CommandBuffer cmd;
    cmd.SetComputeParamsFromMaterial(read, 0, material);
    cmd.SetComputeBufferParam(read, 0, "_Out", out);
    cmd.DispatchCompute(read, 0, 1, 1, 1);
    Run(cmd);
    const auto seen = DataOf<glm::vec4>(*out);
    EXPECT_NEAR(seen[0].y, std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-5) << "linear";
    EXPECT_EQ(seen[1].x, 3.0f);
    EXPECT_EQ(seen[2], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(seen[3], glm::vec4(1, 1, 1, 1));
}

TEST_F(CopyGpu, MakesMipLevelsOfWhatAKernelWrote)
{
    RenderTextureDescriptor descriptor(8, 8, GraphicsFormat::R32G32B32A32_SFloat);
    descriptor.enableRandomWrite = true;
    descriptor.useMipMap = true;
    const auto texture = std::make_shared<const RenderTexture>("mipped", descriptor);
    ASSERT_EQ(texture->mipmapCount(), 4);
    const auto write = MakeKernel("8, 8, 1", "RWTexture2D<float4> _Out;",
                                  "_Out[id.xy] = id.x * id.x + 100.0 * id.y;");
    const auto read =
        MakeKernel("8, 8, 1", "Texture2D _In; RWStructuredBuffer<float> _Out;",
                   "uint size = 8;\nfor (int mip = 0; mip < 4; ++mip, size /= 2)\n"
                   "if (id.x < size && id.y < size)\n"
                   "_Out[(mip * 8 + id.y) * 8 + id.x] = _In.Load(int3(id.xy, mip)).r;");
    const auto out = MakeBuffer(std::vector<float>(4 * 64));
    CommandBuffer cmd;
    cmd.SetComputeTextureParam(write, 0, "_Out", RTHandle(texture));
    cmd.DispatchCompute(write, 0, 1, 1, 1);
    cmd.GenerateMips(texture);
    cmd.SetComputeTextureParam(read, 0, "_In", RTHandle(texture));
    cmd.SetComputeBufferParam(read, 0, "_Out", out);
    cmd.DispatchCompute(read, 0, 1, 1, 1);
    Run(cmd);
    const auto seen = DataOf<float>(*out);
    const auto mean = [](int x, int y, int size)
    {
        double sum = 0.0;
        for (int i = 0; i < size * size; ++i)
        {
            const double u = x * size + i % size;
            sum += u * u + 100.0 * (y * size + i / size);
        }
        return sum / (size * size);
    };
    for (int mip = 0; mip < 4; ++mip)
    {
        for (int i = 0; i < (64 >> (2 * mip)); ++i)
        {
            const int size = 8 >> mip;
            const int x = i % size;
            const int y = i / size;
            EXPECT_NEAR(seen[static_cast<std::size_t>((mip * 8 + y) * 8 + x)], mean(x, y, 1 << mip),
                        1e-3)
                << "level " << mip << " at " << x << ", " << y;
        }
    }
}

// Of every format that is said to be one, a target is made, cleared and read back.
TEST_F(CopyGpu, KnowsWhichFormatsTheDeviceDrawsInto)
{
    using enum GraphicsFormat;
    int count = 0;
    for (const GraphicsFormat format : {R8G8B8A8_SRGB,
                                        R8_UNorm,
                                        R8G8_UNorm,
                                        R8G8B8A8_UNorm,
                                        R8G8B8A8_SNorm,
                                        R8_UInt,
                                        R8G8B8A8_UInt,
                                        R16_UNorm,
                                        R16G16_UNorm,
                                        R16G16B16A16_UNorm,
                                        R16_UInt,
                                        R16G16B16A16_UInt,
                                        R32_UInt,
                                        R32G32_UInt,
                                        R32G32B32A32_UInt,
                                        R32_SInt,
                                        R32G32_SInt,
                                        R32G32B32A32_SInt,
                                        R16_SFloat,
                                        R16G16_SFloat,
                                        R16G16B16A16_SFloat,
                                        R32_SFloat,
                                        R32G32_SFloat,
                                        R32G32B32A32_SFloat,
                                        B8G8R8A8_SRGB,
                                        B8G8R8A8_UNorm,
                                        B10G11R11_UFloatPack32,
                                        A2B10G10R10_UNormPack32,
                                        D32_SFloat,
                                        D32_SFloat_S8_UInt})
    {
        for (int usage = 0; usage < 17; ++usage)
        {
            EXPECT_TRUE(!EveryDeviceSupports(format, static_cast<FormatUsage>(usage)) ||
                        SharedDevice().IsFormatSupported(format, static_cast<FormatUsage>(usage)))
                << ToString(format) << " for " << usage;
        }
        if (SharedDevice().IsFormatSupported(format, FormatUsage::Render))
        {
            ++count;
            const TargetPtr target = MakeTarget(4, 4, format);
            CommandBuffer cmd;
            cmd.SetRenderTarget(RTHandle(target));
            cmd.ClearRenderTarget(ClearFlag::All, Color::white);
            Run(cmd, {target});
            EXPECT_EQ(ReadRows(*target).width, 4) << ToString(format);
        }
    }
    EXPECT_GT(count, 20);
}

} // namespace limn::test

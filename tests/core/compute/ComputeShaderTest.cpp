#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <limn/core/CommandBuffer.h>
#include <limn/core/DrawError.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/ScriptableRenderContext.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

using test::Mentions;

using Target = GraphicsBuffer::Target;

constexpr const char* k_Two = "#pragma kernel Blur\n#pragma kernel Sharpen\n"
                              "RWTexture2D<float4> _Result; Texture2D _Source;\n"
                              "StructuredBuffer<float3> _Items; ByteAddressBuffer _Raw;\n"
                              "AppendStructuredBuffer<uint> _Found; RWTexture2D<uint> _Count;\n"
                              "cbuffer Params { float4 _Tint; };\n"
                              "[numthreads(8, 4, 2)] void Blur(uint3 id : SV_DispatchThreadID)\n"
                              "{ _Result[id.xy] = _Source.Load(0) + float4(_Items[0], 1) * "
                              "_Raw.Load(0) * _Tint; }\n"
                              "[numthreads(1, 1, 1)] void Sharpen(uint3 id : SV_DispatchThreadID)\n"
                              "{ _Found.Append(id.x); }\n";

std::shared_ptr<ComputeShader> Two()
{
    return ComputeShader::FromText(k_Two, "Filter.compute", test::Compiler());
}

std::shared_ptr<GraphicsBuffer> Buffer(Target target, int count, int stride, std::string name)
{
    auto buffer = std::make_shared<GraphicsBuffer>(target, count, stride);
    buffer->SetName(std::move(name));
    return buffer;
}

std::shared_ptr<const RenderTexture> Writable(const std::string& name, bool isWritable = true)
{
    RenderTextureDescriptor descriptor(4, 4, GraphicsFormat::R8G8B8A8_UNorm);
    descriptor.enableRandomWrite = isWritable;
    return std::make_shared<RenderTexture>(name, descriptor);
}

/// What executing a dispatch of a kernel throws.
std::string DispatchError(const std::shared_ptr<ComputeShader>& shader, int kernel = 0)
{
    return test::ThrownMessage<DrawError>(
        [&]
        {
            RenderReport report;
            ScriptableRenderContext context(report);
            CommandBuffer cmd;
            cmd.DispatchCompute(shader, kernel, 1, 1, 1);
            context.ExecuteCommandBuffer(cmd);
        });
}

/// With everything set that Blur needs.
std::shared_ptr<ComputeShader> Ready()
{
    const auto shader = Two();
    shader->SetTexture(0, "_Result", Writable("result"));
    shader->SetTexture(0, "_Source", Writable("source"));
    shader->SetBuffer(0, "_Items", Buffer(Target::Structured, 2, 12, "items"));
    shader->SetBuffer(0, "_Raw", Buffer(Target::Raw, 2, 4, "raw"));
    return shader;
}

} // namespace

TEST(ComputeShader, FindsItsKernels)
{
    const auto shader = Two();
    EXPECT_EQ(shader->name(), "Filter");
    EXPECT_EQ(shader->FindKernel("Blur"), 0);
    EXPECT_EQ(shader->FindKernel("Sharpen"), 1);
    EXPECT_TRUE(shader->HasKernel("Blur"));
    EXPECT_FALSE(shader->HasKernel("blur"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { shader->FindKernel("Blurr"); }),
                Mentions("'Filter'", "no kernel 'Blurr'", "'Blur'"));
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&] { shader->SetBuffer(2, "_Items", nullptr); }),
        Mentions("'Filter'", "no kernel 2", "has 2"));
}

TEST(ComputeShader, SaysHowLargeItsGroupsAre)
{
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    std::uint32_t z = 0;
    Two()->GetKernelThreadGroupSizes(0, x, y, z);
    EXPECT_EQ(x, 8u);
    EXPECT_EQ(y, 4u);
    EXPECT_EQ(z, 2u);
}

TEST(ComputeShader, KeepsKernelsTexturesApart)
{
    const auto shader = Two();
    const auto first = Writable("first");
    shader->SetTexture(0, "_Result", first);
    shader->SetFloat("_Size", 3.0f);
    EXPECT_NE(shader->Find(0, "_Result"), nullptr);
    EXPECT_EQ(shader->Find(1, "_Result"), nullptr);
    EXPECT_EQ(std::get<float>(*shader->Find(1, "_Size")), 3.0f);
}

TEST(ComputeShader, RefusesWhatIsNotFinite)
{
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [] { Two()->SetFloat("_X", std::numeric_limits<float>::quiet_NaN()); }),
                Mentions("'Filter'", "'_X'", "not finite"));
    CommandBuffer cmd;
    EXPECT_THROW(cmd.SetComputeFloatParams(Two(), "_X", {}), ContractError);
    EXPECT_NO_THROW(cmd.SetComputeFloatParams(Two(), "_X", 1.0f, 2));
}

TEST(ComputeShader, IsRefusedInASentenceWhereTheDeviceRunsNoKernels)
{
    ShaderCompilerOptions options;
    options.missingFeatures = {"compute"};
    const auto shader =
        ComputeShader::FromText(k_Two, "Filter.compute", std::make_shared<ShaderCompiler>(options));
    EXPECT_FALSE(shader->IsSupported(0));
    EXPECT_TRUE(Two()->IsSupported(0));
    RenderReport report;
    ScriptableRenderContext context(report);
    CommandBuffer cmd;
    cmd.DispatchCompute(shader, 0, 1, 1, 1);
    EXPECT_THAT(
        test::ThrownMessage<UnsupportedProgramError>([&] { context.ExecuteCommandBuffer(cmd); }),
        Mentions("Filter.compute:1:1", "requires 'compute'", "device"));
}

TEST(ComputeShader, IsDispatchedInAtLeastOneGroup)
{
    CommandBuffer cmd;
    const auto shader = Two();
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&] { cmd.DispatchCompute(shader, 0, 1, 0, 1); }),
        Mentions("DispatchCompute", "'Filter'", "'Blur'", "1x0x1", "65535"));
    EXPECT_THROW(cmd.DispatchCompute(shader, 0, 65536, 1, 1), ContractError);
    EXPECT_THROW(cmd.DispatchCompute(shader, 2, 1, 1, 1), ContractError);
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&] { cmd.DispatchCompute(nullptr, 0, 1, 1, 1); }),
        Mentions("compute shader", "null"));
}

TEST(ComputeShader, NamesWhatIsNotSet)
{
    const auto shader = Two();
    EXPECT_THAT(DispatchError(shader),
                Mentions("'Filter'", "'Blur'", "texture '_Source'", "not set", "global"));
    shader->SetTexture(0, "_Source", Writable("source"));
    EXPECT_THAT(DispatchError(shader),
                Mentions("'Filter'", "'Blur'", "buffer '_Items'", "not set"));
    EXPECT_THAT(DispatchError(shader, 1),
                Mentions("'Sharpen'", "buffer '_Found'", "not set", "global"));
}

TEST(ComputeShader, NamesTexturesThatDoNotFit)
{
    const auto shader = Ready();
    shader->SetTexture(0, "_Result", Writable("plain", false));
    EXPECT_THAT(DispatchError(shader),
                Mentions("'Blur'", "'_Result'", "written", "'plain'", "enableRandomWrite"));
    shader->SetTexture(0, "_Result",
                       std::make_shared<Texture2D>("file", 1, 1, GraphicsFormat::R8_UNorm,
                                                   std::vector<std::byte>(1)));
    EXPECT_THAT(DispatchError(shader),
                Mentions("'Blur'", "'_Result'", "written", "'file'", "no render texture"));
}

TEST(ComputeShader, NamesBuffersThatDoNotFit)
{
    const auto shader = Ready();
    shader->SetBuffer(0, "_Items", Buffer(Target::Structured, 2, 16, "wide"));
    EXPECT_THAT(DispatchError(shader), Mentions("'Blur'", "'_Items'", "12 bytes", "'wide'", "16"));
    shader->SetBuffer(0, "_Items", Buffer(Target::Raw, 2, 4, "bytes"));
    EXPECT_THAT(DispatchError(shader), Mentions("'Blur'", "'_Items'", "'bytes'", "otherwise",
                                                "GraphicsBuffer::Target::Structured"));
    const auto released = Buffer(Target::Structured, 2, 12, "gone");
    shader->SetBuffer(0, "_Items", released);
    released->Release();
    EXPECT_THAT(DispatchError(shader), Mentions("'Blur'", "'_Items'", "'gone'", "released"));
    const auto constants = Ready();
    constants->SetConstantBuffer("Params", Buffer(Target::Constant, 1, 8, "small"), 0, 0);
    EXPECT_THAT(DispatchError(constants),
                Mentions("'Blur'", "'Params'", "cbuffer", "16 bytes", "8", "'small'"));
}

TEST(ComputeShader, CountsOnlyWhereABufferHasACounter)
{
    const auto shader = Two();
    shader->SetBuffer(1, "_Found", Buffer(Target::Structured, 4, 4, "plain"));
    EXPECT_THAT(DispatchError(shader, 1), Mentions("'Sharpen'", "'_Found'", "'plain'", "otherwise",
                                                   "GraphicsBuffer::Target::Append", "Counter"));
}

TEST(GraphicsBuffer, IsRefusedWithItsNumbers)
{
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([] { GraphicsBuffer(Target::Structured, 0, 4); }),
        Mentions("GraphicsBuffer", "count is 0", "stride is 4", "greater than 0"));
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([] { GraphicsBuffer(Target::Structured, 1, 6); }),
        Mentions("GraphicsBuffer", "stride", "6 bytes", "structured", "multiple of 4", "2048"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([] { GraphicsBuffer(Target::Raw, 1, 16); }),
                Mentions("GraphicsBuffer", "stride", "raw", "4 bytes", "16"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([] { GraphicsBuffer(Target::Vertex, 1, 16); }),
                Mentions("GraphicsBuffer", "target Vertex", "shader", "Structured", "Constant"));
}

TEST(GraphicsBuffer, RemembersWhatWasSetLast)
{
    GraphicsBuffer buffer(Target::Structured, 4, 4);
    buffer.SetData(std::vector<int>{1, 2, 3, 4});
    buffer.SetData(std::vector<int>{7, 8}, 1, 2, 1);
    ASSERT_EQ(buffer.changes().size(), 2u);
    EXPECT_EQ(buffer.changes()[1].offset, 8u);
    EXPECT_EQ(buffer.changes()[1].size, 4u);
    int last = 0;
    std::memcpy(&last, buffer.bytes().data() + 8, 4);
    EXPECT_EQ(last, 8);
    for (int i = 0; i < 10; ++i)
    {
        buffer.SetData(std::vector<int>{i, i}, 0, 2, 2); // over the last one
    }
    EXPECT_EQ(buffer.changes().size(), 2u) << "those that are covered are gone";
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { buffer.SetData(std::vector<int>(5)); }),
                Mentions("GraphicsBuffer: SetData", "20 bytes", "byte 0", "16"));
    EXPECT_THROW(buffer.SetData(std::vector<int>(2), 1, 0, 2), ContractError);
    EXPECT_THROW(buffer.SetCounterValue(1), ContractError);
    buffer.Release();
    EXPECT_FALSE(buffer.IsValid());
    EXPECT_THROW(buffer.SetData(std::vector<int>(1)), ContractError);
}

TEST(GraphicsBuffer, HasNothingToReadWhereNothingRuns)
{
    RecordingDevice device;
    std::vector<int> data(1);
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&] { ComputeBuffer(1, 4).GetData(device, data); }),
        Mentions("no kernels", "'ComputeBuffer'", "read back"));
}

TEST(GraphicsBuffer, IsBoundInPartsFromMultiplesOf256On)
{
    const auto buffer = Buffer(Target::Constant, 64, 16, "constants");
    MaterialPropertyBlock block;
    EXPECT_THAT(test::ThrownMessage<ContractError>(
                    [&] { block.SetConstantBuffer("Params", buffer, 128, 16); }),
                Mentions("SetConstantBuffer", "16 bytes", "byte 128", "'constants'", "1024",
                         "multiple of 256"));
    EXPECT_THROW(block.SetConstantBuffer("Params", buffer, 768, 512), ContractError);
    EXPECT_FALSE(block.hasBuffers());
    block.SetConstantBuffer("Params", buffer, 768, 256);
    EXPECT_TRUE(block.hasBuffers());
}

TEST(EnableRandomWrite, IsForColoursOfOneSample)
{
    const auto make = [](GraphicsFormat format, int samples)
    {
        RenderTextureDescriptor descriptor(4, 4, format);
        descriptor.enableRandomWrite = true;
        descriptor.msaaSamples = samples;
        RenderTexture("texture", descriptor);
    };
    make(GraphicsFormat::R16G16B16A16_SFloat, 1);
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&] { make(GraphicsFormat::R8G8B8A8_SRGB, 1); }),
        Mentions("'texture'", "enableRandomWrite", "1 sample of", "R8G8B8A8_SRGB", "not sRGB"));
    EXPECT_THROW(make(GraphicsFormat::R8G8B8A8_UNorm, 4), ContractError);
    EXPECT_THROW(make(GraphicsFormat::D32_SFloat, 1), ContractError);
}

} // namespace limn

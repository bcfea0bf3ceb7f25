#include "compute/ComputeRun.h"

#include <limn/core/AsyncGPUReadback.h>

namespace limn::test
{

namespace
{

using Rgba = std::array<std::uint8_t, 4>;

void FillWith(const TargetPtr& target, const Color& color)
{
    CommandBuffer cmd;
    cmd.SetRenderTarget(RTHandle(target));
    cmd.ClearRenderTarget(ClearFlag::Color, color);
    RunCommands(cmd, {target});
}

std::vector<Rgba> TexelsOf(const AsyncGPUReadbackRequest& request)
{
    const auto data = request.GetData<Rgba>();
    return {data.begin(), data.end()};
}

const std::vector<Rgba> k_RedTexels(8, Rgba{255, 0, 0, 255});
const std::vector<Rgba> k_BlueTexels(8, Rgba{0, 0, 255, 255});

class AsyncReadback : public GpuTest
{
};

} // namespace

TEST_F(AsyncReadback, HasWhatTheFrameLeftThoughLaterOnesDrawOver)
{
    const TargetPtr target = MakeTarget(4, 2);
    FillWith(target, Color::red);
    auto red = AsyncGPUReadback::Request(SharedDevice(), *target);
    FillWith(target, Color::blue);
    auto blue = AsyncGPUReadback::Request(SharedDevice(), *target);
    FillWith(target, Color::green);
    blue.WaitForCompletion();
    red.WaitForCompletion();
    EXPECT_FALSE(red.hasError());
    EXPECT_EQ(TexelsOf(red), k_RedTexels);
    EXPECT_EQ(TexelsOf(blue), k_BlueTexels);
    EXPECT_EQ(red.width(), 4);
    EXPECT_EQ(red.height(), 2);
    EXPECT_EQ(red.layerDataSize(), 32u);
    ExpectNoValidationMessages();
}

TEST_F(AsyncReadback, KeepsATextureThatNobodyElseDoes)
{
    TargetPtr target = MakeTarget(4, 2);
    FillWith(target, Color::red);
    auto request = AsyncGPUReadback::Request(SharedDevice(), *target);
    target.reset();
    for (int i = 0; i < 4; ++i)
    {
        FillWith(MakeTarget(4, 2), Color::green);
    }
    request.WaitForCompletion();
    EXPECT_EQ(TexelsOf(request), k_RedTexels);
    ExpectNoValidationMessages();
}

TEST_F(AsyncReadback, CallsBackOnceWhenTheDeviceGoesOn)
{
    const TargetPtr target = MakeTarget(4, 2);
    FillWith(target, Color::red);
    int calls = 0;
    const auto request = AsyncGPUReadback::Request(SharedDevice(), *target,
                                                   [&](const AsyncGPUReadbackRequest& finished)
                                                   {
                                                       ++calls;
                                                       EXPECT_TRUE(finished.done());
                                                       EXPECT_EQ(TexelsOf(finished), k_RedTexels);
                                                   });
    SharedDevice().Wait();
    EXPECT_TRUE(request.done());
    EXPECT_EQ(calls, 1);
    FillWith(target, Color::green);
    EXPECT_EQ(calls, 1);
}

TEST_F(AsyncReadback, IsOverAfterSomeFramesThatDoNotWaitForIt)
{
    const TargetPtr target = MakeTarget(4, 2);
    FillWith(target, Color::red);
    const auto request = AsyncGPUReadback::Request(SharedDevice(), *target);
    const TargetPtr other = MakeTarget(4, 2);
    for (int i = 0; i < 4; ++i) // two are in flight at most
    {
        FillWith(other, Color::green);
    }
    EXPECT_TRUE(request.done());
    EXPECT_EQ(TexelsOf(request), k_RedTexels);
}

TEST_F(AsyncReadback, HasABuffersElementsOfEachFrame)
{
    const auto kernel =
        MakeKernel("1, 1, 1", "RWStructuredBuffer<uint> _Sum;", "_Sum[id.x] += id.x + 1;");
    const auto sum = MakeBuffer(std::vector<std::uint32_t>{0, 0, 0});
    kernel->SetBuffer(0, "_Sum", sum);
    std::vector<AsyncGPUReadbackRequest> requests;
    for (int i = 0; i < 4; ++i)
    {
        CommandBuffer cmd;
        cmd.DispatchCompute(kernel, 0, 3, 1, 1);
        RunCommands(cmd);
        requests.push_back(AsyncGPUReadback::Request(SharedDevice(), *sum));
    }
    for (std::uint32_t i = 0; i < 4; ++i)
    {
        requests[i].WaitForCompletion();
        const auto data = requests[i].GetData<std::uint32_t>();
        EXPECT_EQ(std::vector(data.begin(), data.end()),
                  (std::vector<std::uint32_t>{i + 1, 2 * (i + 1), 3 * (i + 1)}));
    }
    EXPECT_THROW(requests[0].GetData<Rgba[2]>(), ContractError) << "12 bytes are no whole number";
    ExpectNoValidationMessages();
}

TEST_F(AsyncReadback, OutlivesItsDevice)
{
    std::optional<AsyncGPUReadbackRequest> request;
    bool isCalled = false;
    const TargetPtr target = MakeTarget(4, 2);
    {
        VulkanDeviceOptions options;
        options.device = SharedDevice().deviceName();
        options.validation = true;
        VulkanDevice device(options);
        RenderReport report;
        ScriptableRenderContext context(report);
        CommandBuffer cmd;
        cmd.SetRenderTarget(RTHandle(target));
        cmd.ClearRenderTarget(ClearFlag::Color, Color::red);
        context.ExecuteCommandBuffer(cmd);
        device.Execute(
            CompileFrame(context.TakeCommands(), device.textureStates(), std::vector{target}));
        request.emplace(AsyncGPUReadback::Request(
            device, *target, [&](const AsyncGPUReadbackRequest&) { isCalled = true; }));
    }
    EXPECT_TRUE(request->done());
    EXPECT_FALSE(isCalled);
    EXPECT_EQ(TexelsOf(*request), k_RedTexels);
}

TEST_F(AsyncReadback, IsRefusedOfWhatNoFrameLeft)
{
    EXPECT_THROW(AsyncGPUReadback::Request(SharedDevice(), *MakeTarget(4, 2)), ContractError);
    EXPECT_THROW(
        AsyncGPUReadback::Request(SharedDevice(), *MakeBuffer(std::vector<std::uint32_t>{1})),
        ContractError);
}

} // namespace limn::test

#include "features/OutlineScene.h"
#include "vulkan/GpuTestDevice.h"

using namespace limn;
using namespace limn::test;

namespace
{

class ManyFramesGpu : public GpuTest
{
};

TEST_F(ManyFramesGpu, TakeNoMoreThanTheFirstFewDo)
{
    VulkanDeviceOptions options;
    options.device = SharedDevice().deviceName();
    VulkanDevice device(options);
    UniversalRenderPipeline pipeline(device);
    UniversalRenderer renderer(Compiler());
    AddOutline(renderer);
    OutlineScene content;
    BlendedOutline volumes;
    RenderRequest request;
    request.scene = &content.scene;
    request.camera = &content.camera;
    request.width = 16;
    request.height = 16;
    const auto draw = [&](int from, int to)
    {
        for (int i = from; i < to; ++i)
        {
            content.scene.Find("Cube")->transform.localRotation =
                EulerToRotation({0.0f, static_cast<float>(i), 0.0f});
            request.volumeStack = &volumes.With(i / 5 % 2 == 0, Color::green, 3.0f);
            pipeline.RenderSingleCamera(renderer, request);
        }
        return device.statistics();
    };
    const VulkanDeviceStatistics first = draw(0, 40);
    const VulkanDeviceStatistics last = draw(40, 600);
    EXPECT_GT(first.usedBytes, 0u);
    EXPECT_EQ(last.allocatedBytes, first.allocatedBytes);
    EXPECT_EQ(last.usedBytes, first.usedBytes);
    EXPECT_EQ(last.images, first.images);
    EXPECT_EQ(last.meshes, first.meshes);
    EXPECT_EQ(last.meshUploads, first.meshUploads);
    EXPECT_EQ(last.pipelines, first.pipelines);
}

} // namespace

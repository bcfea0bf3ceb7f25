// Whether frames stay as they are however many there have been: time of a thousand frames and
// memory of the process, at the beginning and later. An outline goes on and off around objects that
// turn.
//
//   build/release/tests/flat_benchmark [--quick] [--frames N]

#include "NoDevice.h"
#include "Samples.h"
#include "features/OutlineScene.h"

#include <cstdlib>
#include <cstring>
#include <limn/vulkan/VulkanDevice.h>
#include <limn/vulkan/VulkanError.h>

namespace limn::benchmarks
{

namespace
{

void Run(GraphicsDevice& device, const char* name, int frames)
{
    std::printf("%s, %d frames of 32x32\n%10s %22s %14s\n", name, frames, "frame",
                "ms a thousand frames", "memory, MiB");
    UniversalRenderPipeline pipeline(device);
    UniversalRenderer renderer{test::Compiler()};
    test::AddOutline(renderer);
    test::OutlineScene content;
    test::BlendedOutline volumes;
    RenderRequest request;
    request.scene = &content.scene;
    request.camera = &content.camera;
    request.width = 32;
    request.height = 32;
    const int step = std::max(frames / 10, 1);
    for (int frame = 0; frame < frames; frame += step)
    {
        const double milliseconds = Time(
            [&]
            {
                for (int i = frame; i < frame + step; ++i)
                {
                    GameObject& cube = *content.scene.Find("Cube");
                    cube.transform.localRotation =
                        EulerToRotation({0.0f, static_cast<float>(i % 360), 0.0f});
                    request.volumeStack =
                        &volumes.With(i / 50 % 2 == 0, Color{1, 0.5f, 0, 1}, 3.0f);
                    pipeline.RenderSingleCamera(renderer, request);
                }
                device.LastFrameTimings(); // waits for the last one
            });
        std::printf("%10d %22.2f %14.1f\n", frame + step, milliseconds * 1000.0 / step,
                    ResidentBytes() / (1024.0 * 1024.0));
        std::fflush(stdout);
    }
}

} // namespace

} // namespace limn::benchmarks

int main(int argc, char** argv)
{
    int frames = 100'000;
    for (int i = 1; i < argc; ++i)
    {
        frames = std::strcmp(argv[i], "--quick") == 0 ? 20 : frames;
        frames =
            std::strcmp(argv[i], "--frames") == 0 && i + 1 < argc ? std::atoi(argv[i + 1]) : frames;
    }
    limn::benchmarks::NoDevice none;
    limn::benchmarks::Run(none, "without a device", frames);
    try
    {
        limn::VulkanDevice device;
        limn::benchmarks::Run(device, device.ChoiceSentence().c_str(), frames);
    }
    catch (const limn::VulkanError& error)
    {
        std::printf("no device: %s\n", error.what());
    }
}

// The article's frame, limn's against one written by hand in plain Vulkan, in one run: frames of
// the two take turns, and ratios of neighbours are printed as their median with the tenth and
// ninetieth part of them. Both look for objects that have moved, cull, filter, sort, and keep their
// commands where the same is drawn. CPU time is the calling thread's, device time the sum of the
// passes' timestamps; a frame is finished when its picture is there.
//
//   cmake --preset release -DLIMN_BUILD_TESTS=ON && cmake --build --preset release --target
//   frame_benchmark build/release/tests/frame_benchmark [--quick] [--pairs N] [--device NAME]
//   [frame|regions|disc]...
//
// --quick, a smoke test, fails where a picture of limn's is not the one drawn by hand.

#include "CountAllocations.h"
#include "CountDraws.h"
#include "Samples.h"
#include "frame/HandWrittenFrame.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limn/vulkan/VulkanDevice.h>
#include <limn/vulkan/VulkanError.h>
#include <stdexcept>

namespace limn::benchmarks
{

namespace
{

struct Options
{
    bool quick = false;
    int pairs = 31;
    std::string device;
    std::vector<std::string> tables;
};

/// Of the calling thread: what it waits for does not count.
double CpuMilliseconds()
{
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

double WallMilliseconds()
{
    const std::chrono::duration<double, std::milli> time =
        std::chrono::steady_clock::now().time_since_epoch();
    return time.count();
}

/// A device that takes the time of Execute().
class TimedDevice final : public GraphicsDevice
{
public:
    explicit TimedDevice(const std::string& name)
        : m_Device(
              [&]
              {
                  VulkanDeviceOptions o;
                  o.device = name;
                  return o;
              }())
    {
    }

    void Execute(const CompiledFrame& frame) override
    {
        const double begin = CpuMilliseconds();
        m_Device.Execute(frame);
        recordMilliseconds = CpuMilliseconds() - begin;
    }
    const TextureStates& textureStates() const override { return m_Device.textureStates(); }
    TextureFootprint Footprint(const RenderTexture& texture) override
    {
        return m_Device.Footprint(texture);
    }
    bool IsFormatSupported(GraphicsFormat format, FormatUsage usage) const override
    {
        return m_Device.IsFormatSupported(format, usage);
    }
    int GetRenderTextureSupportedMSAASampleCount(
        const RenderTextureDescriptor& descriptor) const override
    {
        return m_Device.GetRenderTextureSupportedMSAASampleCount(descriptor);
    }
    Image ReadBack(const RenderTexture& texture) override { return m_Device.ReadBack(texture); }
    std::vector<PassTiming> LastFrameTimings() override
    {
        m_Device.Wait();
        return m_Device.LastFrameTimings();
    }
    const std::string& name() const { return m_Device.ChoiceSentence(); }

    double recordMilliseconds = 0.0; ///< of the last Execute

private:
    VulkanDevice m_Device;
};

void PrintColumns(Comparison& comparison)
{
    std::printf(" | %8.3f %8.3f %5.2f [%.2f-%.2f]", comparison.first.Median(),
                comparison.second.Median(), comparison.ratio.Median(), comparison.ratio.Part(0.1),
                comparison.ratio.Part(0.9));
}

double Sum(const std::vector<PassTiming>& timings)
{
    double sum = 0.0;
    for (const PassTiming& timing : timings)
    {
        sum += timing.milliseconds;
    }
    return sum;
}

/// Tells how far pictures differ from those that they should equal.
struct Difference
{
    std::size_t bytes = 0;
    int largest = 0;

    void Add(const Image& limn, const Image& hand)
    {
        for (std::size_t i = 0; i < limn.texels.size(); ++i)
        {
            const int difference = std::abs(std::to_integer<int>(limn.texels[i]) -
                                            std::to_integer<int>(hand.texels.at(i)));
            bytes += difference != 0 ? 1 : 0;
            largest = std::max(largest, difference);
        }
    }
    void Print() const
    {
        if (bytes == 0)
        {
            std::printf("pictures equal\n");
        }
        else
        {
            std::printf("%zu bytes differ, by %d at most\n", bytes, largest);
        }
    }
};

/// Compares one kind of frame.
void CompareFrames(const ArticleSettings& settings, const Options& options,
                   Movement moving = Movement::None)
{
    constexpr const char* k_Moving[] = {"-", "camera", "1 %", "all"};
    TimedDevice device(options.device);
    ArticleScene scene(settings, device);
    const ArticleNumbers numbers = NumbersOf(scene);
    const RenderResult first = scene.Render(); // a copy: what it says stays
    HandWrittenFrame hand(numbers, options.device);
    hand.Draw();
    hand.Wait();
    std::printf("%4dx%-4d %6d %5zu/%-5zu %-6s", settings.width, settings.height, settings.objects,
                CountDraws(*first.frame), hand.drawCount(),
                k_Moving[static_cast<std::size_t>(moving)]);
    Comparison record;
    Comparison whole;
    Comparison deviceTime;
    Comparison finished;
    Samples allocations;
    for (int i = 0; i < options.pairs; ++i)
    {
        scene.Move(moving, i);
        hand.Move(moving, i);
        const long counted = AllocationCount();
        const double limnWall = WallMilliseconds();
        const double limnBegin = CpuMilliseconds();
        scene.Render();
        const double limnWhole = CpuMilliseconds() - limnBegin;
        allocations.Add(static_cast<double>(AllocationCount() - counted));
        const double limnDevice = Sum(device.LastFrameTimings());
        const double handWall = WallMilliseconds();
        const double handBegin = CpuMilliseconds();
        hand.Draw();
        const double handWhole = CpuMilliseconds() - handBegin;
        hand.Wait();
        finished.Add(handWall - limnWall, WallMilliseconds() - handWall);
        record.Add(device.recordMilliseconds, handWhole);
        whole.Add(limnWhole, handWhole);
        deviceTime.Add(limnDevice, hand.DeviceMilliseconds());
    }
    PrintColumns(record);
    PrintColumns(whole);
    PrintColumns(deviceTime);
    PrintColumns(finished);
    std::printf(" | %4.0f | ", allocations.Median());
    Difference difference;
    for (const int step : {1, 0})
    {
        scene.Move(moving, step);
        hand.Move(moving, step);
        scene.Render();
        hand.Draw();
        difference.Add(device.ReadBack(*first.output.rt()), hand.ReadBack());
    }
    difference.Print();
    if (options.quick && difference.bytes > 0)
    {
        throw std::runtime_error("limn's picture is not the one drawn by hand");
    }
}

void FrameTable(const Options& options)
{
    std::printf(
        "\n(a) The article's frame, regions off: ms of limn, ms by hand, ratio [10 %%-90 %%]\n"
        "size     objects draws       moves  | record and submit, CPU          | whole frame, CPU"
        "                | device                          | until it is finished, wall        | "
        "allocations\n");
    const int width = options.quick ? 64 : 1280;
    for (const int objects : {1, 100, 10000})
    {
        ArticleSettings settings;
        settings.width = width;
        settings.height = width * 9 / 16;
        settings.objects = options.quick ? std::min(objects, 200) : objects;
        for (const Movement moving :
             {Movement::None, Movement::Camera, Movement::Some, Movement::All})
        {
            CompareFrames(settings, options, moving);
        }
        if (!options.quick)
        {
            settings.width = 1920;
            settings.height = 1080;
            CompareFrames(settings, options);
        }
    }
    ArticleSettings settings; // no two objects alike: nothing can be an instance
    settings.width = width;
    settings.height = width * 9 / 16;
    settings.meshes = settings.materials = options.quick ? 10 : 100;
    settings.objects = settings.meshes * settings.materials;
    CompareFrames(settings, options);
}

/// A scene on a device that others share, and its device time by frame.
class TimedScene
{
public:
    TimedScene(const ArticleSettings& settings, TimedDevice& device)
        : m_Device(device), m_Scene(settings, device)
    {
        m_Scene.Render();
    }
    double Draw()
    {
        m_Scene.Render();
        return Sum(m_Device.LastFrameTimings());
    }

private:
    TimedDevice& m_Device;
    ArticleScene m_Scene;
};

void RegionTable(const Options& options)
{
    // Without an outline an opaque picture needs no camera colour but the output, nor a final blit.
    std::printf("\n(b) Regions off, regions on: device ms, ratio [10 %%-90 %%]\n%-28s | frame"
                "                           | the outline's passes            | and the camera's "
                "colour that they need\n",
                "");
    ArticleSettings off;
    off.width = options.quick ? 64 : 1920;
    off.height = off.width * 9 / 16;
    const std::tuple<const char*, PrimitiveType, float> objects[] = {
        {"a quad, 10 % of the picture", PrimitiveType::Quad, 0.42f},
        {"a disc, 10 % of the picture", PrimitiveType::Sphere, 0.45f}};
    for (const auto& [what, shape, size] : objects)
    {
        off.shape = shape;
        off.size = size;
        ArticleSettings on = off;
        on.limitsRegions = true;
        ArticleSettings without = on;
        without.hasOutline = false;
        ArticleSettings blitted = without;
        blitted.leavesOut = false;
        TimedDevice device(options.device);
        TimedScene scenes[] = {{off, device}, {on, device}, {blitted, device}, {without, device}};
        Comparison frames;
        Comparison passes;
        Comparison added;
        for (int i = 0; i < options.pairs; ++i)
        {
            const double noPasses = scenes[2].Draw();
            const double whole = scenes[0].Draw();
            const double limited = scenes[1].Draw();
            const double plain = scenes[3].Draw();
            frames.Add(whole, limited);
            passes.Add(whole - noPasses, limited - noPasses);
            added.Add(whole - plain, limited - plain);
        }
        std::printf("%-28s", what);
        PrintColumns(frames);
        PrintColumns(passes);
        PrintColumns(added);
        std::printf("\n");
    }
}

void DiscTable(const Options& options)
{
    std::printf(
        "\n(c) One disc, as a picture is drawn: device ms with the outline, without, ratio\n");
    ArticleSettings with;
    with.width = options.quick ? 64 : 1920;
    with.height = with.width * 9 / 16;
    with.shape = PrimitiveType::Sphere;
    with.size = 0.35f;
    with.limitsRegions = true;
    ArticleSettings without = with;
    without.hasOutline = false;
    TimedDevice device(options.device);
    TimedScene scenes[] = {{with, device}, {without, device}};
    Comparison comparison;
    for (int i = 0; i < options.pairs; ++i)
    {
        const double outlined = scenes[0].Draw();
        comparison.Add(outlined, scenes[1].Draw());
    }
    std::printf("disc, %dx%d", with.width, with.height);
    PrintColumns(comparison);
    std::printf("\n");
}

Options ParseOptions(int count, char** arguments)
{
    Options options;
    for (int i = 1; i < count; ++i)
    {
        const std::string argument = arguments[i];
        if (argument == "--quick")
        {
            options.quick = true;
            options.pairs = 2;
        }
        else if (argument == "--pairs" && i + 1 < count)
        {
            options.pairs = std::max(1, std::atoi(arguments[++i]));
        }
        else if (argument == "--device" && i + 1 < count)
        {
            options.device = arguments[++i];
        }
        else
        {
            options.tables.push_back(argument);
        }
    }
    return options;
}

int Run(const Options& options)
{
    const std::pair<const char*, void (*)(const Options&)> tables[] = {
        {"frame", FrameTable}, {"regions", RegionTable}, {"disc", DiscTable}};
    std::printf("%s\n", TimedDevice(options.device).name().c_str());
    for (const auto& [name, print] : tables)
    {
        if (options.tables.empty() || std::ranges::count(options.tables, name) > 0)
        {
            print(options);
        }
    }
    return 0;
}

} // namespace

} // namespace limn::benchmarks

int main(int count, char** arguments)
{
    try
    {
        return limn::benchmarks::Run(limn::benchmarks::ParseOptions(count, arguments));
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

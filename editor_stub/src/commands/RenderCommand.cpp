#include "commands/Commands.h"

#include "assets/FileKind.h"
#include "assets/OutputFiles.h"
#include "explain/RenderReports.h"
#include "scene/SceneView.h"
#include "shaders/UsedShaders.h"
#include "view/VolumeGizmos.h"

#include <algorithm>
#include <future>
#include <limn/vulkan/VulkanDevice.h>
#include <thread>

namespace limn
{

namespace
{

constexpr double k_FramesPerSecond = 60.0;
constexpr const char* k_Stdout = "-";

/// Renders all frames and reads the last one back.
Image RenderFrames(const RenderOptions& options, SceneView& view, GraphicsDevice& device,
                   RenderMeasurements& measurements)
{
    const bool isMeasured = !options.statsFile.empty() || !options.traceFile.empty();
    Timeline* timeline = isMeasured ? &measurements.timeline : nullptr;
    device.SetTimeline(timeline);
    UniversalRenderPipeline pipeline(device);
    for (int frame = 0; frame < options.frames; ++frame)
    {
        const double time = options.time + frame / k_FramesPerSecond;
        const bool isLast = frame + 1 == options.frames;
        measurements.lastFrame = Measure(
            timeline, "frame", [&] { return view.Render(pipeline, time, isLast, timeline); });
    }
    Image image = device.ReadBack(*measurements.lastFrame.output.rt());
    measurements.gpuPasses = device.LastFrameTimings();
    device.SetTimeline(nullptr);
    return image;
}

ExitCode PrintValidation(const std::vector<ValidationMessage>& messages, Console& console)
{
    ExitCode code = ExitCode::Done;
    for (const ValidationMessage& message : messages)
    {
        console.Line("validation: " + message.id + ": " + message.text);
        code = message.severity == Severity::Error ? ExitCode::BadInput : code;
    }
    return code;
}

/// "-" is stdout; nothing is then printed besides.
void WritePicture(const RenderOptions& options, const Image& image, Console& console)
{
    if (options.output != k_Stdout)
    {
        WritePng(options.output, image);
        console.Result(options.output + " " + std::to_string(image.width) + "x" +
                       std::to_string(image.height));
        return;
    }
    const std::vector<std::byte> bytes = EncodePng(image);
    console.out().write(reinterpret_cast<const char*>(bytes.data()),
                        static_cast<std::streamsize>(bytes.size()));
}

} // namespace

ExitCode RunRender(const RenderOptions& options, Console& console)
{
    if (options.output == k_Stdout && console.isOutTerminal())
    {
        console.Error("-o -: stdout is a terminal, which shows no PNG; lead it elsewhere: "
                      "'limn render SCENE -o - > out.png'");
        return ExitCode::WrongUsage;
    }
    RequireKind(options.scene, {FileKind::Scene, FileKind::UnityScene}, "render");
    Allocations::isAsked = !options.statsFile.empty();
    RenderMeasurements measurements;
    measurements.frames = options.frames;
    Timeline& timeline = measurements.timeline;

    const ShaderCompilerOptions compilerOptions = ChooseCompilerOptions(options, console);
    // The device is made while the scene's files are read. Which SubShader a shader draws with
    // depends on it, so the first shader waits.
    std::shared_future<std::shared_ptr<VulkanDevice>> making = std::async(
        std::launch::async, [deviceOptions = VulkanDeviceOptions{options.device, options.validate,
                                                                 compilerOptions.cacheFolder}]
        { return std::make_shared<VulkanDevice>(deviceOptions); });
    const auto missingFeatures = [&]
    {
        return timeline.Measure("device", [&] { return making.get()->missingShaderFeatures(); });
    };
    AssetContext assets(compilerOptions, PluginLoading::File, missingFeatures);
    SceneAsset asset = timeline.Measure("load", [&] { return LoadForRendering(options, assets); });
    VulkanDevice& device = *making.get();
    console.Print(asset.notes);
    console.Print(timeline.Measure("compile shaders", [&] { return CompileUsedShaders(asset); }));
    const std::string outputs[] = {options.output, options.statsFile, options.traceFile};
    RequireOwnFiles(outputs, assets.reachedFiles());

    console.Verbose(device.ChoiceSentence());
    measurements.device = device.deviceName();

    auto view = std::make_unique<SceneView>(std::move(asset), assets);
    Image image = RenderFrames(options, *view, device, measurements);
    measurements.shaders = assets.compiler()->statistics();
    measurements.memory = device.statistics();
    std::ranges::for_each(NotesOf(measurements.lastFrame.report),
                          [&](const auto& each) { console.Note(each); });
    MakeOpaque(image);
    if (options.showsVolumes &&
        DrawVolumes(image, view->asset().camera, view->asset().volumes) == 0)
    {
        console.Note("--show-volumes: the scene has no local volume with a collider, so there is "
                     "none to show; global volumes have no place");
    }
    const std::vector<ValidationMessage> validation = device.validationMessages();
    // To free the scene and the device takes as long as to compress the picture.
    const std::jthread closing(
        [view = std::move(view), making = std::move(making)]() mutable
        {
            view.reset();
            making = {};
        });
    timeline.Measure("write", [&] { WritePicture(options, image, console); });
    if (!options.statsFile.empty())
    {
        WriteStats(options.statsFile, measurements);
    }
    if (!options.traceFile.empty())
    {
        WriteTrace(options.traceFile, measurements);
    }
    return PrintValidation(validation, console);
}

} // namespace limn

#include "RenderCommand.h"

#include "CacheFolder.h"
#include "RenderReports.h"
#include "UsedShaders.h"

#include <limn/editor_stub/Overrides.h>
#include <limn/editor_stub/RunLimn.h>
#include <limn/volume/VolumeManager.h>
#include <limn/vulkan/VulkanDevice.h>
#include <optional>
#include <set>

namespace limn
{

namespace
{

constexpr float k_SecondsPerFrame = 1.0f / 60.0f;

/// Hands everything on and measures how long starting frames and waiting for them takes.
class MeasuredDevice final : public GraphicsDevice
{
public:
    MeasuredDevice(GraphicsDevice& device, Timeline& timeline)
        : m_Device(device), m_Timeline(timeline)
    {
    }

    void Execute(const CompiledFrame& frame) override
    {
        m_Timeline.Measure("submit", [&] { m_Device.Execute(frame); });
    }
    Image ReadBack(const RenderTexture& texture) override
    {
        return m_Timeline.Measure("wait", [&] { return m_Device.ReadBack(texture); });
    }
    std::vector<PassTiming> LastFrameTimings() override { return m_Device.LastFrameTimings(); }

private:
    GraphicsDevice& m_Device;
    Timeline& m_Timeline;
};

/// "" if nothing is to be kept. A default folder that cannot be made is no reason not to draw.
std::filesystem::path ChooseCacheFolder(const RenderOptions& options, Console& console)
{
    if (options.noCache)
    {
        return {};
    }
    const bool isDefault = options.cacheFolder.empty();
    const std::filesystem::path folder =
        isDefault ? DefaultCacheFolder() : std::filesystem::path(options.cacheFolder);
    const std::string problem = folder.empty() ? std::string() : MakeFolder(folder);
    if (problem.empty())
    {
        return folder;
    }
    if (!isDefault)
    {
        throw AssetError(folder.string(), {}, "the cache folder cannot be made: " + problem);
    }
    console.Note("nothing is cached: " + folder.string() + " cannot be made: " + problem);
    return {};
}

SceneAsset Load(const RenderOptions& options, AssetContext& assets)
{
    SceneAsset asset = LoadScene(options.scene, assets);
    if (!options.profile.empty())
    {
        ReplaceProfile(asset, options.profile, assets);
    }
    ApplyOverrides(asset, options.overrides, assets);
    asset.width = options.width > 0 ? options.width : asset.width;
    asset.height = options.height > 0 ? options.height : asset.height;
    return asset;
}

std::unique_ptr<UniversalRenderer> MakeRenderer(RendererAsset& data, const AssetContext& assets)
{
    auto renderer = std::make_unique<UniversalRenderer>(assets.compiler());
    renderer->opaqueLayerMask = data.opaqueLayerMask;
    renderer->transparentLayerMask = data.transparentLayerMask;
    for (std::unique_ptr<ScriptableRendererFeature>& feature : data.features)
    {
        renderer->AddFeature(std::move(feature));
    }
    data.features.clear();
    return renderer;
}

/// Renders all frames and reads the last one back.
Image RenderFrames(const RenderOptions& options, SceneAsset& asset, const AssetContext& assets,
                   GraphicsDevice& device, RenderMeasurements& measurements)
{
    MeasuredDevice measured(device, measurements.timeline);
    VolumeManager volumes(assets.volumeComponents());
    for (const Volume& volume : asset.volumes)
    {
        volumes.Register(&volume);
    }
    VolumeStack stack = volumes.CreateStack();
    const glm::vec3 cameraPosition = asset.camera.transform.position();
    volumes.Update(stack, asset.camera.volumeTrigger.value_or(cameraPosition),
                   asset.camera.volumeLayerMask);

    const auto renderer = MakeRenderer(asset.renderer, assets);
    UniversalRenderPipeline pipeline(measured);
    RenderRequest request;
    request.scene = &asset.scene;
    request.camera = &asset.camera;
    request.width = asset.width;
    request.height = asset.height;
    request.volumeStack = &stack;
    for (int frame = 0; frame < options.frames; ++frame)
    {
        request.time =
            static_cast<float>(options.time) + static_cast<float>(frame) * k_SecondsPerFrame;
        measurements.lastFrame = measurements.timeline.Measure(
            "frame", [&] { return pipeline.RenderSingleCamera(*renderer, request); });
    }
    Image image = measured.ReadBack(*measurements.lastFrame.output.rt());
    measurements.gpuPasses = device.LastFrameTimings();
    return image;
}

/// A screen shows no alpha; what blending left there would make a PNG see-through.
void MakeOpaque(Image& image)
{
    for (std::size_t i = 3; i < image.texels.size(); i += 4)
    {
        image.texels[i] = std::byte{255};
    }
}

void PrintNotes(const RenderReport& report, Console& console)
{
    std::set<std::string> printed;
    for (const std::string& note : report.notes)
    {
        if (printed.insert(note).second)
        {
            console.Note(note);
        }
    }
}

ExitCode PrintValidation(const VulkanDevice& device, Console& console)
{
    ExitCode code = ExitCode::Done;
    for (const ValidationMessage& message : device.validationMessages())
    {
        console.Line("validation: " + message.id + ": " + message.text);
        code = message.severity == Severity::Error ? ExitCode::BadInput : code;
    }
    return code;
}

} // namespace

int RunRender(const RenderOptions& options, Console& console)
{
    RenderMeasurements measurements;
    measurements.frames = options.frames;
    Timeline& timeline = measurements.timeline;

    const std::filesystem::path cacheFolder = ChooseCacheFolder(options, console);
    ShaderCompilerOptions compilerOptions;
    compilerOptions.cacheFolder = cacheFolder;
    compilerOptions.packages.insert(options.packages.begin(), options.packages.end());
    AssetContext assets(compilerOptions);
    SceneAsset asset = timeline.Measure("load", [&] { return Load(options, assets); });
    console.Print(asset.notes);
    timeline.Measure("compile shaders", [&] { CompileUsedShaders(asset); });

    const VulkanDeviceOptions deviceOptions{options.device, options.validate, cacheFolder};
    const auto device =
        timeline.Measure("device", [&] { return std::make_unique<VulkanDevice>(deviceOptions); });
    console.Line(device->ChoiceSentence());
    measurements.device = device->deviceName();

    Image image = RenderFrames(options, asset, assets, *device, measurements);
    measurements.shaders = assets.compiler()->statistics();
    PrintNotes(measurements.lastFrame.report, console);
    MakeOpaque(image);
    timeline.Measure("write", [&] { WritePng(options.output, image); });
    console.out() << options.output << ' ' << image.width << 'x' << image.height << '\n';
    if (!options.statsFile.empty())
    {
        WriteStats(options.statsFile, measurements);
    }
    if (!options.traceFile.empty())
    {
        WriteTrace(options.traceFile, measurements);
    }
    return static_cast<int>(PrintValidation(*device, console));
}

} // namespace limn

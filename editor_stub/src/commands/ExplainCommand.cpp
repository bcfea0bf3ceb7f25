#include "commands/ExplainCommand.h"

#include "assets/FileKind.h"
#include "assets/OutputFiles.h"
#include "console/Json.h"
#include "explain/ExplanationText.h"
#include "explain/FrameGraph.h"
#include "explain/pixel/PixelReport.h"
#include "selection/SceneSelection.h"
#include "view/SceneView.h"

#include <algorithm>
#include <chrono>
#include <limn/editor_stub/RunLimn.h>
#include <limn/vulkan/VulkanDevice.h>
#include <set>

namespace limn
{

namespace
{

Json ToJson(const VolumeTrace& trace)
{
    Json all = Json::array();
    for (const VolumeParameterTrace& parameter : trace.parameters)
    {
        Json steps = Json::array();
        for (const VolumeTraceStep& step : parameter.steps)
        {
            steps.push_back({{"volume", step.volume},
                             {"factor", step.factor},
                             {"weight", step.weight},
                             {"distance", step.distance ? Json(*step.distance) : Json()},
                             {"target", step.targetText},
                             {"value", step.valueText}});
        }
        all.push_back({{"component", parameter.component},
                       {"parameter", parameter.parameter},
                       {"default", parameter.startText},
                       {"value", parameter.valueText()},
                       {"steps", steps}});
    }
    return all;
}

Json ToJson(const std::vector<ExplainedObject>& objects)
{
    Json all = Json::array();
    for (const ExplainedObject& object : objects)
    {
        Json draws = Json::array();
        for (const ExplainedDraw& draw : object.draws)
        {
            const bool isTaken = draw.verdict == FilterVerdict::Drawn;
            draws.push_back({{"pass", draw.pass},
                             {"material", draw.material},
                             {"drawn", draw.isDrawn()},
                             {"rule", draw.isDrawn() ? Json()
                                      : isTaken      ? Json(draw.obstacle)
                                                     : Json(ToString(draw.verdict))}});
        }
        all.push_back({{"name", object.name},
                       {"absence", object.absence.empty() ? Json() : Json(object.absence)},
                       {"draws", draws}});
    }
    return all;
}

Json ToJson(const ExplainedFrame& frame, const std::vector<ExplainedBarrier>& barriers)
{
    Json all = Json::array();
    for (const ExplainedBarrier& barrier : barriers)
    {
        all.push_back({{"texture", frame.textures[barrier.texture].name},
                       {"before", barrier.before},
                       {"after", barrier.after}});
    }
    return all;
}

Json ToJson(const ExplainedFrame& frame, const ExplainedPass& pass)
{
    Json targets = Json::array();
    for (const ExplainedAttachment& target : pass.targets)
    {
        targets.push_back({{"texture", frame.textures[target.texture].name},
                           {"load", target.load},
                           {"store", target.store}});
    }
    Json reads = Json::array();
    for (const std::size_t texture : pass.reads)
    {
        reads.push_back(frame.textures[texture].name);
    }
    Json json = {{"name", pass.name},
                 {"width", pass.width},
                 {"height", pass.height},
                 {"targets", targets},
                 {"samples", reads},
                 {"barriers", ToJson(frame, pass.barriers)},
                 {"drawsBeforeInstancing", pass.instances},
                 {"draws", pass.draws},
                 {"drawsInAPart", pass.limited}};
    if (pass.dispatches > 0)
    {
        json["dispatches"] = pass.dispatches;
    }
    if (pass.bufferBarriers > 0)
    {
        json["bufferBarriers"] = pass.bufferBarriers;
    }
    return json;
}

Json ToJson(const ExplainedFrame& frame)
{
    Json passes = Json::array();
    for (const ExplainedPass& pass : frame.passes)
    {
        passes.push_back(ToJson(frame, pass));
    }
    return {{"passes", passes}, {"finalBarriers", ToJson(frame, frame.finalBarriers)}};
}

Json ToJson(const std::vector<ExplainedTexture>& textures)
{
    Json all = Json::array();
    for (const ExplainedTexture& texture : textures)
    {
        all.push_back({{"name", texture.name},
                       {"size", texture.size},
                       {"format", texture.format},
                       {"samples", texture.samples},
                       {"bytes", texture.bytes},
                       {"firstPass", texture.first},
                       {"lastPass", texture.last},
                       {"drawnInto", texture.isDrawn},
                       {"output", texture.isOutput},
                       {"sharesMemoryWith", texture.sharedWith}});
    }
    return all;
}

Json ToJson(const Explanation& explanation)
{
    Json passes = Json::array();
    for (const ExecutedPassReport& pass : explanation.report.passes)
    {
        passes.push_back(
            {{"event", static_cast<int>(pass.renderPassEvent)}, {"name", pass.name.name()}});
    }
    Json variants = Json::array();
    for (const ExplainedVariant& variant : explanation.variants)
    {
        variants.push_back({{"shader", variant.shader},
                            {"pass", variant.passIndex},
                            {"name", variant.passName},
                            {"keywords", variant.keywords},
                            {"fullScreen", variant.isFullScreen}});
    }
    Json leftOut = Json::array();
    for (const LeftOut& item : explanation.frame.leftOut)
    {
        leftOut.push_back(
            {{"pass", item.pass}, {"reason", item.reason}, {"targets", item.targets}});
    }
    Json idleVolumes = Json::array();
    for (const ExplainedIdleVolume& volume : explanation.idleVolumes)
    {
        idleVolumes.push_back({{"name", volume.name}, {"why", volume.why}});
    }
    Json idleFeatures = Json::array();
    for (const ExplainedIdleFeature& feature : explanation.idleFeatures)
    {
        idleFeatures.push_back({{"name", feature.name}, {"why", feature.why}});
    }
    const ExplainedTrigger& trigger = explanation.trigger;
    return {{"trigger",
             {{"position", {trigger.position.x, trigger.position.y, trigger.position.z}},
              {"volumeLayerMask", trigger.volumeLayerMask.bits}}},
            {"volumes", ToJson(explanation.volumes)},
            {"idleVolumes", idleVolumes},
            {"passes", passes},
            {"idleFeatures", idleFeatures},
            {"leftOut", leftOut},
            {"frame", ToJson(explanation.frame)},
            {"textures", ToJson(explanation.frame.textures)},
            {"variants", variants},
            {"variantsBuilt", explanation.builtVariants},
            {"objects", ToJson(explanation.objects)},
            {"choices", explanation.report.choices},
            {"notes", explanation.report.notes}};
}

/// Leaves only the objects of this name, and what hangs below one of it.
void Select(Explanation& explanation, const ExplainOptions& options)
{
    std::vector<ExplainedObject>& objects = explanation.objects;
    std::set<std::string> roots; // names for the message: all would fill the screen
    for (const ExplainedObject& object : objects)
    {
        roots.insert(object.parents.empty() ? object.name : object.parents.back());
    }
    const auto isOther = [&options](const ExplainedObject& object)
    {
        return object.name != options.object &&
               std::find(object.parents.begin(), object.parents.end(), options.object) ==
                   object.parents.end();
    };
    objects.erase(std::remove_if(objects.begin(), objects.end(), isOther), objects.end());
    if (objects.empty())
    {
        throw AssetError(options.scene, {},
                         "unknown object with a mesh " +
                             UnknownName(options.object, {roots.begin(), roots.end()}));
    }
}

RenderOptions RenderingOf(const ExplainOptions& options)
{
    RenderOptions rendering;
    rendering.scene = options.scene;
    rendering.profile = options.profile;
    rendering.overrides = options.overrides;
    rendering.packages = options.packages;
    rendering.plugins = options.plugins;
    rendering.roots = options.roots;
    rendering.device = options.device;
    return rendering;
}

int ExplainPixel(const ExplainOptions& options, Console& console)
{
    const RenderOptions rendering = RenderingOf(options);
    ShaderCompilerOptions compilerOptions = ChooseCompilerOptions(rendering, console);
    VulkanDevice device({options.device, false, compilerOptions.cacheFolder});
    compilerOptions.missingFeatures = device.missingShaderFeatures();
    AssetContext assets(compilerOptions);
    SceneAsset asset = LoadForRendering(rendering, assets);
    console.Print(asset.notes);
    console.Verbose(device.ChoiceSentence());
    const ClickText pixel = ParseClick(options.pixel).value();
    const std::string problem = PixelProblem(pixel, asset.width, asset.height);
    if (!problem.empty())
    {
        throw AssetError("--pixel " + options.pixel, {}, problem);
    }
    const auto begin = std::chrono::steady_clock::now();
    const auto progress = [&](const std::string& text)
    {
        if (std::chrono::steady_clock::now() - begin > std::chrono::seconds(1))
        {
            console.Progress(text);
        }
    };
    const PixelHistory history =
        TracePixel(std::move(asset), assets, device, pixel.x, pixel.y, progress);
    console.Progress("");
    console.Results(options.json ? JsonText(PixelJson(history))
                                 : PixelText(history, console.isVerbose()));
    return static_cast<int>(ExitCode::Done);
}

} // namespace

int RunExplain(const ExplainOptions& options, Console& console)
{
    RequireKind(options.scene, {FileKind::Scene, FileKind::UnityScene}, "explain");
    if (!options.pixel.empty())
    {
        return ExplainPixel(options, console);
    }
    const RenderOptions rendering = RenderingOf(options);
    AssetContext assets(ChooseCompilerOptions(rendering, console));
    SceneAsset asset = LoadForRendering(rendering, assets);
    console.Print(asset.notes);
    Explanation explanation = Explain(std::move(asset), assets);
    if (!options.graph.empty())
    {
        const std::string outputs[] = {options.graph};
        RequireOwnFiles(outputs, assets.reachedFiles());
        WriteGraph(options.graph, FrameGraph(explanation.frame));
    }
    if (!options.object.empty())
    {
        Select(explanation, options);
    }
    if (options.json)
    {
        console.Results(JsonText(ToJson(explanation)));
        return static_cast<int>(ExitCode::Done);
    }
    console.Results(!options.object.empty()
                        ? ObjectText(explanation, options.object, console.isVerbose())
                    : console.isVerbose() ? LongText(explanation)
                                          : ShortText(explanation));
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn

#include "commands/Commands.h"

#include "assets/FileKind.h"
#include "assets/OutputFiles.h"
#include "console/Json.h"
#include "explain/ExplainedFrame.h"
#include "explain/Explanation.h"
#include "explain/pixel/PixelHistory.h"
#include "selection/SceneSelection.h"
#include "shaders/UsedShaders.h"

#include <algorithm>
#include <chrono>
#include <limn/vulkan/VulkanDevice.h>
#include <set>

namespace limn
{

namespace
{

Json TraceStepJson(const VolumeTraceStep& step)
{
    return {
        {"volume", step.volume},     {"factor", step.factor},
        {"weight", step.weight},     {"distance", step.distance ? Json(*step.distance) : Json()},
        {"target", step.targetText}, {"value", step.valueText}};
}

Json TracedValueJson(const VolumeParameterTrace& parameter)
{
    return {{"component", parameter.component},
            {"parameter", parameter.parameter},
            {"default", parameter.startText},
            {"value", parameter.valueText()},
            {"steps", JsonList(parameter.steps, TraceStepJson)}};
}

Json ObjectDrawJson(const ExplainedDraw& draw)
{
    const bool isTaken = draw.verdict == FilterVerdict::Drawn;
    return {{"pass", draw.pass},
            {"material", draw.material},
            {"drawn", draw.isDrawn()},
            {"rule", draw.isDrawn() ? Json()
                     : isTaken      ? Json(draw.obstacle)
                                    : Json(ToString(draw.verdict))}};
}

Json ObjectJson(const ExplainedObject& object)
{
    return {{"name", object.name},
            {"absence", TextOrNull(object.absence)},
            {"draws", JsonList(object.draws, ObjectDrawJson)}};
}

Json BarriersJson(const ExplainedFrame& frame, const std::vector<ExplainedBarrier>& barriers)
{
    return JsonList(barriers,
                    [&](const ExplainedBarrier& barrier) -> Json
                    {
                        return {{"texture", frame.textures[barrier.texture].name},
                                {"before", barrier.before},
                                {"after", barrier.after}};
                    });
}

Json DevicePassJson(const ExplainedFrame& frame, const ExplainedPass& pass)
{
    const auto target = [&](const ExplainedAttachment& attachment) -> Json
    {
        return {{"texture", frame.textures[attachment.texture].name},
                {"load", attachment.load},
                {"store", attachment.store}};
    };
    const auto nameOf = [&](std::size_t texture)
    {
        return frame.textures[texture].name;
    };
    Json json = {{"name", pass.name},
                 {"width", pass.width},
                 {"height", pass.height},
                 {"targets", JsonList(pass.targets, target)},
                 {"samples", JsonList(pass.reads, nameOf)},
                 {"barriers", BarriersJson(frame, pass.barriers)},
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

Json TextureJson(const ExplainedTexture& texture)
{
    return {{"name", texture.name},       {"size", texture.size},
            {"format", texture.format},   {"samples", texture.samples},
            {"bytes", texture.bytes},     {"firstPass", texture.first},
            {"lastPass", texture.last},   {"drawnInto", texture.isDrawn},
            {"output", texture.isOutput}, {"sharesMemoryWith", texture.sharedWith}};
}

Json VariantJson(const ExplainedVariant& variant)
{
    return {{"shader", variant.shader},
            {"pass", variant.passIndex},
            {"name", variant.passName},
            {"keywords", variant.keywords},
            {"fullScreen", variant.isFullScreen}};
}

Json IdleJson(const ExplainedIdle& idle)
{
    return {{"name", idle.name}, {"why", idle.why}};
}

Json ToJson(const Explanation& explanation)
{
    const ExplainedTrigger& trigger = explanation.trigger;
    const ExplainedFrame& frame = explanation.frame;
    const auto executed = [](const ExecutedPassReport& pass) -> Json
    {
        return {{"event", static_cast<int>(pass.renderPassEvent)}, {"name", pass.name.name()}};
    };
    const auto leftOut = [](const LeftOut& item) -> Json
    {
        return {{"pass", item.pass}, {"reason", item.reason}, {"targets", item.targets}};
    };
    const auto pass = [&](const ExplainedPass& one)
    {
        return DevicePassJson(frame, one);
    };
    return {{"trigger",
             {{"position", {trigger.position.x, trigger.position.y, trigger.position.z}},
              {"volumeLayerMask", trigger.volumeLayerMask.bits}}},
            {"volumes", JsonList(explanation.volumes.parameters, TracedValueJson)},
            {"idleVolumes", JsonList(explanation.idleVolumes, IdleJson)},
            {"passes", JsonList(explanation.report.passes, executed)},
            {"idleFeatures", JsonList(explanation.idleFeatures, IdleJson)},
            {"leftOut", JsonList(frame.leftOut, leftOut)},
            {"frame",
             {{"passes", JsonList(frame.passes, pass)},
              {"finalBarriers", BarriersJson(frame, frame.finalBarriers)}}},
            {"textures", JsonList(frame.textures, TextureJson)},
            {"variants", JsonList(explanation.variants, VariantJson)},
            {"variantsBuilt", explanation.builtVariants},
            {"objects", JsonList(explanation.objects, ObjectJson)},
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
               std::ranges::find(object.parents, options.object) == object.parents.end();
    };
    std::erase_if(objects, isOther);
    if (objects.empty())
    {
        throw AssetError(options.rendering.scene, {},
                         "unknown object with a mesh " +
                             UnknownName(options.object, {roots.begin(), roots.end()}));
    }
}

ExitCode ExplainPixel(const ExplainOptions& options, Console& console)
{
    const RenderOptions& rendering = options.rendering;
    ShaderCompilerOptions compilerOptions = ChooseCompilerOptions(rendering, console);
    VulkanDevice device({rendering.device, false, compilerOptions.cacheFolder});
    compilerOptions.missingFeatures = device.missingShaderFeatures();
    AssetContext assets(compilerOptions);
    SceneAsset asset = LoadForRendering(rendering, assets);
    console.Print(asset.notes);
    console.Print(CompileUsedShaders(asset));
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
    options.json ? console.Data(JsonText(PixelJson(history)))
                 : console.Results(PixelText(history, console.isVerbose()));
    return ExitCode::Done;
}

} // namespace

ExitCode RunExplain(const ExplainOptions& options, Console& console)
{
    RequireKind(options.rendering.scene, {FileKind::Scene, FileKind::UnityScene}, "explain");
    if (!options.pixel.empty())
    {
        return ExplainPixel(options, console);
    }
    const RenderOptions& rendering = options.rendering;
    AssetContext assets(ChooseCompilerOptions(rendering, console));
    SceneAsset asset = LoadForRendering(rendering, assets);
    console.Print(asset.notes);
    console.Print(CompileUsedShaders(asset));
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
    options.json
        ? console.Data(JsonText(ToJson(explanation)))
        : console.Results(!options.object.empty()
                              ? ObjectText(explanation, options.object, console.isVerbose())
                          : console.isVerbose() ? LongText(explanation)
                                                : ShortText(explanation));
    return ExitCode::Done;
}

} // namespace limn

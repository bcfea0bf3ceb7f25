#include "explain/Explanation.h"

#include "scene/SceneView.h"
#include "shaders/UsedShaders.h"

#include <algorithm>
#include <limn/core/Culling.h>
#include <limn/core/FeatureFilters.h>
#include <limn/core/RecordingDevice.h>
#include <limn/volume/VolumeManager.h>
#include <set>
#include <tuple>
#include <unordered_map>

namespace limn
{

namespace
{

ExplainedTrigger TriggerOf(const Camera& camera)
{
    return {camera.volumeTrigger.value_or(camera.transform.position()),
            camera.volumeTrigger.has_value(), camera.volumeLayerMask};
}

VolumeTrace TraceVolumes(const SceneAsset& asset, const AssetContext& assets)
{
    VolumeManager manager(assets.volumeComponents());
    for (const Volume& volume : asset.volumes)
    {
        manager.Register(&volume);
    }
    return manager.Trace(TriggerOf(asset.camera).position, asset.camera.volumeLayerMask);
}

std::vector<ExplainedIdle> FindIdleVolumes(const SceneAsset& asset)
{
    std::vector<ExplainedIdle> idle;
    for (const Volume& volume : asset.volumes)
    {
        const std::string why =
            WhyIdle(volume, TriggerOf(asset.camera).position, asset.camera.volumeLayerMask);
        if (!why.empty())
        {
            idle.push_back({volume.name, why});
        }
    }
    return idle;
}

/// Why culling left an object out.
std::string AbsenceOf(const GameObject& object, const Camera& camera)
{
    if (!object.activeSelf || !object.renderer->enabled)
    {
        return object.activeSelf ? "its renderer is disabled" : "inactive";
    }
    const bool hasMaterial = std::ranges::any_of(
        object.renderer->sharedMaterials, [](const auto& material) { return material != nullptr; });
    if (!object.renderer->mesh || !hasMaterial)
    {
        return object.renderer->mesh ? "no material" : "no mesh";
    }
    if (object.renderer->shadowCastingMode == ShadowCastingMode::ShadowsOnly)
    {
        return "it only throws shadows";
    }
    return camera.cullingMask.Intersects(LayerMask::FromIndex(object.layer))
               ? "outside the camera's frustum"
               : "its layer is not in the camera's culling mask";
}

bool IsOfShadows(const DrawRenderersReport& draw)
{
    static const ShaderTagId k_ShadowCaster{"ShadowCaster"};
    return std::ranges::count(draw.drawing.shaderTagIds, k_ShadowCaster) > 0;
}

using ItemsOfObjects = std::unordered_map<const GameObject*, std::vector<RendererItem>>;

std::vector<ExplainedIdle> FindIdleFeatures(const RenderReport& report)
{
    std::vector<ExplainedIdle> idle;
    for (const FeatureReport& feature : report.features)
    {
        if (feature.passes == 0)
        {
            idle.push_back({feature.name.name(), WhyIdle(report, feature)});
        }
    }
    return idle;
}

ExplainedObject ExplainObject(const GameObject& object, const ItemsOfObjects& items,
                              const RenderReport& report,
                              const std::vector<const DrawRenderersReport*>& filters,
                              const Camera& camera)
{
    ExplainedObject explained;
    explained.name = object.name;
    const auto own = items.find(&object);
    if (own == items.end())
    {
        explained.absence = AbsenceOf(object, camera);
        return explained;
    }
    for (const RendererItem& item : own->second)
    {
        for (const DrawRenderersReport* draw : filters)
        {
            if (IsOfShadows(*draw) && object.renderer->shadowCastingMode == ShadowCastingMode::Off)
            {
                continue;
            }
            explained.draws.push_back(
                {draw->pass.name(), item.material->name(),
                 Judge(item.filter, draw->filtering, draw->drawing), ObstacleOf(report, *draw),
                 draw->feature < report.features.size() ? report.features[draw->feature].name.name()
                                                        : ""});
        }
    }
    return explained;
}

/// The passes of shaders that a frame draws with.
std::vector<ExplainedVariant> VariantsOf(const CompiledFrame& frame)
{
    std::vector<ExplainedVariant> variants;
    std::set<std::tuple<const Shader*, int, bool>> known;
    for (const CompiledRenderPass& pass : frame.passes)
    {
        for (const PassCommand& command : pass.commands)
        {
            const auto* draw = std::get_if<DrawCommand>(&command);
            const bool isFullScreen = draw && draw->mesh == DrawCommand::k_NoMesh;
            const DrawSetup* setup = draw ? &frame.Setup(*draw) : nullptr;
            if (setup &&
                known.insert({setup->shader.get(), setup->shaderPass, isFullScreen}).second)
            {
                variants.push_back({setup->shader->name(), setup->shaderPass,
                                    setup->shader->passName(setup->shaderPass),
                                    setup->shader->keywords(setup->shaderPass), isFullScreen});
            }
        }
    }
    return variants;
}

} // namespace

std::vector<const GameObject*> ObjectsOf(const Scene& scene)
{
    std::vector<const GameObject*> objects;
    std::ranges::transform(scene.objects(), std::back_inserter(objects),
                           [](const auto& object) { return object.get(); });
    return objects;
}

std::vector<ExplainedObject> ExplainObjects(const std::vector<const GameObject*>& objects,
                                            const CullingResults& culled,
                                            const RenderReport& report, const Camera& camera)
{
    std::unordered_map<const Transform*, const GameObject*> owners;
    for (const GameObject* object : objects)
    {
        owners[&object->transform] = object;
    }
    ItemsOfObjects items;
    for (const RendererItem& item : culled.items)
    {
        items[item.object].push_back(item);
    }
    const std::vector<const DrawRenderersReport*> filters = DecidingFilters(report);
    std::vector<ExplainedObject> explained;
    for (std::size_t place = 0; place < objects.size(); ++place)
    {
        const GameObject& object = *objects[place];
        if (object.renderer)
        {
            explained.push_back(ExplainObject(object, items, report, filters, camera));
            explained.back().place = place;
            for (const Transform* t = object.transform.parent; t != nullptr; t = t->parent)
            {
                explained.back().parents.push_back(owners.at(t)->name);
            }
        }
    }
    return explained;
}

Explanation Explain(SceneAsset asset, const AssetContext& assets)
{
    CompileUsedShaders(asset);
    Explanation explanation;
    explanation.volumes = TraceVolumes(asset, assets);
    explanation.idleVolumes = FindIdleVolumes(asset);
    explanation.trigger = TriggerOf(asset.camera);

    const Camera camera = asset.camera;
    const float aspect = static_cast<float>(asset.width) / static_cast<float>(asset.height);
    const CullingResults culled = Cull(asset.scene, camera, aspect);
    const std::vector<const GameObject*> objects = ObjectsOf(asset.scene);

    RecordingDevice device;
    UniversalRenderPipeline pipeline(device);
    SceneView view(std::move(asset), assets);
    const RenderResult result = view.Render(pipeline, 0.0, true);
    explanation.report = result.report;
    explanation.frame = ExplainFrame(*result.frame);
    explanation.variants = VariantsOf(*result.frame);
    const ShaderCompiler::Statistics built = assets.compiler()->statistics();
    explanation.builtVariants = built.compiled + built.loadedFromCache;
    explanation.idleFeatures = FindIdleFeatures(result.report);
    explanation.objects = ExplainObjects(objects, culled, result.report, camera);
    return explanation;
}

} // namespace limn

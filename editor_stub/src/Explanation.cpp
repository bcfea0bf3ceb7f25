#include "Explanation.h"

#include "SceneView.h"
#include "UsedShaders.h"

#include <algorithm>
#include <limn/core/Culling.h>
#include <limn/core/RecordingDevice.h>
#include <limn/volume/VolumeManager.h>
#include <unordered_map>

namespace limn
{

namespace
{

VolumeTrace TraceVolumes(const SceneAsset& asset, const AssetContext& assets)
{
    VolumeManager manager(assets.volumeComponents());
    for (const Volume& volume : asset.volumes)
    {
        manager.Register(&volume);
    }
    const Camera& camera = asset.camera;
    return manager.Trace(camera.volumeTrigger.value_or(camera.transform.position()),
                         camera.volumeLayerMask);
}

/// Why culling left an object out.
std::string AbsenceOf(const GameObject& object, const Camera& camera)
{
    if (!object.activeSelf || !object.renderer->enabled)
    {
        return object.activeSelf ? "its renderer is disabled" : "inactive";
    }
    const bool hasMaterial = std::any_of(object.renderer->sharedMaterials.begin(),
                                         object.renderer->sharedMaterials.end(),
                                         [](const auto& material) { return material != nullptr; });
    if (!object.renderer->mesh || !hasMaterial)
    {
        return object.renderer->mesh ? "no material" : "no mesh";
    }
    return camera.cullingMask.Intersects(LayerMask::FromIndex(object.layer))
               ? "outside the camera's frustum"
               : "its layer is not in the camera's culling mask";
}

ExplainedObject ExplainObject(const GameObject& object, const CullingResults& culled,
                              const RenderReport& report, const Camera& camera)
{
    ExplainedObject explained{object.name, {}, {}, {}};
    bool isSeen = false;
    for (const RendererItem& item : culled.items)
    {
        if (item.object != &object)
        {
            continue;
        }
        isSeen = true;
        for (const DrawRenderersReport& draw : report.draws)
        {
            explained.draws.push_back({draw.pass, item.material->name(),
                                       Judge(item.filter, draw.filtering, draw.drawing)});
        }
    }
    explained.absence = isSeen ? std::string() : AbsenceOf(object, camera);
    return explained;
}

std::string Describe(const RenderTexture& texture)
{
    return texture.name() + " " + std::to_string(texture.width()) + "x" +
           std::to_string(texture.height()) + " " + ToString(texture.graphicsFormat());
}

void AddOnce(std::vector<std::string>& list, std::string text)
{
    if (std::find(list.begin(), list.end(), text) == list.end())
    {
        list.push_back(std::move(text));
    }
}

std::vector<std::string> TexturesOf(const CompiledFrame& frame)
{
    std::vector<std::string> textures;
    for (const CompiledRenderPass& pass : frame.passes)
    {
        for (const ColorAttachment& color : pass.colors)
        {
            AddOnce(textures, Describe(*color.texture));
        }
        if (pass.depth)
        {
            AddOnce(textures, Describe(*pass.depth->texture));
        }
    }
    return textures;
}

/// The passes of shaders that DrawRenderers calls draw what they let through with.
std::vector<std::string> VariantsOf(const CullingResults& culled, const RenderReport& report)
{
    std::vector<std::string> variants;
    for (const DrawRenderersReport& draw : report.draws)
    {
        for (const RendererItem& item : culled.items)
        {
            if (Judge(item.filter, draw.filtering, draw.drawing) != FilterVerdict::Drawn)
            {
                continue;
            }
            const Material& material =
                draw.drawing.overrideMaterial ? *draw.drawing.overrideMaterial : *item.material;
            for (const ShaderTagId tag : draw.drawing.shaderTagIds)
            {
                const int own = material.shader()->FindPassByLightMode(tag);
                const int pass =
                    draw.drawing.overrideMaterial ? draw.drawing.overrideMaterialPassIndex : own;
                if (pass >= 0)
                {
                    AddOnce(variants, material.shader()->name() + ", pass " + std::to_string(pass));
                }
            }
        }
    }
    return variants;
}

} // namespace

Explanation Explain(SceneAsset asset, const AssetContext& assets)
{
    CompileUsedShaders(asset);
    Explanation explanation;
    explanation.volumes = TraceVolumes(asset, assets);

    const Camera camera = asset.camera;
    const float aspect = static_cast<float>(asset.width) / static_cast<float>(asset.height);
    const CullingResults culled = Cull(asset.scene, camera, aspect);
    std::vector<const GameObject*> objects; // stay where they are when the scene is moved
    std::unordered_map<const Transform*, const GameObject*> owners;
    for (const auto& object : asset.scene.objects())
    {
        objects.push_back(object.get());
        owners[&object->transform] = object.get();
    }

    RecordingDevice device;
    UniversalRenderPipeline pipeline(device);
    SceneView view(std::move(asset), assets);
    const RenderResult result = view.Render(pipeline, 0.0f);
    explanation.report = result.report;
    explanation.textures = TexturesOf(result.frame);
    explanation.variants = VariantsOf(culled, result.report);
    for (const GameObject* object : objects)
    {
        if (object->renderer)
        {
            explanation.objects.push_back(ExplainObject(*object, culled, result.report, camera));
            for (const Transform* t = object->transform.parent; t != nullptr; t = t->parent)
            {
                explanation.objects.back().parents.push_back(owners.at(t)->name);
            }
        }
    }
    return explanation;
}

} // namespace limn

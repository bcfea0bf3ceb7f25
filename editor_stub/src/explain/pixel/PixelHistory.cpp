#include "explain/pixel/PixelHistory.h"

#include "explain/Explanation.h"
#include "explain/pixel/PassTrace.h"
#include "scene/SceneView.h"
#include "shaders/UsedShaders.h"

#include <algorithm>
#include <cmath>
#include <limn/editor_stub/Raycast.h>
#include <limn/vulkan/VulkanDevice.h>
#include <map>

namespace limn
{

namespace
{

/// Finds the objects that lie at the pixel, whether anything draws them or not; by their places.
std::set<std::size_t> FindOnRay(const TracedScene& scene,
                                const std::map<std::size_t, const ExplainedObject*>& among,
                                const PixelHistory& history)
{
    Scene copies;
    std::map<const GameObject*, std::size_t> places;
    for (const auto& [place, explained] : among)
    {
        const GameObject& object = *scene.objects[place];
        if (object.renderer->mesh)
        {
            GameObject& copy = copies.Add(object.name);
            copy.transform = object.transform;
            copy.renderer = object.renderer;
            copy.renderer->enabled = true;
            places[&copy] = place;
        }
    }
    const Ray ray = PixelToRay(scene.camera, history.width, history.height, history.x, history.y);
    RaycastSettings settings;
    settings.faces = RaycastFaces::Both;
    Raycaster raycaster;
    std::set<std::size_t> found;
    while (const auto hit = raycaster.Raycast(copies, ray, settings))
    {
        hit->gameObject->activeSelf = false; // the next one is behind it
        found.insert(places.at(hit->gameObject));
    }
    return found;
}

std::string WhyAbsent(const ExplainedObject& object)
{
    const bool isDrawn = std::ranges::any_of(object.draws, [](const auto& draw)
                                             { return draw.verdict == FilterVerdict::Drawn; });
    return !object.absence.empty() ? object.absence
           : isDrawn ? "it is drawn only into targets of another layout than the picture"
                     : "every pass leaves it out";
}

/// Adds the objects that are not drawn, left out by a filter or elsewhere.
void AddObjects(const TracedScene& scene, const TracedObjects& traced, PixelHistory& history)
{
    const std::vector<ExplainedObject> explained =
        ExplainObjects(scene.objects, scene.culled, scene.result.report, scene.camera);
    std::map<std::size_t, const ExplainedObject*> undrawn; // by place
    for (const ExplainedObject& object : explained)
    {
        const auto place = static_cast<std::uint32_t>(object.place);
        if (!traced.drawn.contains(place))
        {
            undrawn[place] = &object;
        }
        else if (!traced.reaching.contains(place))
        {
            history.uncovered.push_back(object.name);
        }
        for (const ExplainedDraw& draw : object.draws)
        {
            if (traced.reaching.contains(place) && draw.verdict != FilterVerdict::Drawn)
            {
                history.filtered.push_back({object.name, draw.pass, draw.verdict});
            }
        }
    }
    const std::set<std::size_t> here = FindOnRay(scene, undrawn, history);
    for (const auto& [place, object] : undrawn)
    {
        history.absent.push_back({object->name, WhyAbsent(*object), here.contains(place)});
    }
}

void AddColor(const Image& image, PixelHistory& history)
{
    const std::vector<std::byte> texel = TexelAt(image, history.x, history.y);
    history.color = TexelValue(texel, image.format);
    for (std::size_t i = 0; i < history.written.size(); ++i)
    {
        history.written.at(i) = std::to_integer<int>(texel[i]);
    }
}

} // namespace

bool PixelValue::isChanged() const
{
    const auto isSame = [](float a, float b)
    {
        return a == b || (std::isnan(a) && std::isnan(b));
    };
    return !std::ranges::equal(before, after, isSame);
}

const char* ToString(PixelFate fate)
{
    constexpr std::array k_Names{"cleared", "drawn", "dispatched", "scissor",    "cull",  "discard",
                                 "stencil", "depth", "colorMask",  "outOfReach", "blend", "same"};
    return k_Names.at(static_cast<std::size_t>(fate));
}

PixelHistory TracePixel(SceneAsset asset, const AssetContext& assets, VulkanDevice& device, int x,
                        int y, const std::function<void(const std::string&)>& progress)
{
    CompileUsedShaders(asset);
    PixelHistory history;
    history.x = x;
    history.y = y;
    history.width = asset.width;
    history.height = asset.height;
    TracedScene scene;
    scene.objects = ObjectsOf(asset.scene);
    scene.camera = asset.camera;
    scene.culled = Cull(asset.scene, asset.camera,
                        static_cast<float>(asset.width) / static_cast<float>(asset.height));
    UniversalRenderPipeline pipeline(device);
    SceneView view(std::move(asset), assets);
    view.leavesOut = false;
    scene.result = view.Render(pipeline, 0.0);
    history.notes = scene.result.report.notes;
    AddColor(device.ReadBack(*scene.result.output.rt()), history);

    const TracedObjects traced = TraceFrame(scene, assets.compiler(), device, history, progress);
    AddObjects(scene, traced, history);
    return history;
}

} // namespace limn

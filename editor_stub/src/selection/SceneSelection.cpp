#include "selection/SceneSelection.h"

#include "console/Texts.h"
#include "plugins/LoadPlugin.h"

#include <cmath>
#include <limn/base/Case.h>
#include <limn/base/ParseWhole.h>
#include <limn/features/SelectionOutlineRendererFeature.h>
#include <limn/volume/YamlRead.h>

namespace limn
{

namespace
{

RenderQueueRange QueuesOf(const EnumValue& choice)
{
    for (const EnumEntry& entry : choice.entries)
    {
        if (entry.value == choice.value && entry.name != "All")
        {
            return entry.name == "Opaque" ? RenderQueueRange::opaque
                                          : RenderQueueRange::transparent;
        }
    }
    return RenderQueueRange::all;
}

/// Returns the settings for what any of the features draws. The layer Default marks nothing, since
/// everything is in it.
SelectSettings SettingsFor(const RendererAsset& renderer)
{
    SelectSettings settings;
    for (const std::unique_ptr<ScriptableRendererFeature>& feature : renderer.features)
    {
        const FilterFinder found(*feature);
        const auto& [ranges, layers, marks] = found.filter;
        if (marks.bits == 0 || marks.Intersects(RenderingLayerMask::FromIndex(0)))
        {
            continue;
        }
        const bool isFirst = settings.renderingLayers.bits == 0;
        RenderQueueRange& queues = settings.raycast.renderQueueRange;
        settings.renderingLayers = settings.renderingLayers | marks;
        settings.selectableLayers = isFirst ? layers : settings.selectableLayers | layers;
        queues = isFirst ? ranges
                         : RenderQueueRange(std::min(queues.lowerBound(), ranges.lowerBound()),
                                            std::max(queues.upperBound(), ranges.upperBound()));
    }
    return settings;
}

/// Tells features that colour objects by when they were selected.
void SetStartTimes(SceneAsset& asset)
{
    for (const std::unique_ptr<ScriptableRendererFeature>& feature : asset.renderer.features)
    {
        if (auto* outline = dynamic_cast<SelectionOutlineRendererFeature*>(feature.get()))
        {
            outline->ClearStartTimes();
            for (const Selected& selected : asset.selected)
            {
                outline->SetStartTime(*selected.object, selected.time);
            }
        }
    }
}

std::string OptionOf(const SelectionStep& step)
{
    const char* names[] = {"--select ", "--click ", "--ctrl-click "};
    return names[static_cast<std::size_t>(step.kind)] + step.text;
}

/// A name may have a comma of its own where it stands alone.
std::vector<std::string> NamesIn(const std::string& text, Scene& scene)
{
    if (text.empty() || scene.Find(text))
    {
        return text.empty() ? std::vector<std::string>() : std::vector{text};
    }
    std::vector<std::string> names;
    for (const std::string& name : SplitText(text, ','))
    {
        names.emplace_back(Trim(name));
    }
    return names;
}

class Selector
{
public:
    Selector(SceneAsset& asset, const SelectSettings& settings)
        : m_Asset(asset), m_Controller(asset.scene, settings)
    {
    }

    void Do(const SelectionStep& step)
    {
        AssetDiagnostics diagnostics(OptionOf(step));
        step.kind == SelectionStep::Kind::Select ? Select(step, diagnostics)
                                                 : Click(step, diagnostics);
        diagnostics.ThrowIfErrors();
        m_Asset.selected = m_Controller.selected();
    }

private:
    /// All objects of each name, at time 0.
    void Select(const SelectionStep& step, AssetDiagnostics& diagnostics)
    {
        std::vector<GameObject*> chosen;
        for (const std::string& name : NamesIn(step.text, m_Asset.scene))
        {
            const std::size_t before = chosen.size();
            for (const std::unique_ptr<GameObject>& object : m_Asset.scene.objects())
            {
                if (object->name == name)
                {
                    chosen.push_back(object.get());
                }
            }
            if (chosen.size() == before)
            {
                diagnostics.Error({}, "unknown object " + UnknownName(name, NamesLike(name)));
            }
        }
        if (!diagnostics.hasErrors())
        {
            m_Controller.Select(chosen, 0.0);
        }
    }

    /// Returns the names that an unknown name may stand for: all names if one is near; otherwise
    /// those that contain it; otherwise those of objects without a parent.
    std::vector<std::string_view> NamesLike(const std::string& name) const
    {
        std::vector<std::string_view> all;
        std::vector<std::string_view> longer;
        std::vector<std::string_view> roots;
        for (const std::unique_ptr<GameObject>& object : m_Asset.scene.objects())
        {
            all.push_back(object->name);
            if (ToLower(object->name).find(ToLower(name)) != std::string::npos)
            {
                longer.push_back(object->name);
            }
            if (!object->transform.parent)
            {
                roots.push_back(object->name);
            }
        }
        if (!NearestName(name, all).empty())
        {
            return all;
        }
        return longer.empty() || name.empty() ? roots : longer;
    }

    void Click(const SelectionStep& step, AssetDiagnostics& diagnostics)
    {
        const ClickText click = ParseClick(step.text).value_or(ClickText{-1, -1, 0.0});
        const int width = m_Asset.width;
        const int height = m_Asset.height;
        if (const std::string problem = PixelProblem(click, width, height); !problem.empty())
        {
            diagnostics.Error({}, problem);
            return;
        }
        TurnObjects(m_Asset.turns, click.time);
        GameObject* hit = m_Controller.GetHitObj(m_Asset.camera, width, height, click.x, click.y);
        m_Controller.Click(hit, step.kind == SelectionStep::Kind::CtrlClick, click.time);
        if (!hit)
        {
            m_Asset.notes.push_back({Severity::Note, OptionOf(step), {}, WhyNothing(click)});
        }
    }

    std::string WhyNothing(const ClickText& click)
    {
        const std::optional<RaycastHit> seen =
            m_Controller.Raycast(m_Asset.camera, m_Asset.width, m_Asset.height, click.x, click.y);
        const std::string nothing = "; nothing is selected now";
        if (!seen)
        {
            return "there is no object there" + nothing;
        }
        const int layer = seen->gameObject->layer;
        const std::string& name = m_Asset.layers.Name(layer);
        return "'" + seen->gameObject->name + "' is there, whose layer, " +
               (name.empty() ? std::to_string(layer) : name) +
               ", is in no layer mask of a feature that shows a selection" + nothing;
    }

    SceneAsset& m_Asset;
    SelectController m_Controller;
};

} // namespace

FilterFinder::FilterFinder(ScriptableRendererFeature& feature, bool needsNames)
    : m_NeedsNames(needsNames)
{
    DescribeFeature(feature, *this);
}

void FilterFinder::Field(const FieldInfo& field, FieldValue value)
{
    // A ported feature may have settings of these names and other types.
    LayerMask** layers = std::get_if<LayerMask*>(&value);
    const auto* index = std::get_if<RenderingLayerValue>(&value);
    RenderingLayerMask** renderingLayers = std::get_if<RenderingLayerMask*>(&value);
    const auto* choice = std::get_if<EnumValue>(&value);
    if (layers && (!m_NeedsNames || field.name == "m_LayerMask"))
    {
        filter.layerMask = **layers;
    }
    if ((index || renderingLayers) && (!m_NeedsNames || field.name == "m_RenderingLayerMask"))
    {
        filter.renderingLayerMask =
            index ? RenderingLayerMask::FromIndex(index->value) : **renderingLayers;
        hasRenderingLayers = true;
    }
    if (choice && field.name == "m_RenderQueueRange")
    {
        filter.renderQueueRange = QueuesOf(*choice);
    }
}

std::optional<ClickText> ParseClick(const std::string& text)
{
    const std::size_t comma = text.find(',');
    const std::size_t at = std::min(text.find('@'), text.size());
    if (comma == std::string::npos || comma > at)
    {
        return std::nullopt;
    }
    const std::string_view all = text;
    const auto x = ParseWhole<int>(all.substr(0, comma));
    const auto y = ParseWhole<int>(all.substr(comma + 1, at - comma - 1));
    const auto time = at == text.size() ? 0.0 : ParseWhole<double>(all.substr(at + 1));
    const bool isGood = x && y && time && std::isfinite(*time);
    return isGood ? std::optional(ClickText{*x, *y, *time}) : std::nullopt;
}

std::string PixelProblem(const ClickText& click, int width, int height)
{
    const bool isInside = click.x >= 0 && click.x < width && click.y >= 0 && click.y < height;
    return isInside ? ""
                    : "the pixel lies outside of the picture, which is " + std::to_string(width) +
                          "x" + std::to_string(height) + ": 0,0 is its top left and " +
                          std::to_string(width - 1) + "," + std::to_string(height - 1) +
                          " its bottom right";
}

void ApplySelection(SceneAsset& asset, std::span<const SelectionStep> steps)
{
    if (steps.empty())
    {
        return;
    }
    const SelectSettings settings = SettingsFor(asset.renderer);
    if (settings.renderingLayers.bits == 0)
    {
        throw AssetError(OptionOf(steps.front()), {},
                         "no feature of the scene draws the objects of a rendering layer other "
                         "than Default, so none would show the selection; an outline feature does "
                         "with m_RenderingLayerMask: Selected and, in the scene, "
                         "renderingLayers: {8: Selected}");
    }
    Selector selector(asset, settings);
    for (const SelectionStep& step : steps)
    {
        selector.Do(step);
    }
    SetStartTimes(asset);
}

} // namespace limn

#include "scene/RendererTable.h"

#include <algorithm>
#include <limn/base/NumberText.h>
#include <limn/core/Culling.h>
#include <limn/core/Material.h>
#include <limn/core/Shader.h>
#include <numeric>

namespace limn
{

namespace
{

// A verdict is one in a sum of counts side by side, which is added up without looking at it; that
// of what is drawn are the lowest bits.
constexpr int k_CountBits = 12;
constexpr std::size_t k_MostCounted = (1 << k_CountBits) - 1;
static_assert(k_CountBits * k_FilterVerdictCount <= 64 &&
              static_cast<int>(FilterVerdict::Drawn) == 0);

/// "the layer mask leaves out 2"
std::string RuleText(FilterVerdict verdict, int count)
{
    const std::string number = std::to_string(count);
    if (verdict == FilterVerdict::NoMatchingPass)
    {
        return number + (count == 1 ? " has" : " have") +
               " no pass with a LightMode that is asked for";
    }
    return std::string("the ") + ToString(verdict) +
           (verdict == FilterVerdict::QueueOutOfRange ? " range" : "") + " leaves out " + number;
}

} // namespace

const char* ToString(FilterVerdict verdict)
{
    constexpr const char* k_Names[k_FilterVerdictCount] = {"drawn", "render queue", "layer mask",
                                                           "rendering layer mask",
                                                           "no pass with a wanted LightMode"};
    return k_Names[static_cast<int>(verdict)];
}

FilterVerdict Judge(const FilterItem& item, const FilteringSettings& filtering,
                    const DrawingSettings& drawing)
{
    const FilterVerdict masks = JudgeMasks(item, filtering);
    if (masks != FilterVerdict::Drawn)
    {
        return masks;
    }
    for (const ShaderTagId tag : drawing.shaderTagIds)
    {
        if ((item.material != nullptr ? item.material->FindEnabledPassByLightMode(tag)
                                      : item.shader->FindPassByLightMode(tag)) >= 0)
        {
            return FilterVerdict::Drawn;
        }
    }
    return FilterVerdict::NoMatchingPass;
}

JudgedItems Judge(const RendererItems& items, const FilteringSettings& filtering,
                  const DrawingSettings& drawing)
{
    JudgedItems judged;
    if (items.empty())
    {
        return judged;
    }
    const RendererTable& table = *items.table();
    const BatchOrder& order = table.order();
    static thread_local std::vector<std::uint64_t> ofLooks;
    ofLooks.clear();
    for (const std::uint32_t index : order.classOfLook)
    {
        const RendererTable::DrawKey& kind = table.classes()[index];
        const FilterVerdict verdict =
            kind.material ? Judge(kind.item(), filtering, drawing) : FilterVerdict::Drawn;
        ofLooks.push_back(std::uint64_t{1} << k_CountBits * static_cast<int>(verdict));
    }
    std::vector<std::uint32_t> drawn = table.spareRows().Take(items.size());
    std::size_t count = 0;
    const std::uint32_t* classOf = table.classOf().data();
    const std::uint32_t* lookOf = order.looks.data(); // by class
    const std::uint64_t* ofLook = ofLooks.data();
    const std::vector<std::uint32_t>& rows = items.rows();
    for (std::size_t begin = 0; begin < rows.size(); begin += k_MostCounted)
    {
        const std::size_t end = std::min(begin + k_MostCounted, rows.size());
        std::uint64_t sum = 0;
        for (std::size_t i = begin; i < end; ++i)
        {
            const std::uint64_t verdict = ofLook[lookOf[classOf[rows[i]]]];
            sum += verdict;
            drawn[count] = rows[i];
            count += verdict & 1;
        }
        for (std::size_t v = 0; v < judged.counts.size(); ++v)
        {
            judged.counts[v] += static_cast<int>(sum >> k_CountBits * v & k_MostCounted);
        }
    }
    drawn.resize(count);
    judged.drawn = RendererItems(items.table(), std::move(drawn));
    return judged;
}

std::string Describe(const FilterCounts& counts, const FilteringSettings& filtering)
{
    const int total = std::accumulate(counts.begin(), counts.end(), 0);
    std::string text = std::to_string(counts[0]) + " of " +
                       CountText(static_cast<std::size_t>(total), "renderer") +
                       (total == 1 || counts[0] == 1 ? " is drawn" : " are drawn");
    std::vector<std::string> rules;
    for (std::size_t i = 1; i < counts.size(); ++i)
    {
        if (counts[i] != 0)
        {
            rules.push_back(RuleText(static_cast<FilterVerdict>(i), counts[i]));
        }
    }
    for (std::size_t i = 0; i < rules.size(); ++i)
    {
        text += (i == 0 ? ": " : i + 1 < rules.size() ? ", " : ", and ") + rules[i];
    }
    if (total == 0)
    {
        text += ": the camera sees no renderer at all";
    }
    if (filtering.layerMask == LayerMask::Nothing())
    {
        text += "; the filter's layerMask is 0 (Nothing)";
    }
    if (filtering.renderingLayerMask == RenderingLayerMask::Nothing())
    {
        text += "; the filter's renderingLayerMask is 0 (Nothing)";
    }
    return text;
}

} // namespace limn
